//! To and from floating-point numbers, and to integers.

use super::LARGEST;

/// The largest integer that is not above x.
#[inline(always)]
pub(crate) const fn floor(x: i32, frac: u32) -> i32 {
    x >> frac << frac
}

/// The nearest number, halves away from 0; 0 for what is not a number.
#[inline]
pub(crate) const fn from_f32(x: f32, frac: u32) -> i32 {
    let bits = x.to_bits();
    let exponent = (bits >> 23 & 0xff) as i32 + frac as i32 - 150;
    let significand = bits & 0x7f_ffff | 0x80_0000;
    let magnitude = if x.is_nan() || exponent < -24 {
        0
    } else if exponent < 0 {
        ((significand >> (-1 - exponent)) + 1) >> 1
    } else if exponent < 7 {
        significand << exponent
    } else {
        LARGEST as u32
    };
    let magnitude = if magnitude > LARGEST as u32 { LARGEST } else { magnitude as i32 };
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

/// The nearest `f32`.
#[inline]
pub(crate) const fn to_f32(x: i32, frac: u32) -> f32 {
    if x == 0 { 0.0 } else { f32::from_bits((x as f32).to_bits() - (frac << 23)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_numbers_come_from_f32() {
        for bits in (0..=u32::MAX).step_by(super::super::effort(131, 0).0) {
            let x = f32::from_bits(bits);
            for frac in [12, 16, 26] {
                let scaled = (f64::from(x) * f64::from(1 << frac)).round(); // Which is away from 0, as here.
                let nearest = scaled.clamp(-f64::from(LARGEST), f64::from(LARGEST)) as i32; // 0 for NaN
                assert_eq!(from_f32(x, frac), nearest, "{x:e}");
            }
        }
    }

    #[test]
    fn nearest_f32_come_from_numbers() {
        for x in (i32::MIN..=i32::MAX).step_by(super::super::effort(131, 0).0).chain([0, 1, -1, LARGEST, -LARGEST]) {
            for frac in [12, 16, 26] {
                assert_eq!(to_f32(x, frac), (f64::from(x) / f64::from(1 << frac)) as f32, "{x}");
                assert!(floor(x, frac) <= x && (x - floor(x, frac)) >> frac == 0 && floor(x, frac) % (1 << frac) == 0);
            }
        }
    }

    /// In constants, too.
    const HALF: i32 = from_f32(0.5, 16);

    #[test]
    fn constants_are_converted() {
        assert_eq!((HALF, from_f32(f32::NAN, 16), from_f32(f32::NEG_INFINITY, 16)), (1 << 15, 0, -LARGEST));
    }
}
