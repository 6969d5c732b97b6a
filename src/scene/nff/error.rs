//! What is wrong with a file, and where.

use core::fmt;

/// What is wrong with a file, and in which line.
///
/// Its message reads like ``line 12: expected a number for `radius`, found `abc` ``.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NffError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub problem: Problem,
}

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Problem {
    /// A word that is not what belongs there, or an end too early.
    Unexpected {
        /// What belongs there.
        expected: &'static str,
        /// The field it belongs to, if it is a number.
        field: Option<&'static str>,
        /// What is there.
        found: Found,
    },
    /// Numbers that no scene may hold, or that do not go together.
    OutOfRange {
        /// The field.
        field: &'static str,
        /// What it must be.
        expected: &'static str,
    },
    /// More than there is memory for.
    NoRoom {
        /// `objects` or `lights` of the whole file, or `vertices` of one polygon.
        what: &'static str,
        /// How many there are.
        needed: usize,
        /// How many there is room for.
        room: usize,
    },
    /// Bytes that are not UTF-8.
    NotUtf8,
}

/// What stands in the place of something else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Found {
    /// A word.
    Word(Word),
    /// The end of the line.
    EndOfLine,
    /// The end of the file.
    EndOfFile,
}

/// The beginning of a word of the file: errors own what they quote, so that they outlive the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    start: heapless::String<24>,
    is_cut: bool,
}

impl Word {
    /// The word up to its 24th byte.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.start
    }
}

impl From<&str> for Word {
    fn from(word: &str) -> Self {
        let mut start = heapless::String::new();
        let is_cut = word.chars().any(|c| start.push(c).is_err());
        Self { start, is_cut }
    }
}

impl NffError {
    pub(super) fn unexpected(line: usize, expected: &'static str, found: Found) -> Self {
        Self { line, problem: Problem::Unexpected { expected, field: None, found } }
    }

    pub(super) fn in_field(line: usize, field: &'static str, expected: &'static str, found: Found) -> Self {
        Self { line, problem: Problem::Unexpected { expected, field: Some(field), found } }
    }

    /// From what the validation of scenes says.
    pub(super) fn out_of_range(line: usize) -> impl Fn((&'static str, &'static str)) -> Self {
        move |(field, expected)| Self { line, problem: Problem::OutOfRange { field, expected } }
    }

    pub(super) fn no_room(line: usize, what: &'static str, needed: usize, room: usize) -> Self {
        Self { line, problem: Problem::NoRoom { what, needed, room } }
    }
}

impl fmt::Display for NffError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.problem)
    }
}

impl core::error::Error for NffError {}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unexpected { expected, field: Some(field), found } => {
                write!(f, "expected {expected} for `{field}`, found {found}")
            }
            Self::Unexpected { expected, field: None, found } => write!(f, "expected {expected}, found {found}"),
            Self::OutOfRange { field, expected } => write!(f, "expected {expected} for `{field}`"),
            Self::NoRoom { what, needed, room } => write!(f, "{needed} {what}, but there is room for {room}"),
            Self::NotUtf8 => f.write_str("expected UTF-8 text"),
        }
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => write!(f, "`{word}`"),
            Self::EndOfLine => f.write_str("the end of the line"),
            Self::EndOfFile => f.write_str("the end of the file"),
        }
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.start)?;
        if self.is_cut { f.write_str("…") } else { Ok(()) }
    }
}
