//! A number that tells pictures apart to the last bit.

use whit::render::Pixel;

/// Of the linear values of pixels, in the order in which they come: Fowler, Noll and Vo's FNV-1a in 64 bits, over the
/// 32 bits of each channel at once.
///
/// The number that it starts with is put in when it is read, so that a variable without pixels is all zeros and takes no flash.
#[derive(Clone, Copy)]
pub struct Checksum(u64);

const START: u64 = 0xCBF2_9CE4_8422_2325;

impl Checksum {
    /// Of no pixels.
    pub const EMPTY: Self = Self(0);

    /// Takes another pixel in.
    pub fn add(&mut self, pixel: &Pixel) {
        for channel in [pixel.color.r, pixel.color.g, pixel.color.b] {
            self.0 = (self.value() ^ u64::from(channel.to_bits())).wrapping_mul(0x0000_0100_0000_01B3) ^ START;
        }
    }

    /// The number.
    pub fn value(self) -> u64 {
        self.0 ^ START
    }
}
