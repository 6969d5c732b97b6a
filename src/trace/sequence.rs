//! A low-discrepancy sequence that needs no state: a function of pixel, sample and dimension.

use crate::math::Real;

/// The sample points of one pixel.
///
/// Sobol's two-dimensional sequence, its order shuffled by an Owen scramble that differs from pixel to pixel and from
/// dimension to dimension, and its digits flipped at random (Burley, "Practical Hash-based Owen Scrambling", JCGT
/// 2020). The first 2ᵏ points of a dimension are a (0, k, 2)-net: every elementary interval of area 2⁻ᵏ holds one.
/// Integers alone, so the same on every target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    seed: u32,
}

impl Sequence {
    /// The position within the pixel.
    pub const PIXEL: u32 = 0;
    /// The position within the aperture of the lens.
    pub const LENS: u32 = 1;
    /// The first of the dimensions that sample lights: see [`Sequence::light`].
    const LIGHTS: u32 = 2;

    /// The sequence of the pixel in column `x` of row `y`.
    #[inline]
    #[must_use]
    pub const fn new(x: u32, y: u32) -> Self {
        Self { seed: mix(x ^ mix(y)) }
    }

    /// The dimension for light `index` out of `count`, seen from a surface point that a branch of `depth` met.
    #[inline]
    #[must_use]
    pub const fn light(depth: u32, index: u32, count: u32) -> u32 {
        Self::LIGHTS.wrapping_add(depth.wrapping_mul(count)).wrapping_add(index)
    }

    /// Point `index` of a dimension, as fractions of 2³².
    #[inline]
    #[must_use]
    pub const fn bits(self, index: u32, dimension: u32) -> [u32; 2] {
        let seed = mix(self.seed ^ dimension.wrapping_mul(0x9e37_79b9));
        // Reversed, the shuffled index is the first coordinate; the second is its product with Pascal's triangle
        // modulo 2, worked out by doubling steps.
        let x = scramble(index.reverse_bits(), seed);
        let mut y = x;
        y ^= y >> 16;
        y ^= (y & 0xff00_ff00) >> 8;
        y ^= (y & 0xf0f0_f0f0) >> 4;
        y ^= (y & 0xcccc_cccc) >> 2;
        y ^= (y & 0xaaaa_aaaa) >> 1;
        let flips = seed.wrapping_mul(0x2c1b_3c6d);
        [x ^ flips, y ^ flips.rotate_left(16)]
    }

    /// Point `index` of a dimension in [0, 1)².
    #[inline]
    #[must_use]
    pub fn point<T: Real>(self, index: u32, dimension: u32) -> [T; 2] {
        // 24 bits are exact in every number type.
        self.bits(index, dimension).map(|bits| T::from_u32(bits >> 8) * T::from_f32(1.0 / 16_777_216.0))
    }
}

/// An integer hash (Ellis's lowbias32).
#[inline]
const fn mix(x: u32) -> u32 {
    let x = (x ^ (x >> 16)).wrapping_mul(0x7feb_352d);
    let x = (x ^ (x >> 15)).wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// Owen's scramble of a bit-reversed number, in which each bit depends only on the bits below it
/// (Laine and Karras 2011, with the constants of Vegdahl).
#[inline]
const fn scramble(x: u32, seed: u32) -> u32 {
    let x = x ^ x.wrapping_mul(0x3d20_adea);
    let x = x.wrapping_add(seed);
    let x = x.wrapping_mul((seed >> 16) | 1);
    let x = x ^ x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every way to cut the square into 2ᵏ equal boxes puts one of the first 2ᵏ points into each box.
    #[test]
    fn prefixes_are_nets() {
        for (pixel, dimension) in [(0, 0), (77, 1), (1234, 5)] {
            let sequence = Sequence::new(pixel, pixel / 3);
            for k in 1..=10 {
                for split in 0..=k {
                    let mut seen = std::vec![false; 1 << k];
                    for index in 0..1 << k {
                        let [x, y] = sequence.bits(index, dimension).map(u64::from);
                        let cell = ((x << split) >> 32 << (k - split)) | ((y << (k - split)) >> 32);
                        assert!(!core::mem::replace(&mut seen[cell as usize], true), "{k} {split} {index}");
                    }
                }
            }
        }
    }

    /// Pairs of dimensions are unrelated: their first coordinates have next to no correlation over many pixels.
    #[test]
    fn dimensions_are_independent() {
        let mut sum = 0.0;
        for i in 0..40_000 {
            let sequence = Sequence::new(i % 200, i / 200);
            let [a, _] = sequence.point::<f64>(i % 4, 0);
            let [b, _] = sequence.point::<f64>(i % 4, 1);
            sum += (a - 0.5) * (b - 0.5) * 12.0;
        }
        assert!((sum / 40_000.0_f64).abs() < 0.02, "{sum}");
    }
}
