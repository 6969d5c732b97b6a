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

/// The tangent of an angle in degrees, |angle| < 90, in constant evaluation.
///
/// Cameras are mostly constants; this keeps the `f64` trigonometry in the compiler and out of the binary.
pub const fn tangent_of_degrees(angle: f64) -> f64 {
    let x = angle * core::f64::consts::PI / 180.0;
    let (mut sine, mut cosine) = (0.0, 0.0);
    let mut term = 1.0;
    let mut n = 0;
    // The Taylor series at |x| < π/2: the 30th term is below 1e-26.
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
    sine / cosine
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
    fn tangent_agrees_with_std() {
        for tenths in 0..895 {
            let angle = f64::from(tenths) / 10.0;
            let expected = angle.to_radians().tan();
            assert!((tangent_of_degrees(angle) - expected).abs() <= 1e-12 * (1.0 + expected * expected), "{angle}");
        }
    }
}
