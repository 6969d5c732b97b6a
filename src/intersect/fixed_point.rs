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
/// The side that the origin is on is known exactly. The distance between the centre and the ray is off by a rounding, and the
/// direction's length by two; the room that the next ray is given is more.
#[inline]
pub(super) fn sphere<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let from_center = ray.origin - sphere.center;
    let along = -from_center.dot(ray.direction);
    let square = sphere.radius.product(sphere.radius);
    if along <= T::ZERO && from_center.square() > square {
        return None;
    }
    let discriminant = square - (from_center + ray.direction * along).square();
    if discriminant < T::NOTHING {
        return None;
    }
    let half = T::root(discriminant);
    let solid = sphere.radius > T::ZERO;
    let contacts = [Contact::new(along - half, solid, 0), Contact::new(along + half, !solid, 0)];
    ray::first(contacts, limit, outside_only)
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
    let shares = weights.map(|weight| T::ratio(weight, sum));
    let [u, v, w] = shares;
    let t = T::narrow(u.product(a.z) + v.product(b.z) + w.product(c.z));
    Some(Crossing { shares, t, is_clockwise: sum > zero })
}

/// The point of a triangle with these shares of its corners. Its error is that of the shares times the edges, wherever the
/// triangle is.
pub(super) fn locate_on_triangle<T: Real>([a, b, c]: &[Vec3<T>; 3], [_, v, w]: [T; 3], ray: &Ray<T>) -> Located<T> {
    let (ab, ac) = (*b - *a, *c - *a);
    let normal = T::unit_of_sums(ab.cross_products(ac)).unwrap_or(-ray.direction);
    let size = ab.largest().max(ac.largest());
    Located { point: *a + ab * v + ac * w, normal, error: Vec3::splat(size.roundings(16.0)) }
}
