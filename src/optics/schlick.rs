//! Schlick's approximation of the Fresnel equations (Schlick 1994, equation 15).

use super::transmitted_cosine;
use crate::math::Real;

/// Reflectance at normal incidence between two dielectrics, R₀ = ((n₁ − n₂)/(n₁ + n₂))².
#[inline]
#[must_use]
pub fn normal_reflectance<T: Real>(n1: T, n2: T) -> T {
    let r = (n1 - n2) / (n1 + n2);
    r * r
}

/// R = R₀ + (1 − R₀)(1 − cos θ)⁵. The error is at most 0.036 for glass when θ is the angle on the less dense side.
#[inline]
#[must_use]
pub fn schlick<T: Real>(r0: T, cosine: T) -> T {
    let m = (T::ONE - cosine).max(T::ZERO);
    let square = m * m;
    r0 + (T::ONE - r0) * (square * square * m)
}

/// Schlick's approximation between two dielectrics, as `(reflectance, cos θ₂)`; `None` on total internal reflection.
///
/// The angle taken is the one on the less dense side: leaving glass, the *transmitted* one, at which alone the
/// approximation reaches 1 at the critical angle.
#[must_use]
pub fn schlick_dielectric<T: Real>(n1: T, n2: T, cosine: T) -> Option<(T, T)> {
    if n1 == n2 {
        // The approximation would reflect along the interface.
        return Some((T::ZERO, cosine));
    }
    let transmitted = transmitted_cosine(n1, n2, cosine)?;
    let r0 = normal_reflectance(n1, n2);
    Some((schlick(r0, if n1 > n2 { transmitted } else { cosine }), transmitted))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_the_curve() {
        assert!((normal_reflectance(1.0_f64, 1.5) - 0.04).abs() < 1e-15);
        assert_eq!(schlick(0.04_f64, 0.0), 1.0);
        assert_eq!(schlick(0.04_f64, 1.0), 0.04);
    }

    /// Against the exact Fresnel equations, written out here.
    #[test]
    fn stays_near_fresnel_on_both_sides() {
        for (n1, n2) in [(1.0_f64, 1.5), (1.5, 1.0)] {
            for i in 1..1000 {
                let c1 = f64::from(i) / 1000.0;
                let Some((approximate, c2)) = schlick_dielectric(n1, n2, c1) else { continue };
                let s = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
                let p = (n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1);
                let exact = f64::midpoint(s * s, p * p);
                assert!((approximate - exact).abs() < 0.036, "{n1} {n2} {c1}: {approximate} {exact}");
            }
        }
    }
}
