//! The floor, in integers.

/// The largest integer that is not above x.
#[inline]
pub(super) fn floor(x: f32) -> f32 {
    let bits = x.to_bits();
    let exponent = (bits >> 23 & 0xff).wrapping_sub(127);
    if exponent >= 23 {
        // Without fractions, or below 1.
        return if (exponent as i32) < 0 { floor_of_small(x) } else { x };
    }
    let fraction = 0x007f_ffff >> exponent;
    if bits & fraction == 0 {
        return x;
    }
    // A carry goes to the exponent.
    let bits = if bits >> 31 == 1 { bits + fraction } else { bits };
    f32::from_bits(bits & !fraction)
}

#[inline(always)]
fn floor_of_small(x: f32) -> f32 {
    if x.to_bits() > 0x8000_0000 { -1.0 } else { 0.0 }
}
