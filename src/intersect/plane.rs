//! Ray against plane and disc.

use super::{Contact, Located, Ray, fixed_point};
use crate::math::{Real, Vec3};
use crate::scene::{Annulus, Disc, Plane};

/// The contact nearer than `limit`, if it may be seen. A ray along the plane does not meet it.
#[inline]
pub(crate) fn intersect<T: Real>(plane: &Plane<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let towards = ray.direction.products(plane.normal);
    let height = (plane.point - ray.origin).products(plane.normal);
    let front = towards < T::NOTHING;
    // Half of all rays move away from a plane; they are spared the division where it takes long.
    let is_away = |height| (height < T::NOTHING) != front || towards == T::NOTHING;
    if (outside_only && !front) || (!T::DIVIDES_FAST && is_away(height)) {
        return None;
    }
    let t = T::ratio(height, towards);
    // It is the only shape without bounds, and what is far out has no room in fixed point.
    if T::IS_FIXED && t < limit && ray.at(t).largest() > T::OUTERMOST {
        return None;
    }
    (t > T::ZERO && t < limit).then_some(Contact::new(t, front, 0))
}

/// A point moved onto the plane through `anchor` across `direction`. The difference to the anchor, its product with the
/// normal and the move are good to about 4 roundings of the larger of the two vectors, and the length of the normal to 4 of
/// the move; 8 are taken.
#[inline]
pub(crate) fn locate<T: Real>(point: Vec3<T>, anchor: Vec3<T>, direction: Vec3<T>) -> Located<T> {
    // Mostly it has length 1, and then is its own normal.
    let is_unit = !T::IS_FIXED && direction.length_squared() == T::ONE;
    let normal = if is_unit { direction } else { direction.normalized() };
    if T::IS_FIXED {
        return fixed_point::locate_on_plane(point, anchor, direction, normal);
    }
    let height = normal * (point - anchor).dot(normal);
    let point = point - height;
    let error = (point.abs() + anchor.abs() + height.abs()).map(|size| size.roundings(8.0));
    Located { point, normal, error }
}

/// The contact with a disc.
#[inline]
pub(crate) fn intersect_disc<T: Real>(
    disc: &Disc<T>,
    ray: &Ray<T>,
    limit: T,
    outside_only: bool,
) -> Option<Contact<T>> {
    let contact = intersect(&plane_of(disc), ray, limit, outside_only)?;
    let from_center = ray.at(contact.t) - disc.center;
    (from_center.square() <= disc.radius.product(disc.radius)).then_some(contact)
}

/// The contact with a disc that has a hole.
#[inline]
pub(crate) fn intersect_annulus<T: Real>(
    annulus: &Annulus<T>,
    ray: &Ray<T>,
    limit: T,
    outside_only: bool,
) -> Option<Contact<T>> {
    let plane = Plane { point: annulus.center, normal: annulus.normal };
    let contact = intersect(&plane, ray, limit, outside_only)?;
    let square = (ray.at(contact.t) - annulus.center).square();
    let (inner, outer) = (annulus.inner.product(annulus.inner), annulus.outer.product(annulus.outer));
    (square >= inner && square <= outer).then_some(contact)
}

fn plane_of<T: Real>(disc: &Disc<T>) -> Plane<T> {
    Plane { point: disc.center, normal: disc.normal }
}
