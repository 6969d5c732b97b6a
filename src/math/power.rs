//! Powers of `f32`, in single precision throughout.
//!
//! libm's `powf` is right to the last digit, for which it carries twice the digits, in several times the instructions.

use core::f32::consts::LN_2;

/// xʸ for 0 < x ≤ 1 and y ≥ 0: 1ʸ and x⁰ are 1. The relative error is at most 3 roundings, and 3 more for each factor of 2 that
/// the power is below 1. What is below 2⁻¹²⁶ is 0 as a power, and counts as about 2⁻¹²⁷ as x.
#[inline]
pub(super) fn power(x: f32, y: f32) -> f32 {
    power_of_two(y * binary_logarithm(x))
}

/// log₂ x, with a relative error of some roundings, however near to 1 x is.
///
/// x = 2ᵏ·m with √½ ≤ m < √2, and ln m = 2·artanh((m − 1)/(m + 1)), by the polynomial that meets it at Chebyshev's points,
/// within 2⁻³⁰.
#[inline(always)]
fn binary_logarithm(x: f32) -> f32 {
    const ROOT_OF_HALF: i32 = 0x3f35_04f3;
    let bits = x.to_bits().cast_signed();
    let k = (bits - ROOT_OF_HALF) >> 23;
    let m = f32::from_bits((bits - (k << 23)).cast_unsigned());
    let s = (m - 1.0) / (m + 1.0);
    let z = s * s;
    k as f32 + s * (2.885_39 + z * (0.961_798_84 + z * (0.576_715_2 + z * 0.431_717_7)))
}

/// 2ˣ for x ≤ 0: 2ⁿ·2ᶠ with |f| ≤ ½, the latter by the polynomial that meets it at 0 and, less 1 and by f, at Chebyshev's points,
/// within 2⁻²⁷.
#[inline(always)]
fn power_of_two(x: f32) -> f32 {
    if x < -126.0 {
        return 0.0;
    }
    let n = (x - 0.5) as i32;
    let f = x - n as f32;
    let slope = 0.055_503_57 + f * (0.009_618_083 + f * (0.001_339_086_3 + f * 0.000_154_531_63));
    let fraction = 1.0 + f * (LN_2 + f * (0.240_226_5 + f * slope));
    fraction * f32::from_bits(((n + 127) << 23).cast_unsigned())
}

#[cfg(test)]
mod tests {
    use super::power;
    use std::vec::Vec;

    /// `f64`'s is the independent source: from next to 1 to next to 0, by exponents of 24 decades.
    #[test]
    fn is_near_the_power_in_f64() {
        let (mut worst, mut count) = (0.0_f64, 0);
        let exponents: Vec<f32> = (-60..=60).map(|i| 10_f32.powf(i as f32 / 5.0)).collect();
        for i in 0..200_000_u32 {
            let ulps = (1.000_103_9_f64.powf(f64::from(i)) - 1.0 + f64::from(i)) as u32;
            let x = f32::from_bits(1_f32.to_bits().saturating_sub(ulps).max(f32::MIN_POSITIVE.to_bits()));
            for &y in exponents.iter().skip(i as usize % 8).step_by(8) {
                let exact = f64::from(x).powf(f64::from(y));
                if exact < 1.2e-38 {
                    continue;
                }
                let error = (f64::from(power(x, y)) / exact - 1.0).abs() * 2_f64.powi(24);
                worst = worst.max(error / (1.0 - exact.log2()));
                count += 1;
            }
        }
        assert!(worst <= 3.0 && count > 1_000_000, "{worst} roundings, {count} powers");
    }

    #[test]
    fn ones_and_zeros() {
        for x in [1.0, 0.5, 1e-3, f32::MIN_POSITIVE, 1e-44] {
            assert_eq!(power(x, 0.0), 1.0);
            assert_eq!(power(1.0, x), 1.0);
        }
        assert_eq!(power(1.0, 1e12), 1.0);
        assert_eq!(power(0.5, 127.0), 0.0);
        assert_eq!(power(1e-44, 1e12), 0.0);
        assert!(power(1e-44, 0.01) > 0.3);
    }
}
