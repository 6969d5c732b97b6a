//! Ray against sphere.

use super::{Contact, Located, Ray, fixed_point, ray};
use crate::math::{Real, Twofold, Vec3};
use crate::scene::Sphere;

/// The first visible contact nearer than `limit`.
///
/// The discriminant is r² less the square of the distance between the centre and the ray, taken perpendicular to the
/// ray, which keeps its digits for small spheres far away; one root comes from the product of the two, which keeps its
/// digits for origins near the surface (Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems, 2019). The contact lies on a sphere whose radius differs by no more than 8 roundings
/// of the distance from the origin to the centre.
///
/// Where the origin is so near the surface that the product of the roots loses its digits, as above a ground as large
/// as a planet, or that the side it is on is in doubt, the product is the level of the origin in twice the digits; b² less
/// that is then the better discriminant.
#[inline(always)]
pub(crate) fn intersect<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    if !T::IS_FIXED {
        // Most rays go far past: 64u·f² leave room for all roundings.
        let f = ray.origin - sphere.center;
        let b = f.dot(ray.direction);
        if b * b < f.length_squared().lowered(64.0) - sphere.radius * sphere.radius {
            return None;
        }
    }
    intersect_near(sphere, ray, limit, outside_only)
}

/// The same with a sphere that the ray is known to go near to.
#[inline(always)]
pub(crate) fn intersect_near<T: Real>(
    sphere: &Sphere<T>,
    ray: &Ray<T>,
    limit: T,
    outside_only: bool,
) -> Option<Contact<T>> {
    if T::IS_FIXED {
        return fixed_point::sphere(sphere, ray, limit, outside_only);
    }
    let f = ray.origin - sphere.center;
    let b = -f.dot(ray.direction);
    let square = sphere.radius * sphere.radius;
    let mut c = f.length_squared() - square;
    let doubt = square.roundings(16.0);
    if b <= T::ZERO && c > doubt {
        return None;
    }
    let discriminant = if c < square * T::from_f32(1.0 / 256.0) && c >= -doubt {
        c = level(sphere, ray.origin);
        b * b - c
    } else {
        square - (f + ray.direction * b).length_squared()
    };
    if discriminant < T::ZERO {
        return None;
    }
    let root = discriminant.sqrt();
    let (near, far) = if b < T::ZERO {
        let near = b - root;
        (near, c / near)
    } else {
        let far = b + root;
        (if far > T::ZERO { c / far } else { far }, far)
    };
    let solid = sphere.radius > T::ZERO;
    ray::first([Contact::new(near, solid, 0), Contact::new(far, !solid, 0)], limit, outside_only)
}

/// |point − centre|² − r², worked out in twice the digits.
#[inline(never)]
fn level<T: Real>(sphere: &Sphere<T>, point: Vec3<T>) -> T {
    let Sphere { center, radius } = sphere;
    let [x, y, z, radius] = [(point.x, center.x), (point.y, center.y), (point.z, center.z), (*radius, T::ZERO)]
        .map(|(a, b)| Twofold::difference(a, b).squared());
    (x + y + z - radius).rounded()
}

/// The point of a contact. It is moved onto the sphere, so its error does not grow with the distance.
#[inline]
pub(crate) fn locate<T: Real>(sphere: &Sphere<T>, ray: &Ray<T>, contact: &Contact<T>) -> Located<T> {
    if T::IS_FIXED {
        return fixed_point::locate_on_sphere(sphere, ray, contact);
    }
    let solid = sphere.radius > T::ZERO;
    // A sphere far smaller than a rounding of its distance is met in its centre.
    let facing = || if contact.front() == solid { -ray.direction } else { ray.direction };
    let outward = T::unit((ray.origin - sphere.center) + ray.direction * contact.t).unwrap_or_else(facing);
    let normal = if solid { outward } else { -outward };
    let radius = sphere.radius.abs();
    let local = outward * radius;
    let mut point = sphere.center + local;
    // The direction is good to 4 roundings, its product with r to 5; 8 leave room for the discriminant's own.
    let (mut size, mut roundings, mut rest) = (local, T::from_f32(8.0) * T::ROUNDOFF, T::ZERO);
    if point.largest() * T::TWO < radius {
        // Where the way is shorter than the radius, the ray tells better where along the surface the point is.
        if contact.t < radius {
            point = ray.at(contact.t);
        }
        // Its coordinates are known better than the radius: it is moved by its height, good to 4 roundings of the point
        // and to 16 of the radius in twice the digits.
        point -= outward * height(sphere, point);
        (size, roundings) = (point, T::from_f32(4.0) * T::ROUNDOFF);
        rest = T::from_f32(16.0) * T::ROUNDOFF * T::ROUNDOFF * radius;
    }
    Located { point, normal, error: size.abs() * roundings + Vec3::splat(rest) }
}

/// How far outside of a sphere a point next to it lies.
#[cold]
#[inline(never)]
fn height<T: Real>(sphere: &Sphere<T>, point: Vec3<T>) -> T {
    level(sphere, point) / ((point - sphere.center).length() + sphere.radius.abs())
}
