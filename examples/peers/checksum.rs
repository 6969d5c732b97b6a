//! A number that tells pictures apart.

/// The checksum of no bytes.
pub const START: u64 = 0xCBF2_9CE4_8422_2325;

/// That of the bytes before and of these: Fowler, Noll and Vo's FNV-1a in 64 bits.
pub fn checksum(before: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(before, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01B3))
}
