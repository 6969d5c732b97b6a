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
const TRIALS: u32 = 16;

/// By how much a path may miss a light, as an angle.
const MISS: f32 = 1.0 / 16_384.0;

/// A path from a point to a light, found by shooting. Nothing is in its way yet. `None` if no trial comes near enough.
///
/// The path starts towards a place and is as long as that is far: at first the light itself. By how much its end misses the
/// light moves the place, by Broyden's method (1965), which learns from each trial how the one depends on the other.
pub(crate) fn towards<T: Real, const EFFECTS: u64>(
    scene: &Scene<'_, T>,
    index: Index<T>,
    origin: Vec3<T>,
    target: Target<T>,
    steps: &mut StepsLeft,
) -> Option<Way<T>> {
    // In units of the straight distance, in which nothing depends on the unit of the scene.
    let (wish, unit) = match target {
        Target::Point(position) => ((position - origin).normalized(), (position - origin).length()),
        Target::Direction(direction) => (direction, T::FARTHEST),
    };
    let nothing = Path { objects: &[], ..Path::new(scene, index) };
    let mut aim = Aim::at(wish);
    for _ in 0..TRIALS {
        let ray = Ray { origin, direction: aim.place.normalized() };
        let length = if unit < T::FARTHEST { aim.place.length() * unit } else { unit };
        let path = Path { limit: length, ..nothing };
        let there = match path.follow::<EFFECTS>(&ray, steps) {
            Arrival::Limit(end) => (end.origin - origin) * (T::ONE / unit),
            Arrival::Away(direction) => direction,
            _ => return None,
        };
        let miss = there - wish;
        if miss.length() <= T::from_f32(MISS) {
            return Some(Way { ray, length });
        }
        aim.correct(miss)?;
    }
    None
}

/// Where a path is aimed at, and what is known of how its end depends on that.
struct Aim<T> {
    place: Vec3<T>,
    /// The rows of the matrix by which a change of the end is one of the place: the inverse of Jacobi's.
    inverse: [Vec3<T>; 3],
    /// The last correction, and the miss before it.
    last: Option<(Vec3<T>, Vec3<T>)>,
}

impl<T: Real> Aim<T> {
    fn at(place: Vec3<T>) -> Self {
        let (o, i) = (T::ZERO, T::ONE);
        Self { place, inverse: [Vec3::new(i, o, o), Vec3::new(o, i, o), Vec3::new(o, o, i)], last: None }
    }

    /// Moves the place by what the end misses the light by; `None` where that teaches nothing.
    fn correct(&mut self, miss: Vec3<T>) -> Option<()> {
        if let Some((step, before)) = self.last {
            let change = miss - before;
            let [x, y, z] = self.inverse;
            let row = x * step.x + y * step.y + z * step.z;
            let size = row.dot(change);
            if size == T::ZERO {
                return None;
            }
            let off = (step - self.times(change)) * (T::ONE / size);
            self.inverse = [x + row * off.x, y + row * off.y, z + row * off.z];
        }
        let step = -self.times(miss);
        // Never more than half of the way to the light at once.
        let step = step * (T::HALF / step.length().max(T::HALF));
        self.place += step;
        self.last = Some((step, miss));
        Some(())
    }

    fn times(&self, vector: Vec3<T>) -> Vec3<T> {
        let [x, y, z] = self.inverse.map(|row| row.dot(vector));
        Vec3 { x, y, z }
    }
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
