//! Ordered dithering: fewer levels with the right mean.

use crate::render::Pixel;

/// The rank, 0 to 63, of a place in the 8×8 index matrix of Bayer, "An optimum method for two-level rendition of
/// continuous-tone pictures", ICC 1973.
///
/// The matrix doubles in size by M' = [4M, 4M + 2; 4M + 3, 4M + 1]: each bit of x and y adds two bits, the lowest ones
/// of x and y the highest ones of the rank.
#[inline]
fn rank(x: u32, y: u32) -> u32 {
    let mixed = x ^ y;
    let quarter = |bit: u32| ((mixed >> bit) & 1) << 1 | ((y >> bit) & 1);
    quarter(0) << 4 | quarter(1) << 2 | quarter(2)
}

/// From an 8-bit value to 0..=`max`, which is at most 255: up or down by the place of the pixel, so that the mean over
/// 8×8 pixels is within 1/128 level of the value. 0 and 255 stay the ends of the scale.
#[inline]
pub(super) fn level(value: u8, max: u8, x: u32, y: u32) -> u8 {
    // value · max / 255 + (rank + 1/2) / 64, over the common denominator 255 · 128; what is added is below 1.
    let level = (u32::from(value) * u32::from(max) * 128 + (2 * rank(x, y) + 1) * 255) / (255 * 128);
    level as u8
}

/// Whether a pixel of a 1-bit screen is lit: of 8×8 pixels with the same luminance, from 0 to 1, that part is lit, to
/// 1/128.
#[inline]
pub(super) fn is_lit(pixel: &Pixel) -> bool {
    pixel.color.luminance() * 128.0 > (2 * rank(pixel.x, pixel.y) + 1) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn places() -> impl Iterator<Item = (u32, u32)> {
        (0..64).map(|i| (i % 8, i / 8))
    }

    /// The matrix as printed in Foley et al., "Computer Graphics: Principles and Practice", and elsewhere.
    #[test]
    fn ranks_are_the_printed_matrix() {
        #[rustfmt::skip]
        let printed = [
             0, 32,  8, 40,  2, 34, 10, 42,
            48, 16, 56, 24, 50, 18, 58, 26,
            12, 44,  4, 36, 14, 46,  6, 38,
            60, 28, 52, 20, 62, 30, 54, 22,
             3, 35, 11, 43,  1, 33,  9, 41,
            51, 19, 59, 27, 49, 17, 57, 25,
            15, 47,  7, 39, 13, 45,  5, 37,
            63, 31, 55, 23, 61, 29, 53, 21,
        ];
        for ((x, y), expected) in places().zip(printed) {
            assert_eq!(rank(x, y), expected, "({x}, {y})");
            assert_eq!(rank(x + 8, y + 1024), expected, "({x}, {y}) of another tile");
        }
    }

    #[test]
    fn levels_keep_the_mean() {
        for max in [31, 63] {
            for value in 0..=255u8 {
                let sum: u32 = places().map(|(x, y)| u32::from(level(value, max, x, y))).sum();
                let error = f64::from(sum) / 64.0 - f64::from(value) * f64::from(max) / 255.0;
                assert!(error.abs() <= 1.0 / 128.0 + 1e-12, "{value} of {max}: {error}");
            }
        }
    }

    #[test]
    fn levels_keep_black_and_white() {
        for (x, y) in places() {
            for max in [31, 63] {
                assert_eq!((level(0, max, x, y), level(255, max, x, y)), (0, max));
            }
        }
    }

    fn lit(light: f32) -> usize {
        places().filter(|&(x, y)| is_lit(&Pixel { x, y, cell: 1, color: Rgb::grey(light) })).count()
    }

    #[test]
    fn lit_pixels_keep_the_mean() {
        for step in 0..=1000 {
            let light = step as f32 / 1000.0;
            let error = lit(light) as f32 / 64.0 - light;
            assert!(error.abs() <= 1.0 / 128.0 + 1e-6, "{light}: {error}");
        }
    }

    #[test]
    fn light_out_of_range_is_dark_or_lit() {
        assert_eq!([-1.0, -0.0, 0.0, f32::NAN].map(lit), [0; 4]);
        assert_eq!([1.0, 7.0, f32::INFINITY].map(lit), [64; 3]);
    }
}
