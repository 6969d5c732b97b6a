//! The little trigonometry a tracer needs, without `libm`'s (which computes in `f64`).

use super::Real;

/// Sine and cosine of `x` for |x| ≤ π/4, as `(sin, cos)`.
///
/// Taylor polynomials of degree 9 and 8. The truncation error is at most 2.5e-8, at π/4; in `f32` the whole error is
/// below 1.2e-7.
#[inline]
pub fn sin_cos_eighth<T: Real>(x: T) -> (T, T) {
    let c = T::from_f32;
    let s = x * x;
    let sine = T::ONE - s * (c(1.0 / 6.0) - s * (c(1.0 / 120.0) - s * (c(1.0 / 5040.0) - s * c(1.0 / 362_880.0))));
    let cosine = T::ONE - s * (T::HALF - s * (c(1.0 / 24.0) - s * (c(1.0 / 720.0) - s * c(1.0 / 40_320.0))));
    (x * sine, cosine)
}

/// Sine and cosine of 2π·`turns`, as `(sin, cos)`.
///
/// The range reduction is exact: turns are periodic in 1, and every step up to the multiplication by π/2 is a
/// subtraction without rounding. So the error does not grow with |turns|; it is below 2e-7 in `f32` and 3e-8 in `f64`.
/// From 2²³ on an `f32` holds whole turns only.
#[inline]
pub fn sin_cos_turns<T: Real>(turns: T) -> (T, T) {
    turns.sin_cos_turns()
}

/// The same by polynomials, for any number type.
#[inline]
pub(super) fn by_polynomials<T: Real>(turns: T) -> (T, T) {
    let c = T::from_f32;
    let magnitude = turns.abs();
    let mut x = magnitude - magnitude.floor();
    let lower_half = x >= T::HALF;
    if lower_half {
        x -= T::HALF;
    }
    // In quarters of a turn from here on, between 0 and 2.
    let mut x = c(4.0) * x;
    let second = x >= T::ONE;
    if second {
        x -= T::ONE;
    }
    let mirrored = x > T::HALF;
    if mirrored {
        x = T::ONE - x;
    }
    let (mut sine, mut cosine) = sin_cos_eighth(x * c(core::f32::consts::FRAC_PI_2));
    if mirrored {
        (sine, cosine) = (cosine, sine);
    }
    if second {
        (sine, cosine) = (cosine, -sine);
    }
    if lower_half {
        (sine, cosine) = (-sine, -cosine);
    }
    (if turns < T::ZERO { -sine } else { sine }, cosine)
}

/// The tangent of an angle in degrees, |angle| < 90, in constant evaluation.
///
/// Cameras are mostly constants; this keeps the `f64` trigonometry in the compiler and out of the binary.
pub const fn tangent_of_degrees(angle: f64) -> f64 {
    let (sine, cosine) = sin_cos_constant(angle * core::f64::consts::PI / 180.0);
    sine / cosine
}

/// Sine and cosine of `x` for |x| ≤ π/2, as `(sin, cos)`, in constant evaluation.
pub(crate) const fn sin_cos_constant(x: f64) -> (f64, f64) {
    let (mut sine, mut cosine) = (0.0, 0.0);
    let mut term = 1.0;
    let mut n = 0;
    // The Taylor series at |x| ≤ π/2: the 30th term is below 1e-26.
    while n < 30 {
        match n % 4 {
            0 => cosine += term,
            1 => sine += term,
            2 => cosine -= term,
            _ => sine -= term,
        }
        n += 1;
        term = term * x / n as f64;
    }
    (sine, cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_agree_with_std() {
        let mut worst = 0.0_f64;
        for i in -1000..=1000 {
            let x = f64::from(i) / 1000.0 * core::f64::consts::FRAC_PI_4;
            let (sine, cosine) = sin_cos_eighth(x as f32);
            let x = f64::from(x as f32);
            worst = worst.max((f64::from(sine) - x.sin()).abs()).max((f64::from(cosine) - x.cos()).abs());
        }
        assert!(worst < 1.2e-7, "{worst:e}");
    }

    #[test]
    fn turns_agree_with_std() {
        let (mut worst, mut worst_wide) = (0.0_f64, 0.0_f64);
        let mut check = |turns: f32| {
            let x = f64::from(turns);
            let angle = (x - x.round()) * core::f64::consts::TAU;
            let (sine, cosine) = sin_cos_turns(turns);
            worst = worst.max((f64::from(sine) - angle.sin()).abs()).max((f64::from(cosine) - angle.cos()).abs());
            let (sine, cosine) = sin_cos_turns(x);
            worst_wide = worst_wide.max((sine - angle.sin()).abs()).max((cosine - angle.cos()).abs());
        };
        for i in -4000..=4000 {
            let x = i as f32;
            for turns in [x / 997.0, x / 64.0, x * 0.3137, x * 251.7] {
                check(turns);
            }
        }
        // Beside the seams between eighths.
        for eighth in -16..=16 {
            let seam = eighth as f32 / 8.0;
            for turns in [seam.next_down(), seam, seam.next_up(), 1000.0 + seam] {
                check(turns);
            }
        }
        assert!(worst < 2e-7, "{worst:e}");
        assert!(worst_wide < 3e-8, "{worst_wide:e}");
    }

    #[test]
    fn quarter_turns_are_exact() {
        for whole in [0.0_f32, 1.0, 999_999.0] {
            assert_eq!(sin_cos_turns(whole), (0.0, 1.0));
            assert_eq!(sin_cos_turns(whole + 0.25), (1.0, 0.0));
            assert_eq!(sin_cos_turns(whole + 0.5), (0.0, -1.0));
            assert_eq!(sin_cos_turns(-whole - 0.25), (-1.0, 0.0));
        }
    }

    #[test]
    fn tangent_agrees_with_std() {
        for tenths in 0..895 {
            let angle = f64::from(tenths) / 10.0;
            let expected = angle.to_radians().tan();
            assert!((tangent_of_degrees(angle) - expected).abs() <= 1e-12 * (1.0 + expected * expected), "{angle}");
        }
    }
}
