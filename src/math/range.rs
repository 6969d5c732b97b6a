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
    /// The largest thickness of a film in nanometres.
    pub thickness: f32,
    /// What is expected of a coordinate, in words.
    pub coordinate_text: &'static str,
    /// What is expected of an amount, in words.
    pub amount_text: &'static str,
    /// What is expected of the thickness of a film, in words.
    pub thickness_text: &'static str,
}

impl Range {
    /// The range of numbers with so many bits of fraction, from 12 to 20.
    #[cfg(feature = "fixed")]
    pub(super) const fn of_fraction(bits: u32) -> Self {
        let (coordinate_text, amount_text, thickness_text) = match bits {
            12 => ("a number from -16384 to 16384", "a number from 0 to 256", "a thickness of at most 245760 nm"),
            13 => ("a number from -8192 to 8192", "a number from 0 to 128", "a thickness of at most 122880 nm"),
            14 => ("a number from -4096 to 4096", "a number from 0 to 128", "a thickness of at most 61440 nm"),
            15 => ("a number from -2048 to 2048", "a number from 0 to 64", "a thickness of at most 30720 nm"),
            16 => ("a number from -1024 to 1024", "a number from 0 to 64", "a thickness of at most 15360 nm"),
            17 => ("a number from -512 to 512", "a number from 0 to 32", "a thickness of at most 7680 nm"),
            18 => ("a number from -256 to 256", "a number from 0 to 32", "a thickness of at most 3840 nm"),
            19 => ("a number from -128 to 128", "a number from 0 to 16", "a thickness of at most 1920 nm"),
            _ => ("a number from -64 to 64", "a number from 0 to 16", "a thickness of at most 960 nm"),
        };
        let coordinate = (1_u32 << (26 - bits)) as f32;
        Self {
            coordinate,
            // The largest number is 2^(30 − bits): an amount, and twice one.
            amount: (1_u32 << ((28 - bits) / 2)) as f32,
            thickness: 15.0 * coordinate,
            coordinate_text,
            amount_text,
            thickness_text,
        }
    }
}
