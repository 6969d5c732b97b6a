//! The law of reflection.

use crate::math::{Real, Vec3};

/// The mirrored direction F = D + 2·c·N of the unit direction `incident` at the unit `normal`; c = −D·N is `cosine`.
///
/// It has the length of `incident` up to rounding; a chain of reflections has to normalise it.
#[inline]
#[must_use]
pub fn reflect<T: Real>(incident: Vec3<T>, normal: Vec3<T>, cosine: T) -> Vec3<T> {
    incident + normal * (cosine + cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_out_is_angle_in() {
        let (d, n) = (Vec3::new(0.6_f64, -0.8, 0.0), Vec3::new(0.0, 1.0, 0.0));
        assert_eq!(reflect(d, n, -d.dot(n)), Vec3::new(0.6, 0.8, 0.0));
    }
}
