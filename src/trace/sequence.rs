//! A low-discrepancy sequence that needs no state: a function of pixel, sample and dimension.

use crate::math::Real;

/// The sample points of one pixel.
///
/// Kronecker's sequence: coordinate j of point i is the fractional part of sⱼ + i·αⱼ, with the square roots of the
/// primes for αⱼ (Richtmyer's choice: no two coordinates, and no several of them, fall into step) and a start sⱼ that
/// is a hash of pixel and dimension. In integers alone, so the same on every target; one multiplication a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    seed: u32,
}

/// √p modulo 1 as fractions of 2³², two a dimension, for the primes 2 and 3, 5 and 11, 13 and 73, 7 and 43, 59 and 67,
/// 29 and 89, 23 and 97, 19 and 41: pairs that also make even planes for the first thousand points.
const STEPS: [[u32; 2]; 8] = [
    [0x6a09_e667, 0xbb67_ae85],
    [0x3c6e_f372, 0x510e_527f],
    [0x9b05_688c, 0x8b43_d457],
    [0xa54f_f53a, 0x8eb4_4a87],
    [0xae5f_9156, 0x2f73_477d],
    [0x629a_292a, 0x6f19_6331],
    [0xcbbb_9d5d, 0xd94e_beb1],
    [0x5be0_cd19, 0x6733_2667],
];

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
    pub fn bits(self, index: u32, dimension: u32) -> [u32; 2] {
        let start = mix(self.seed ^ dimension.wrapping_mul(0x9e37_79b9));
        let other = start.wrapping_mul(0x2c1b_3c6d);
        let [x, y] = steps(dimension);
        [start.wrapping_add(index.wrapping_mul(x)), other.wrapping_add(index.wrapping_mul(y))]
    }

    /// Point `index` of a dimension in [0, 1)².
    #[inline]
    #[must_use]
    pub fn point<T: Real>(self, index: u32, dimension: u32) -> [T; 2] {
        self.bits(index, dimension).map(T::fraction)
    }
}

/// The steps of a dimension. Past the table they are like those of a light near the eye, but for up to a 128th, so that
/// the two part after some points.
#[inline]
fn steps(dimension: u32) -> [u32; 2] {
    let (row, away) = if dimension < 8 { (dimension, 0) } else { (2 + dimension % 6, mix(dimension)) };
    let [x, y] = STEPS.get(row as usize).copied().unwrap_or_default();
    [x.wrapping_add(away >> 7), y.wrapping_add(away.rotate_left(16) >> 7)]
}

/// An integer hash (Ellis's lowbias32).
#[inline]
pub(super) const fn mix(x: u32) -> u32 {
    let x = (x ^ (x >> 16)).wrapping_mul(0x7feb_352d);
    let x = (x ^ (x >> 15)).wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error of the mean of a function over n samples of many pixels, in units of that of random samples.
    fn error(n: u32, mean: f64, f: impl Fn(Sequence, u32) -> bool) -> f64 {
        let squares = (0..200).map(|pixel| {
            let sequence = Sequence::new(pixel * 7, pixel * 13 + 1);
            let hits = (0..n).filter(|&index| f(sequence, index)).count();
            (hits as f64 / f64::from(n) - mean).powi(2)
        });
        (squares.sum::<f64>() / 200.0 * f64::from(n) / (mean * (1.0 - mean))).sqrt()
    }

    #[test]
    fn steps_are_square_roots_of_primes() {
        let primes = [2, 3, 5, 11, 13, 73, 7, 43, 59, 67, 29, 89, 23, 97, 19, 41];
        for (step, prime) in STEPS.as_flattened().iter().zip(primes) {
            assert_eq!(*step, (f64::from(prime).sqrt().fract() * 4_294_967_296.0) as u32, "{prime}");
        }
    }

    /// Below a line, and in a disc, of each of the dimensions; those past the table need only not fail.
    #[test]
    fn every_dimension_beats_random_samples() {
        for dimension in [0, 1, 2, 3, 4, 5, 6, 7, 8, 40] {
            for (n, most) in [(16, 0.9), (64, 0.9), (1024, 0.8)] {
                let most = if dimension < 8 { most } else { 2.0 };
                let line = |s: Sequence, i| s.point::<f64>(i, dimension).iter().sum::<f64>() < 1.0;
                let disc =
                    |s: Sequence, i| s.point::<f64>(i, dimension).map(|x| (x - 0.5).powi(2)).iter().sum::<f64>() < 0.16;
                let (line, disc) = (error(n, 0.5, line), error(n, 0.16 * core::f64::consts::PI, disc));
                assert!(line < most && disc < most, "dimension {dimension}, {n} points: {line} {disc}");
            }
        }
    }

    /// Six numbers from three dimensions together, as a soft shadow out of focus has them: their sum is above 3 half
    /// of the time. A sequence whose dimensions are in step never gets there.
    #[test]
    fn dimensions_are_independent() {
        for (n, most) in [(64, 0.9), (1024, 0.7), (16_384, 0.5)] {
            let sum = |s: Sequence, i| (0..3).flat_map(|d| s.point::<f64>(i, d)).sum::<f64>() > 3.0;
            let error = error(n, 0.5, sum);
            assert!(error < most, "{n} points: {error}");
        }
    }
}
