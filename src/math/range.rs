//! How large the numbers of a scene may be in fixed point.

/// How large the numbers of a scene may be, so that nothing that is computed from them overflows.
///
/// A point that light meets may lie eight times as far out as the largest coordinate, which leaves the sum of three squares of
/// the way to it within 64 bits. An amount times twice an amount, as of light times what a surface sends on of it, stays within
/// the number type.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// The largest coordinate or length.
    pub coordinate: f32,
    /// The largest intensity, colour or share of light.
    pub amount: f32,
    /// What is expected of a coordinate, in words.
    pub coordinate_text: &'static str,
    /// What is expected of an amount, in words.
    pub amount_text: &'static str,
}

impl Range {
    /// The range of numbers with so many bits of fraction, from 12 to 20.
    #[cfg(feature = "fixed")]
    pub(super) const fn of_fraction(bits: u32) -> Self {
        let (coordinate, amount, coordinate_text, amount_text) = match bits {
            12 => (16_384.0, 256.0, "a number of at most 16384", "a number from 0 to 256"),
            13 => (8192.0, 128.0, "a number of at most 8192", "a number from 0 to 128"),
            14 => (4096.0, 128.0, "a number of at most 4096", "a number from 0 to 128"),
            15 => (2048.0, 64.0, "a number of at most 2048", "a number from 0 to 64"),
            16 => (1024.0, 64.0, "a number of at most 1024", "a number from 0 to 64"),
            17 => (512.0, 32.0, "a number of at most 512", "a number from 0 to 32"),
            18 => (256.0, 32.0, "a number of at most 256", "a number from 0 to 32"),
            19 => (128.0, 16.0, "a number of at most 128", "a number from 0 to 16"),
            _ => (64.0, 16.0, "a number of at most 64", "a number from 0 to 16"),
        };
        Self { coordinate, amount, coordinate_text, amount_text }
    }
}
