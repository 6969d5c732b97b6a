//! Lines, words and numbers.

use core::str::{FromStr, SplitAsciiWhitespace};

use super::{Found, NffError};
use crate::math::{Rgb, Vec3};

/// The lines that have words, without their comments.
#[derive(Clone)]
pub(super) struct Lines<'t> {
    rest: core::str::Lines<'t>,
    /// Number of the line last read, blank ones counted.
    number: usize,
}

/// The rest of one line.
#[derive(Clone)]
pub(super) struct Line<'t> {
    pub(super) number: usize,
    words: SplitAsciiWhitespace<'t>,
}

impl<'t> Lines<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { rest: text.lines(), number: 0 }
    }

    /// The next line, which must be there.
    pub(super) fn expect(&mut self, expected: &'static str) -> Result<Line<'t>, NffError> {
        self.next().ok_or_else(|| NffError::unexpected(self.last_number(), expected, Found::EndOfFile))
    }

    /// Number of the line last read; an empty file ends in its line 1.
    pub(super) fn last_number(&self) -> usize {
        self.number.max(1)
    }
}

impl<'t> Iterator for Lines<'t> {
    type Item = Line<'t>;

    fn next(&mut self) -> Option<Line<'t>> {
        loop {
            let line = self.rest.next()?;
            self.number += 1;
            let words = line.split('#').next()?.split_ascii_whitespace();
            if words.clone().next().is_some() {
                return Some(Line { number: self.number, words });
            }
        }
    }
}

impl<'t> Line<'t> {
    pub(super) fn word(&mut self) -> Option<&'t str> {
        self.words.next()
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.words.clone().next().is_none()
    }

    /// A finite number.
    pub(super) fn number(&mut self, field: &'static str) -> Result<f32, NffError> {
        self.number_within(field, "a finite number", f32::is_finite)
    }

    /// A number that `accepts`; `expected` says which that are.
    pub(super) fn number_within(
        &mut self,
        field: &'static str,
        expected: &'static str,
        accepts: impl Fn(f32) -> bool,
    ) -> Result<f32, NffError> {
        let (word, number) = self.parse(field, "a number")?;
        if accepts(number) { Ok(number) } else { Err(self.misfit(field, expected, word)) }
    }

    /// A whole number of at least `least`; `expected` says so.
    pub(super) fn whole(&mut self, field: &'static str, expected: &'static str, least: u32) -> Result<u32, NffError> {
        let (word, number) = self.parse(field, expected)?;
        if number >= least { Ok(number) } else { Err(self.misfit(field, expected, word)) }
    }

    pub(super) fn vector(&mut self, [x, y, z]: [&'static str; 3]) -> Result<Vec3<f32>, NffError> {
        Ok(Vec3::new(self.number(x)?, self.number(y)?, self.number(z)?))
    }

    pub(super) fn point(&mut self) -> Result<Vec3<f32>, NffError> {
        self.vector(["x", "y", "z"])
    }

    pub(super) fn color(&mut self) -> Result<Rgb<f32>, NffError> {
        Ok(Rgb::new(self.number("r")?, self.number("g")?, self.number("b")?))
    }

    /// Nothing more may follow.
    pub(super) fn end(mut self) -> Result<(), NffError> {
        match self.word() {
            Some(word) => Err(NffError::unexpected(self.number, "the end of the line", Found::Word(word.into()))),
            None => Ok(()),
        }
    }

    fn parse<N: FromStr>(&mut self, field: &'static str, expected: &'static str) -> Result<(&'t str, N), NffError> {
        let line = self.number;
        let word = self.word().ok_or_else(|| NffError::in_field(line, field, expected, Found::EndOfLine))?;
        let number = word.parse().map_err(|_| self.misfit(field, expected, word))?;
        Ok((word, number))
    }

    fn misfit(&self, field: &'static str, expected: &'static str, found: &str) -> NffError {
        NffError::in_field(self.number, field, expected, Found::Word(found.into()))
    }
}
