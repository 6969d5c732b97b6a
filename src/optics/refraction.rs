//! Snell's law.

use crate::math::{Real, Twofold, Vec3};

/// cos θ₂ behind an interface, by Snell's law n₁·sin θ₁ = n₂·sin θ₂; `None` on total internal reflection.
///
/// `n1` and `n2` are the indices of refraction on the side of the incident ray and behind; `cosine` is cos θ₁, from 0
/// to 1.
#[must_use]
pub fn transmitted_cosine<T: Real>(n1: T, n2: T, cosine: T) -> Option<T> {
    let (n, m) = ratio(n1, n2);
    Some(normal_part(n1, n2, (n, m), cosine)? / n)
}

/// n = n₂/n₁ and m = n² − 1, which keeps its digits for nearly equal indices.
#[inline]
pub(super) fn ratio<T: Real>(n1: T, n2: T) -> (T, T) {
    let inverse = T::ONE / n1;
    (n2 * inverse, (n2 - n1) * inverse * ((n2 + n1) * inverse))
}

/// g = n·cos θ₂ = √(n² − 1 + c²) for n = n₂/n₁ and m = n² − 1; `None` where the radicand is negative.
///
/// The radicand is n² − sin²θ₁ or m + c², whichever keeps more digits. Near the critical angle both cancel; there it is
/// worked out in twice the digits, so that rounding neither makes a total reflection nor hides one.
pub(super) fn normal_part<T: Real>(n1: T, n2: T, (n, m): (T, T), cosine: T) -> Option<T> {
    let (whole, rest) =
        if n * n < T::HALF { (n * n, (cosine - T::ONE) * (cosine + T::ONE)) } else { (cosine * cosine, m) };
    let mut radicand = whole + rest;
    // In fixed point nothing is lost where the two cancel.
    if !T::IS_FIXED && radicand.abs() < whole * T::from_f32(1.0 / 64.0) {
        radicand = near_critical(n1, n2, cosine);
    }
    if radicand < T::ZERO { None } else { Some(radicand.sqrt()) }
}

/// (n₂² − n₁²(1 − c²))/n₁²
#[cold]
#[inline(never)]
fn near_critical<T: Real>(n1: T, n2: T, cosine: T) -> T {
    let [dense, thin, cosine, one] = [n1, n2, cosine, T::ONE].map(|x| Twofold::difference(x, T::ZERO));
    (thin * thin - dense * dense * (one - cosine * cosine)).rounded() / (n1 * n1)
}

/// The sine of the critical angle, n₂/n₁: light that comes at a larger angle from inside n₁ is reflected totally.
/// `None` when no angle is, because behind is the denser side.
#[inline]
#[must_use]
pub fn critical_sine<T: Real>(n1: T, n2: T) -> Option<T> {
    if n1 > n2 { Some(n2 / n1) } else { None }
}

/// The refracted direction η·D + (η·c₁ − c₂)·N for unit `incident` and `normal`.
///
/// `ratio` is η = n₁/n₂, `cosine` is c₁ = −D·N, and `transmitted_cosine` is c₂, of the function of that name.
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
                let cosine = transmitted_cosine(n1, n2, angle.cos()).unwrap();
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
        assert_eq!(transmitted_cosine(1.5, 1.0, (critical + 1e-6).cos()), None);
        assert!(transmitted_cosine(1.5, 1.0, (critical - 1e-6).cos()).is_some());
        assert_eq!(critical_sine(1.5, 1.0).map(f64::asin), Some(critical));
        assert_eq!(critical_sine(1.0, 1.5), None);
    }
}
