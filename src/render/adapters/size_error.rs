//! A buffer of the wrong length.

use core::fmt;

/// A buffer has the wrong length for the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SizeError {
    /// The length that is needed, in `unit`s; the greatest `u64` stands for any length above it.
    pub expected: u64,
    /// The length that was given, in `unit`s.
    pub found: usize,
    /// What the buffer consists of: `"bytes"` or `"pixels"`.
    pub unit: &'static str,
}

impl SizeError {
    /// The error for a buffer whose length is not the one that is needed.
    pub(super) fn check(expected: u64, found: usize, unit: &'static str) -> Result<(), Self> {
        // A length in memory always fits into 64 bits.
        if expected == found as u64 { Ok(()) } else { Err(Self { expected, found, unit }) }
    }
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { expected, found, unit } = self;
        write!(f, "the picture needs a buffer of {expected} {unit}, not of {found}")
    }
}

impl core::error::Error for SizeError {}

#[cfg(test)]
mod tests {
    use super::SizeError;

    #[test]
    fn text_says_what_is_needed_and_what_was_given() {
        let error = SizeError::check(12, 10, "bytes").unwrap_err();
        assert_eq!(std::format!("{error}"), "the picture needs a buffer of 12 bytes, not of 10");
    }
}
