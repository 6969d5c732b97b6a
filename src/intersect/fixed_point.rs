//! Shapes in fixed point.
//!
//! Floating-point numbers keep their digits as long as nothing cancels, and the tests for them are written so that little
//! does. Fixed-point numbers are equally far apart everywhere: sums and differences are exact, what is rounded is rounded by the
//! same amount wherever it is, and sums of products are exact as well. So the plain formulas are the good ones.

use super::{Contact, Located, Ray, ray};
use crate::math::{Real, Vec3};
use crate::scene::Sphere;

/// The first visible contact with a sphere.
///
/// The side that the origin is on is known exactly, and with it how many contacts there are. The distance between the centre
/// and the ray is off by a rounding. The direction's length is off by two, which along a way of a thousand would be a lot; so
/// the contacts are given in that length, as those with other shapes are.
#[inline]
pub(super) fn sphere<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let from_center = ray.origin - sphere.center;
    let along = -from_center.dot(ray.direction);
    let square = sphere.radius.product(sphere.radius);
    let distance = from_center.square();
    if along <= T::ZERO && distance >= square {
        return None;
    }
    let is_outside = distance > square;
    let discriminant = square - (from_center + ray.direction * along).square();
    if is_outside && discriminant < T::NOTHING {
        return None;
    }
    let half = if discriminant > T::NOTHING { T::root(discriminant) } else { T::ZERO };
    let excess = ray.direction.square() - T::ONE.widened();
    let along = along - T::narrow(along.times(excess));
    let half = half - T::narrow(half.times(excess)) * T::HALF;
    let solid = sphere.radius > T::ZERO;
    // However they are rounded, they lie ahead.
    let far = Contact::new((along + half).max(T::SMALLEST), !solid, 0);
    let near = if is_outside { Contact::new((along - half).max(T::SMALLEST), solid, 0) } else { far };
    ray::first([near, far], limit, outside_only)
}

/// The point of a contact. Its direction from the centre has more digits than numbers have, as many as the largest radius needs.
#[inline]
pub(super) fn locate_on_sphere<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, contact: &Contact<T>) -> Located<T> {
    let solid = sphere.radius > T::ZERO;
    // A sphere far smaller than a rounding of its distance is met in its centre.
    let facing = if contact.front() == solid { -ray.direction } else { ray.direction };
    let towards = (ray.origin - sphere.center) + ray.direction * contact.t;
    let radius = sphere.radius.abs();
    let (outward, local) = T::of_length(towards, radius).unwrap_or((facing, facing * radius));
    Located { point: sphere.center + local, normal: if solid { outward } else { -outward }, error: two_roundings() }
}

/// A point moved onto the plane through `anchor` across `direction`, by a multiple of the direction as it is.
pub(super) fn locate_on_plane<T: Real>(
    point: Vec3<T>,
    anchor: Vec3<T>,
    direction: Vec3<T>,
    normal: Vec3<T>,
) -> Located<T> {
    let steps = T::ratio((point - anchor).products(direction), direction.square());
    Located { point: point - direction * steps, normal, error: two_roundings() }
}

/// The error of a point whose coordinates are two sums or products, and of a length that is rounded once.
fn two_roundings<T: Real>() -> Vec3<T> {
    Vec3::splat(T::SMALLEST + T::SMALLEST)
}

/// Where a ray crosses the plane of a triangle.
pub(super) struct Crossing<T> {
    /// Of the corners in the point; they add up to 1.
    pub shares: [T; 3],
    pub t: T,
    /// Whether the corners go round clockwise, seen along the ray, if its axis is turned forwards.
    pub is_clockwise: bool,
}

/// Where a ray crosses a triangle whose corners are sheared so that the ray is an axis.
///
/// Which side of an edge the ray passes on is known exactly, once the corners are sheared, so that triangles that share an edge
/// leave no gap.
#[inline]
pub(super) fn triangle<T: Real>([a, b, c]: [Vec3<T>; 3]) -> Option<Crossing<T>> {
    let across = |p: Vec3<T>, q: Vec3<T>| p.x.product(q.y) - p.y.product(q.x);
    let weights = [across(c, b), across(a, c), across(b, a)];
    let [u, v, w] = weights;
    let zero = T::NOTHING;
    if (u < zero || v < zero || w < zero) && (u > zero || v > zero || w > zero) {
        return None;
    }
    let sum = u + v + w;
    if sum == zero {
        return None;
    }
    // With more digits than a number has, for a distance that may be long.
    let [u, v, w] = weights.map(|weight| T::share(weight, sum));
    let t = a.z.scaled(u) + b.z.scaled(v) + c.z.scaled(w);
    let shares = [u, v, w].map(|share| T::ONE.scaled(share));
    Some(Crossing { shares, t, is_clockwise: sum > zero })
}

/// The point of a triangle with these shares of its corners. However they are rounded, it is in the plane of the triangle to
/// two roundings; so is the distance of a crossing, and that of the corners once they are sheared.
pub(super) fn locate_on_triangle<T: Real>([a, b, c]: &[Vec3<T>; 3], [_, v, w]: [T; 3], ray: &Ray<T>) -> Located<T> {
    let (ab, ac) = (*b - *a, *c - *a);
    let normal = T::unit_of_sums(ab.cross_products(ac)).unwrap_or(-ray.direction);
    Located { point: *a + ab * v + ac * w, normal, error: two_roundings() }
}
