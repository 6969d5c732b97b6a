//! Quotients.

use super::normalise::{normalised, normalised_wide};
use super::{IS_SMALL, LARGEST, signed};

/// a / b, the nearest number; halves go away from 0. a / 0 is the largest number of the sign of a, and 0 / 0 is 0.
#[inline(always)]
pub(crate) fn quotient(a: i32, b: i32, frac: u32) -> i32 {
    quotient_shifted(a, b, 31 - frac)
}

/// The same for wide numbers of equal fraction bits, below 2⁶²: within 2⁻²⁹ of the quotient, or the nearest number to such.
#[inline(always)]
pub(crate) fn ratio(a: i64, b: i64, frac: u32) -> i32 {
    ratio_shifted(a, b, 31 - frac)
}

#[inline(never)]
fn quotient_shifted(a: i32, b: i32, shift: u32) -> i32 {
    let is_negative = a ^ b < 0;
    if a == 0 {
        return 0;
    }
    if b == 0 {
        return signed(LARGEST as u32, is_negative);
    }
    let (a, a_shift) = normalised(a.unsigned_abs());
    let (b, b_shift) = normalised(b.unsigned_abs());
    signed(scaled(a >> 1, b >> 1, (shift + a_shift).wrapping_sub(b_shift) as i32), is_negative)
}

#[inline(never)]
fn ratio_shifted(a: i64, b: i64, shift: u32) -> i32 {
    let is_negative = a ^ b < 0;
    if a == 0 {
        return 0;
    }
    if b == 0 {
        return signed(LARGEST as u32, is_negative);
    }
    let (a, a_shift) = normalised_wide(a.unsigned_abs());
    let (b, b_shift) = normalised_wide(b.unsigned_abs());
    signed(scaled(a >> 1, b >> 1, (shift + a_shift).wrapping_sub(b_shift) as i32), is_negative)
}

/// a/b · 2^(31 − shift), the nearest number, for a and b from 2³⁰ to 2³¹.
#[inline(always)]
fn scaled(a: u32, b: u32, shift: i32) -> u32 {
    if shift < 1 {
        return LARGEST as u32;
    }
    let quotient = if IS_SMALL { by_reciprocal(a, b) } else { by_division(a, b) };
    let twice = quotient.checked_shr(shift as u32 - 1).unwrap_or(0);
    ((twice >> 1) + (twice & 1)).min(LARGEST as u32)
}

/// ⌊a/b · 2³¹⌋, for a and b from 2³⁰ to 2³¹, in three digits of 10, 10 and 11 bits.
///
/// A digit is the quotient by `b` with its low bits taken off, rounded up: it is never too large, and at most by one too
/// small, which the remainder has room for and the next digit makes good.
#[inline(always)]
fn by_division(a: u32, b: u32) -> u32 {
    let (coarse, finer) = ((b >> 10) + 1, (b >> 11) + 1);
    digits(a, b, |remainder| remainder / coarse, |remainder| remainder / finer)
}

/// The same without divisions: by 2⁴⁶/b of 16 bits.
#[inline(always)]
fn by_reciprocal(a: u32, b: u32) -> u32 {
    let reciprocal = reciprocal(b);
    digits(a, b, |r| ((r >> 15) * reciprocal) >> 21, |r| ((r >> 15) * reciprocal) >> 20)
}

#[inline(always)]
fn digits(a: u32, b: u32, ten: impl Fn(u32) -> u32, eleven: impl Fn(u32) -> u32) -> u32 {
    let first = ten(a);
    let remainder = (a << 10).wrapping_sub(first.wrapping_mul(b));
    let second = ten(remainder);
    let remainder = (remainder << 10).wrapping_sub(second.wrapping_mul(b));
    let third = eleven(remainder);
    let remainder = (remainder << 11).wrapping_sub(third.wrapping_mul(b));
    (((first << 10) + second) << 11) + third + u32::from(remainder >= b)
}

/// 2⁴⁶/b for b from 2³⁰ to 2³¹, from below and within 2⁻¹³: two steps of Newton's method from a straight line, each of which
/// squares the error.
#[inline(always)]
fn reciprocal(b: u32) -> u32 {
    let b = (b >> 15) + 1;
    // 24/17 − 8/17·x, which has a relative error of at most 1/17 in 1/x for x from 1 to 2.
    let line = 92_520 - ((b * 30_840) >> 15);
    let better = (line * (0_u32.wrapping_sub(b * line) >> 16)) >> 15;
    (better * (0_u32.wrapping_sub(b * better) >> 16)) >> 15
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(a: i128, b: i128, frac: u32) -> i32 {
        if b == 0 {
            return a.signum() as i32 * LARGEST;
        }
        let magnitude = ((a.abs() << (frac + 1)) / b.abs() + 1) / 2;
        (magnitude.min(i128::from(LARGEST)) * a.signum() * b.signum()) as i32
    }

    #[test]
    fn quotients_are_the_nearest_numbers() {
        let mut random = fastrand::Rng::with_seed(3);
        let check = |a: i32, b: i32| {
            for frac in [12, 16, 20, 26] {
                assert_eq!(quotient(a, b, frac), nearest(a.into(), b.into(), frac), "{a} {b} {frac}");
            }
        };
        for a in [i32::MIN, i32::MIN + 1, -65536, -1, 0, 1, 3, 65535, 65536, LARGEST, i32::MAX] {
            for b in [i32::MIN, i32::MIN + 1, -65536, -1, 0, 1, 3, 65535, 65536, LARGEST, i32::MAX] {
                check(a, b);
            }
        }
        for _ in 0..super::super::effort(1, 2_000_000).1 {
            check(random.i32(..) >> random.u32(0..31), random.i32(..) >> random.u32(0..31));
        }
    }

    #[test]
    fn the_reciprocal_is_within_its_bound() {
        let (mut least, mut most) = (f64::MAX, f64::MIN);
        for b in (1 << 30..1_u32 << 31).step_by(super::super::effort(97, 0).0) {
            let product = f64::from(reciprocal(b)) * f64::from(b) / 2_f64.powi(46);
            (least, most) = (least.min(product), most.max(product));
        }
        println!("reciprocal times number: {least} to {most}");
        assert!(1.0 - least < 2_f64.powi(-13) && most <= 1.0, "{least} {most}");
    }

    /// Both ways give the same, which is exact, also where the remainder is next to 0 or to the divisor.
    #[test]
    fn digits_are_exact() {
        let mut random = fastrand::Rng::with_seed(4);
        let check = |a: u32, b: u32| {
            let exact = ((u64::from(a) << 31) / u64::from(b)) as u32;
            assert_eq!((by_reciprocal(a, b), by_division(a, b)), (exact, exact), "{a} {b}");
        };
        for _ in 0..super::super::effort(1, 5_000_000).1 {
            let b = random.u32(1 << 30..1 << 31);
            check(random.u32(1 << 30..1 << 31), b);
            let quotient = random.u64(1 << 30..1 << 32);
            let near = ((quotient * u64::from(b)) >> 31) + random.u64(0..2);
            if (1 << 30..1 << 31).contains(&near) {
                check(near as u32, b);
            }
        }
        for b in (1 << 30..1_u32 << 31).step_by(super::super::effort(97, 0).0) {
            for a in [1 << 30, (1 << 31) - 1, b] {
                check(a, b);
            }
        }
    }

    #[test]
    fn ratios_are_as_good_as_said() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut worst = 0_f64;
        for _ in 0..super::super::effort(1, 1_000_000).1 {
            let mut one = || (random.i64(..) >> 1) >> random.u32(0..62);
            let (a, b) = (one(), one());
            for frac in [12, 16, 26] {
                let (found, exact) = (ratio(a, b, frac), nearest(a.into(), b.into(), frac));
                let error = (f64::from(found) - f64::from(exact)).abs() - 1.0;
                worst = worst.max(error / f64::from(exact).abs().max(1.0));
            }
        }
        println!("relative error beyond a unit in the last place: 2^{}", worst.log2());
        assert!(worst <= 2_f64.powi(-29), "{worst:e}");
        assert_eq!([ratio(5, 0, 16), ratio(-5, 0, 16), ratio(0, 0, 16), ratio(0, 5, 16)], [LARGEST, -LARGEST, 0, 0]);
    }
}
