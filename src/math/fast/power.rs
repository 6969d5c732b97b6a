//! Powers of any numbers, in integers.

use super::exponential::power_of_two;

/// xʸ for x ≥ 0.
///
/// It is 2 to the power of y·log₂ x. For x ≤ 1 and y ≥ 0, as in highlights, the absolute error is at most 2.2e-5.
#[inline]
pub(super) fn power(x: f32, y: f32) -> f32 {
    if x.to_bits().wrapping_sub(0x0080_0000) >= 0x7f00_0000 || !y.is_finite() {
        return special_power(x, y);
    }
    power_of_normal(x, y)
}

#[inline(always)]
fn power_of_normal(x: f32, y: f32) -> f32 {
    let (logarithm, digits) = logarithm(x.to_bits());
    let z = scaled(logarithm.unsigned_abs(), digits, y);
    power_of_two(if (logarithm < 0) != (y < 0.0) { -z } else { z })
}

/// log₂ x and the number of its binary digits behind the point: 31 for x from √½ to √2 and 23 for others, so that near 1
/// it is as good as elsewhere.
///
/// With m next to 1 and t = m − 1, log₂ m = t·P(t), with the P of degree 5 whose largest relative error is smallest, 7.4e-6
/// (by Lawson's iteration of least squares).
#[inline(always)]
fn logarithm(bits: u32) -> (i32, u32) {
    let exponent = bits.wrapping_sub(0x3f35_04f3) as i32 >> 23;
    let fraction = (bits & 0x007f_ffff) as i32;
    // t in 2⁻²⁴, from the format's significand, which is m or 2m.
    let is_below_one = bits.wrapping_sub((exponent as u32) << 23) < 0x3f80_0000;
    let t = if is_below_one { fraction - (1 << 23) } else { fraction << 1 };
    let (upper, lower) = (t >> 9, t & 511);
    let factor = 20_853 + ((upper * -13_513) >> 15);
    let factor = -24_018 + ((upper * factor) >> 15);
    let factor = 31_445 + ((upper * factor) >> 15);
    let factor = -47_265 + ((upper * factor) >> 15);
    let factor = 94_549 + ((upper * factor) >> 15);
    let rest = upper * factor + ((lower * factor) >> 9); // In 2⁻³¹.
    if exponent == 0 { (rest, 31) } else { ((exponent << 23) + (rest >> 8), 23) }
}

/// |y|·number in 2⁻¹⁶, at most 128, for a number with some digits behind the point.
#[inline(always)]
fn scaled(number: u32, digits: u32, y: f32) -> i32 {
    let bits = y.to_bits() & 0x7fff_ffff;
    let significand = ((bits & 0x007f_ffff | 0x0080_0000) + 128) >> 8; // In 2⁻¹⁵.
    let product = (number >> 16) * significand + (((number & 0xffff) * significand) >> 16);
    let shift = digits as i32 + 110 - (bits >> 23) as i32;
    let largest = 1 << 23;
    if shift > 31 || product == 0 {
        0
    } else if shift > 0 {
        (((product >> (shift - 1)) + 1) >> 1).min(largest) as i32
    } else if product > largest >> (-shift).min(31) {
        largest as i32
    } else {
        (product << -shift) as i32
    }
}

/// Where x is zero, infinity or has not all digits, or y is infinite, or one of them is no number.
#[cold]
fn special_power(x: f32, y: f32) -> f32 {
    if y == 0.0 || x == 1.0 {
        1.0
    } else if x.is_nan() || y.is_nan() || x < 0.0 {
        f32::NAN
    } else if y.is_infinite() || x == 0.0 || x.is_infinite() {
        if (x > 1.0) == (y > 0.0) { f32::INFINITY } else { 0.0 }
    } else {
        // 2⁻²⁴ʸ is taken out of the power.
        power_of_normal(x * 16_777_216.0, y) * power_of_normal(1.0 / 16_777_216.0, y)
    }
}
