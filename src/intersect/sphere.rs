//! Ray against sphere.

use super::{Contact, Ray, Surface, ray::first};
use crate::math::Real;
use crate::scene::Sphere;

/// The first visible contact nearer than `limit`.
///
/// The discriminant is r² less the square of the distance between the centre and the ray, taken perpendicular to the
/// ray, which keeps its digits for small spheres far away; the nearer root comes from the product of the roots, which
/// keeps its digits for origins near the surface (Haines, Günther and Akenine-Möller, "Precision Improvements for
/// Ray/Sphere Intersection", Ray Tracing Gems, 2019).
#[inline]
pub(crate) fn intersect<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let f = ray.origin - sphere.center;
    let b = -f.dot(ray.direction);
    let square = sphere.radius * sphere.radius;
    let discriminant = square - (f + ray.direction * b).length_squared();
    if discriminant < T::ZERO {
        return None;
    }
    let c = f.length_squared() - square;
    let root = discriminant.sqrt();
    let (near, far) = if b < T::ZERO {
        let near = b - root;
        (near, c / near)
    } else {
        let far = b + root;
        (if far > T::ZERO { c / far } else { far }, far)
    };
    let solid = sphere.radius > T::ZERO;
    first([Contact::new(near, solid, 0), Contact::new(far, !solid, 0)], limit, outside_only)
}

/// The surface at a contact. The point is moved onto the sphere, so its error does not grow with the distance.
#[inline(always)]
pub(crate) fn surface<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, contact: &Contact<T>) -> Surface<T> {
    let outward = (ray.at(contact.t) - sphere.center).normalized();
    let local = outward * sphere.radius.abs();
    let normal = if sphere.radius > T::ZERO { outward } else { -outward };
    // The direction is good to 4 roundings, its product with r to 5; 8 leave room for the discriminant's own.
    let error = local.abs() * (T::from_f32(8.0) * T::ROUNDOFF);
    Surface::new(sphere.center + local, normal, error)
}
