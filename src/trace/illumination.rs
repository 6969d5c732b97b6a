//! What arrives at a point from one light.

use crate::intersect::Ray;
use crate::math::{Real, Rgb, Vec3, sin_cos_eighth};
use crate::scene::{Effects, Emitter, Light};

/// Light on its way to a point, if nothing stands in between.
pub(crate) struct Illumination<T> {
    /// The ray to the light.
    pub ray: Ray<T>,
    /// How far it is; `T::MAX` for a light at infinity.
    pub distance: T,
    /// What arrives.
    pub color: Rgb<T>,
}

/// A kind of light the tracer leaves out, or one that is exactly at the point, gives nothing, nor does one that is behind the
/// surface with this normal.
pub(crate) fn illuminate<T: Real, const EFFECTS: u64>(
    light: &Light<T>,
    point: Vec3<T>,
    normal: Option<Vec3<T>>,
    sample: impl FnOnce() -> [T; 2],
) -> Option<Illumination<T>> {
    let effects = const { Effects::from_bits(EFFECTS) };
    let is_behind = |towards: Vec3<T>| normal.is_some_and(|normal| towards.products(normal) <= T::NOTHING);
    let position = match light.emitter {
        Emitter::Point { position } if effects.has(Effects::POINT_LIGHT) => position,
        Emitter::Sphere { center, radius } if effects.has(Effects::SPHERE_LIGHT) => {
            let (x, y) = concentric(sample());
            let (tangent, bitangent) = (center - point).normalized().tangents();
            center + (tangent * x + bitangent * y) * radius
        }
        Emitter::Parallelogram { corner, edge_u, edge_v } if effects.has(Effects::PARALLELOGRAM_LIGHT) => {
            let [s, t] = sample();
            corner + edge_u * s + edge_v * t
        }
        Emitter::Directional { towards } if effects.has(Effects::DIRECTIONAL_LIGHT) => {
            if is_behind(towards) {
                return None;
            }
            let ray = Ray { origin: point, direction: towards.normalized() };
            return Some(Illumination { ray, distance: T::MAX, color: light.color });
        }
        _ => return None,
    };
    let towards = position - point;
    if is_behind(towards) {
        return None;
    }
    let (direction, distance) = T::direction_and_length(towards)?;
    let attenuation = match light.falloff {
        Some(falloff) if effects.has(Effects::FALLOFF) => {
            let slope = falloff.linear.plus(T::held(distance.product(falloff.quadratic)));
            T::ONE / falloff.constant.plus(T::held(distance.product(slope)))
        }
        _ => T::ONE,
    };
    let ray = Ray { origin: point, direction };
    Some(Illumination { ray, distance, color: light.color * attenuation })
}

/// The unit square onto the unit disc, area for area (Shirley and Chiu, "A Low Distortion Map Between Disk and
/// Square", 1997).
pub(crate) fn concentric<T: Real>([s, t]: [T; 2]) -> (T, T) {
    let quarter = T::from_f32(core::f32::consts::FRAC_PI_4);
    let (x, y) = (s + s - T::ONE, t + t - T::ONE);
    let flat = x.abs() > y.abs();
    let (long, short) = if flat { (x, y) } else { (y, x) };
    if long == T::ZERO {
        return (T::ZERO, T::ZERO);
    }
    let (sine, cosine) = sin_cos_eighth(quarter * (short / long));
    let (along, across) = (long * cosine, long * sine);
    if flat { (along, across) } else { (across, along) }
}
