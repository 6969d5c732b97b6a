//! Powers.

use super::LARGEST;
use super::exponential::{power_of_two, root_of_two};
use super::multiply::{high, product, unsigned_product};
use super::normalise::{normalised, normalised_wide};

/// xʸ for x ≥ 0, within 2 units in the last place where it is at most 1. x⁰ is 1; 0ʸ is 0, or the largest number for y < 0.
#[inline(never)]
pub(crate) fn power(x: i32, y: i32, frac: u32) -> i32 {
    if y == 0 {
        return 1 << frac;
    }
    if x <= 0 {
        return if y < 0 { LARGEST } else { 0 };
    }
    let log = binary_logarithm(x as u32, frac);
    if log == 0 {
        return 1 << frac;
    }
    let is_negative = (log < 0) ^ (y < 0);
    // |log| = top/2^(24 + zeros): the product has 31 digits, however close to 1 x is.
    let (top, zeros) = normalised_wide(log.unsigned_abs());
    let exponent = wide_shifted(unsigned_product(top, y.unsigned_abs()), zeros + frac - 8);
    let exponent = if is_negative { exponent.wrapping_neg() } else { exponent };
    power_of_two((exponent >> 32) as i32, exponent as u32, frac)
}

/// log₂ x times 2⁵⁶, with a relative error of about 2⁻²⁷.
///
/// x = 2ᵏ·2^(i/16)·(1 + z) with |z| < 0.0291. For x next to 1, i and k are 0 or i is 16 and k −1: z is then exact.
#[inline(always)]
fn binary_logarithm(x: u32, frac: u32) -> i64 {
    let (m, zeros) = normalised(x);
    let i = nearest_sixteenth(m);
    // z times 2³⁶.
    let z = if i == 0 {
        (m - (1 << 31)) << 5
    } else {
        (unsigned_product(m, root_of_two(16 - i)) >> 27) as u32 // 2⁶³, which stands for 1, is gone.
    } as i32;
    // log₂(1 + z)/z, by the polynomial that meets it at Chebyshev's points, within 2⁻³²; times 2³⁰.
    let slope = 1_549_082_005 + high(z, -48_408_809 + high(z, 2_017_034 + high(z, -94_617 + high(z, 4_731))));
    let sixteenths = (31 - zeros as i32 - frac as i32) * 16 + i as i32;
    (i64::from(sixteenths) << 52) + (product(z, slope) >> 10)
}

/// About 16·log₂(m/2³¹), from 0 to 16, for m from 2³¹.
#[inline(always)]
fn nearest_sixteenth(m: u32) -> u32 {
    let part = (m << 1) >> 24;
    // log₂(1 + p) is about p + 88/256·p·(1 − p).
    ((part << 8) + ((part * (256 - part) * 88) >> 8) + 2048) >> 12
}

/// x / 2^shift for 0 ≤ `shift` < 64.
#[inline(always)]
fn wide_shifted(x: u64, shift: u32) -> i64 {
    let (high, low) = ((x >> 32) as u32, x as u32);
    let s = shift & 31;
    let (high, low) = (high >> s, ((high << 1) << (31 - s)) | (low >> s));
    let (high, low) = if shift > 31 { (0, high) } else { (high, low) };
    ((u64::from(high) << 32) | u64::from(low)) as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(x: i32, y: i32, frac: u32) -> f64 {
        let one = f64::from(1 << frac);
        ((f64::from(x) / one).powf(f64::from(y) / one) * one).min(f64::from(LARGEST))
    }

    #[test]
    fn powers_are_as_good_as_said() {
        let mut random = fastrand::Rng::with_seed(8);
        for frac in [12, 16, 20, 26] {
            let (mut worst, mut relative) = ((0_f64, 0, 0), (0_f64, 0, 0));
            for _ in 0..super::super::effort(1, 1_000_000).1 {
                let x = if random.bool() {
                    (random.i32(0..i32::MAX) >> random.u32(0..30)).max(1)
                } else {
                    ((1 << frac) - (random.i32(0..1 << frac) >> random.u32(0..frac)) * random.i32(0..2)).max(1)
                };
                let y = random.i32(..) >> random.u32(0..31);
                let (found, exact) = (f64::from(power(x, y, frac)), exact(x, y, frac));
                let error = (found - exact).abs();
                if exact <= f64::from(1 << frac) {
                    if error > worst.0 {
                        worst = (error, x, y);
                    }
                } else if (error - 1.0) / exact > relative.0 {
                    relative = ((error - 1.0) / exact, x, y);
                }
            }
            println!("{frac} bits: {worst:?} units up to 1, 2^{} {relative:?} beyond a unit above", relative.0.log2());
            assert!(worst.0 < 2.0, "{frac} {worst:?} {relative:?}");
        }
    }

    #[test]
    fn powers_of_0_and_1() {
        for frac in [12, 16, 26] {
            let one = 1 << frac;
            for y in [i32::MIN, -5, -one, 1, 5, one, 1000, i32::MAX] {
                assert_eq!(power(one, y, frac), one);
                assert_eq!(power(0, y, frac), if y < 0 { LARGEST } else { 0 });
            }
            for x in [0, 1, one / 3, one - 1, one] {
                assert_eq!(power(x, 0, frac), one);
                assert_eq!(power(x, one, frac), x, "{x} {frac}");
            }
        }
    }
}
