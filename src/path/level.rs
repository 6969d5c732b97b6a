//! The geometry of the levels that an index of refraction depends on.

use crate::intersect::Ray;
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Level};

const fn is_flat<const EFFECTS: u64>() -> bool {
    !Effects::from_bits(EFFECTS).has(Effects::RADIUS_PROFILE)
}

const fn is_round<const EFFECTS: u64>() -> bool {
    !Effects::from_bits(EFFECTS).has(Effects::HEIGHT_PROFILE)
}

/// The level of a point, and its gradient there, a unit vector (zero in the centre of a ball).
#[inline]
pub(super) fn with_gradient<T: Real, const EFFECTS: u64>(level: &Level<T>, point: Vec3<T>) -> (T, Vec3<T>) {
    match *level {
        Level::Height { origin, up } if !is_round::<EFFECTS>() => ((point - origin).dot(up), up),
        Level::Radius { center, radius } if !is_flat::<EFFECTS>() => {
            let away = point - center;
            let distance = away.length();
            let up = if distance > T::ZERO { away * (T::ONE / distance) } else { Vec3::ZERO };
            (distance - radius, up)
        }
        _ => (T::ZERO, Vec3::ZERO),
    }
}

/// How much the surface of one level is curved at a point: 1/radius. In the centre it is as good as infinite.
#[inline]
pub(super) fn curvature<T: Real, const EFFECTS: u64>(level: &Level<T>, point: Vec3<T>) -> T {
    match *level {
        Level::Radius { center, .. } if !is_flat::<EFFECTS>() => T::ONE / (point - center).length().max(T::SMALLEST),
        _ => T::ZERO,
    }
}

/// How far along a ray that comes from below a level it gets there.
#[inline]
pub(super) fn up_to<T: Real, const EFFECTS: u64>(level: &Level<T>, bound: T, ray: &Ray<T>) -> Option<T> {
    match *level {
        Level::Radius { center, radius } if !is_flat::<EFFECTS>() => {
            let (b, c) = ball(center, radius, bound, ray);
            let root = (b * b - c).max(T::ZERO).sqrt();
            // The far one of two solutions; the near one is behind.
            Some(if b > T::ZERO { -c.min(T::ZERO) / (b + root) } else { root - b })
        }
        _ => {
            let (height, up) = with_gradient::<T, EFFECTS>(level, ray.origin);
            let speed = ray.direction.dot(up);
            (speed > T::ZERO).then(|| ((bound - height) / speed).max(T::ZERO))
        }
    }
}

/// How far along a ray that comes from above a level it gets there.
#[inline]
pub(super) fn down_to<T: Real, const EFFECTS: u64>(level: &Level<T>, bound: T, ray: &Ray<T>) -> Option<T> {
    match *level {
        Level::Radius { center, radius } if !is_flat::<EFFECTS>() => {
            let (b, c) = ball(center, radius, bound, ray);
            let discriminant = b * b - c;
            (b < T::ZERO && discriminant > T::ZERO).then(|| c.max(T::ZERO) / (discriminant.sqrt() - b))
        }
        _ => {
            let (height, up) = with_gradient::<T, EFFECTS>(level, ray.origin);
            let speed = ray.direction.dot(up);
            (speed < T::ZERO).then(|| ((bound - height) / speed).max(T::ZERO))
        }
    }
}

/// b and c of t² + 2bt + c = 0, which the distance t to the surface of a level solves.
fn ball<T: Real>(center: Vec3<T>, radius: T, bound: T, ray: &Ray<T>) -> (T, T) {
    let away = ray.origin - center;
    let distance = away.length();
    let ball = radius + bound;
    (away.dot(ray.direction), (distance - ball) * (distance + ball))
}
