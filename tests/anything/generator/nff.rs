//! Text that looks like Neutral File Format.

use std::fmt::Write;

use super::Source;
use super::span::{AMOUNT, INDEX, LENGTH, POSITIVE, SHARE, Span};

const WORDS: [&str; 20] = [
    "v",
    "b",
    "l",
    "f",
    "s",
    "c",
    "p",
    "pp",
    "from",
    "at",
    "up",
    "angle",
    "hither",
    "resolution",
    "#",
    "nan",
    "inf",
    "-",
    "é",
    "1e39",
];

/// A file of mostly right lines.
pub fn text(bytes: &[u8]) -> String {
    let source = &mut Source::new(bytes);
    let mut text = String::new();
    source.view(&mut text);
    for _ in 0..source.below(12) {
        source.entity(&mut text);
    }
    text
}

impl Source<'_> {
    fn view(&mut self, text: &mut String) {
        if self.once_in(32) {
            return;
        }
        line(text, "v", &[]);
        let eye = self.point();
        let (at, up) = (self.point(), self.direction());
        for (word, v) in [("from", eye), ("at", at), ("up", up)] {
            line(text, word, &[v.x, v.y, v.z]);
        }
        let angle = self.pick(&[40.0, 1.0, 90.0, 179.0, 1e-4, 179.9999], 45.0);
        line(text, "angle", &[angle]);
        line(text, "hither", &[1.0]);
        line(text, "resolution", &[1.0 + self.below(8) as f32, 1.0 + self.below(8) as f32]);
    }

    fn entity(&mut self, text: &mut String) {
        match self.below(16) {
            0 => {
                let color = self.numbers(AMOUNT, 3);
                line(text, "b", &color);
            }
            1 | 2 => {
                let v = self.vector();
                let color = if self.once_in(2) { self.numbers(AMOUNT, 3) } else { Vec::new() };
                line(text, "l", &[v, color].concat());
            }
            3..=6 => self.surface(text),
            7 | 8 => {
                let (v, radius) = (self.vector(), self.size(POSITIVE));
                line(text, "s", &[v, vec![radius]].concat());
            }
            9 | 10 => {
                line(text, "c", &[]);
                for _ in 0..2 {
                    let (v, radius) = (self.vector(), self.size(POSITIVE));
                    line(text, "", &[v, vec![radius]].concat());
                }
            }
            11 | 12 => self.polygon(text, false),
            13 => self.polygon(text, true),
            _ => self.nonsense(text),
        }
    }

    fn surface(&mut self, text: &mut String) {
        let mut numbers = self.numbers(AMOUNT, 3);
        numbers.extend([
            self.number(SHARE),
            self.number(SHARE),
            self.pick(&[0.0, 3.0, 50.0, 1e5, 1e12, 2.5], 1.0),
            self.number(SHARE),
            self.number(INDEX),
        ]);
        line(text, "f", &numbers);
    }

    fn polygon(&mut self, text: &mut String, is_patch: bool) {
        let corners = 3 + self.below(6);
        line(text, if is_patch { "pp" } else { "p" }, &[corners as f32]);
        for _ in 0..corners {
            let mut numbers = self.vector();
            if is_patch {
                let normal = self.direction();
                numbers.extend([normal.x, normal.y, normal.z]);
            }
            line(text, "", &numbers);
        }
    }

    fn nonsense(&mut self, text: &mut String) {
        for _ in 0..self.below(8) {
            let word = self.pick(&WORDS, "");
            let x = self.number(LENGTH);
            let written = if self.once_in(2) { write!(text, "{word} ") } else { write!(text, "{x} ") };
            written.unwrap_or_default();
        }
        text.push_str(self.pick(&["\n", "\r\n", " ", "#"], "\n"));
    }

    fn vector(&mut self) -> Vec<f32> {
        let v = self.point();
        vec![v.x, v.y, v.z]
    }

    fn numbers(&mut self, span: Span, count: usize) -> Vec<f32> {
        (0..count).map(|_| self.number(span)).collect()
    }
}

fn line(text: &mut String, word: &str, numbers: &[f32]) {
    text.push_str(word);
    for number in numbers {
        // Both ways of writing a number.
        let short = if number.abs() < 1e6 { write!(text, " {number}") } else { write!(text, " {number:e}") };
        short.unwrap_or_default();
    }
    text.push('\n');
}
