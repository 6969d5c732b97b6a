//! Light from lights, where light is bent.

use super::arrival::{Arrival, StepsLeft};
use super::{Path, is_lit};
use crate::intersect::{Ray, Wanted};
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Index, Scene, ShadowRays};

/// Where a light is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target<T> {
    Point(Vec3<T>),
    /// Infinitely far in this direction, a unit vector.
    Direction(Vec3<T>),
}

/// A bent path to a light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way<T> {
    /// How it starts.
    pub ray: Ray<T>,
    /// How long it is; `T::FARTHEST` to a light infinitely far away.
    pub length: T,
}

/// Whether shadow rays are bent in a scene, by a tracer of such effects.
#[inline]
pub(crate) fn has_bent_shadows<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>) -> bool {
    let bends = scene.black_hole.is_some() || !scene.profiles.is_empty();
    Effects::from_bits(EFFECTS).has(Effects::BENT_SHADOWS) && scene.shadow_rays == ShadowRays::Bent && bends
}

/// How often a path to a light is tried.
const TRIALS: u32 = 12;

/// By how much a path may miss a light, as an angle.
const MISS: f32 = 1.0 / 16_384.0;

/// A path from a point to a light, found by shooting: what a trial misses the light by is added to its direction. Nothing is
/// in its way yet. `None` if no trial comes near enough.
pub(crate) fn towards<T: Real, const EFFECTS: u64>(
    scene: &Scene<'_, T>,
    index: Index<T>,
    origin: Vec3<T>,
    target: Target<T>,
    steps: &mut StepsLeft,
) -> Option<Way<T>> {
    let aim = match target {
        Target::Point(position) => position - origin,
        Target::Direction(direction) => direction,
    };
    let mut way = match target {
        Target::Point(_) => Way { ray: Ray { origin, direction: aim.normalized() }, length: aim.length() },
        Target::Direction(_) => Way { ray: Ray { origin, direction: aim }, length: T::FARTHEST },
    };
    let nothing = Path { objects: &[], ..Path::new(scene, index) };
    for _ in 0..TRIALS {
        let end = Path { limit: way.length, ..nothing }.follow::<EFFECTS>(&way.ray, steps);
        let (miss, longer) = match (target, end) {
            (Target::Point(position), Arrival::Limit(end)) => {
                let miss = position - end.origin;
                let along = miss.dot(end.direction);
                ((miss - end.direction * along) * (T::ONE / way.length), along)
            }
            (Target::Direction(wish), Arrival::Away(direction)) => (wish - direction, T::ZERO),
            _ => return None,
        };
        if miss.length() <= T::from_f32(MISS) && longer.abs() <= way.length * T::from_f32(MISS) {
            return Some(way);
        }
        way.ray.direction = (way.ray.direction + miss).normalized();
        way.length = (way.length + longer).max(T::SMALLEST);
    }
    None
}

/// Whether something that casts a full shadow is in the way to a light.
pub(crate) fn is_hidden<T: Real, const EFFECTS: u64>(
    scene: &Scene<'_, T>,
    index: Index<T>,
    way: &Way<T>,
    steps: &mut StepsLeft,
) -> bool {
    let limit = if way.length < T::FARTHEST { way.length * T::from_f32(1.0 - 1.0 / 8192.0) } else { way.length };
    let path = Path { wanted: Wanted::Shadow, limit, ..Path::new(scene, index) };
    !matches!(path.follow::<EFFECTS>(&way.ray, steps), Arrival::Limit(_) | Arrival::Away(_))
}

/// Whether light gets straight to the origin of a ray from the given distance along it, past objects and the horizon of a
/// black hole.
#[inline]
pub(crate) fn is_lit_straight<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, ray: &Ray<T>, distance: T) -> bool {
    if let (Some(hole), true) = (&scene.black_hole, Effects::from_bits(EFFECTS).has(Effects::BLACK_HOLE)) {
        let away = hole.center - ray.origin;
        let nearest = away.dot(ray.direction).max(T::ZERO).min(distance);
        if (away - ray.direction * nearest).length() < T::TWO * hole.mass {
            return false;
        }
    }
    is_lit::<T, EFFECTS>(scene, ray, distance)
}
