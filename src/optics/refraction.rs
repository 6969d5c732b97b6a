//! Snell's law.

use crate::math::{Real, Vec3};

/// cos²θ₂ = 1 − η²(1 − c²), by Snell's law sin θ₂ = η·sin θ₁; below zero on total internal reflection.
///
/// `ratio` is η = n₁/n₂ and `cosine` is c = cos θ₁.
#[inline]
#[must_use]
pub fn transmitted_cosine_squared<T: Real>(ratio: T, cosine: T) -> T {
    T::ONE - ratio * ratio * (T::ONE - cosine * cosine)
}

/// The refracted direction η·D + (η·c₁ − c₂)·N for unit `incident` and `normal`.
///
/// `ratio` is η = n₁/n₂, `cosine` is c₁ = −D·N, and `transmitted_cosine` is c₂ = √(1 − η²(1 − c₁²)), which exists
/// unless all light is reflected: see [`transmitted_cosine_squared`].
#[inline]
#[must_use]
pub fn refract<T: Real>(incident: Vec3<T>, normal: Vec3<T>, ratio: T, cosine: T, transmitted_cosine: T) -> Vec3<T> {
    incident * ratio + normal * (ratio * cosine - transmitted_cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sines on both sides, worked out from the directions, obey Snell's law.
    #[test]
    fn sines_obey_snell() {
        let normal = Vec3::new(0.0, 0.0, 1.0);
        for (n1, n2) in [(1.0_f64, 1.5), (1.5, 1.0), (1.0, 2.4), (1.3, 1.3)] {
            for degrees in 0..40 {
                let angle = f64::from(degrees).to_radians();
                let incident = Vec3::new(angle.sin(), 0.0, -angle.cos());
                let ratio = n1 / n2;
                let cosine = transmitted_cosine_squared(ratio, angle.cos()).sqrt();
                let refracted = refract(incident, normal, ratio, angle.cos(), cosine);
                assert!((refracted.length() - 1.0).abs() < 1e-12);
                assert!((n1 * angle.sin() - n2 * refracted.x).abs() < 1e-12);
                assert!(refracted.z < 0.0);
            }
        }
    }

    #[test]
    fn beyond_the_critical_angle_there_is_no_transmission() {
        let critical = (1.0_f64 / 1.5).asin();
        assert!(transmitted_cosine_squared(1.5, (critical + 1e-6).cos()) < 0.0);
        assert!(transmitted_cosine_squared(1.5, (critical - 1e-6).cos()) > 0.0);
    }
}
