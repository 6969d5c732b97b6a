//! Powers of 2 and of e, in integers.

/// 2ᶻ for z in 2⁻¹⁶; 0 where the result has not all digits, and infinity above.
///
/// The exponent is the whole part of z. For the rest f, 2ᶠ = 1 + f·P(f), with the P of degree 3 and P(1) = 1 whose largest
/// relative error is smallest, 3.4e-6 (by Lawson's iteration of least squares); two factors are larger by 1 for what the
/// shifts cut off.
#[inline(always)]
pub(super) fn power_of_two(z: i32) -> f32 {
    let (whole, f) = (z >> 16, z as u32 & 0xffff);
    if whole < -126 {
        return 0.0;
    }
    if whole > 127 {
        return f32::INFINITY;
    }
    let slope = 3410 + ((f * 888) >> 16);
    let slope = 15_820 + ((f * slope) >> 16);
    let slope = 45_420 + ((f * slope) >> 16);
    let exponent = (whole + 127) as u32;
    f32::from_bits((exponent << 23) + ((f * slope) >> 9))
}

/// eˣ, with a relative error of at most 5.6e-5, and of 3.4e-5 for |x| ≤ 10; 0 below the smallest normal number.
#[inline]
pub(super) fn exponential(x: f32) -> f32 {
    let bits = x.to_bits();
    let magnitude = bits & 0x7fff_ffff;
    // 2⁻¹⁸ at least, and less than 128.
    if magnitude.wrapping_sub(0x3680_0000) >= 0x0c80_0000 {
        return exponential_of_extreme(x);
    }
    let shift = 133 - (magnitude >> 23);
    let x = (magnitude & 0x007f_ffff | 0x0080_0000) >> shift; // In 2⁻¹⁷.
    // log₂ e − 1 in 2⁻¹⁷, for the upper part of x and for the lower.
    let more = (((x >> 8) * 58_025) >> 9) + (((x & 255) * 58_025) >> 17);
    let z = ((x + more + 1) >> 1) as i32;
    power_of_two(if bits >> 31 == 1 { -z } else { z })
}

/// Of numbers that are nearly 0, too large, or none.
#[cold]
fn exponential_of_extreme(x: f32) -> f32 {
    if x.abs() < 1.0 {
        1.0
    } else if x < 0.0 {
        0.0
    } else {
        x * f32::INFINITY
    }
}
