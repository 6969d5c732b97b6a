//! Ray against cylinder and cone, open or capped.

use super::{Contact, Ray, Surface, plane};
use crate::math::{Real, Vec3};
use crate::scene::{Cone, Disc};

const SIDE: u32 = 0;
const BASE_CAP: u32 = 1;
const APEX_CAP: u32 = 2;

/// The axis of a cone: the radius is `base_radius` + slope·s at the height s above the base.
struct Axis<T> {
    unit: Vec3<T>,
    height: T,
    slope: T,
}

impl<T: Real> Axis<T> {
    #[inline]
    fn new(cone: &Cone<T>) -> Self {
        let axis = cone.apex - cone.base;
        let height = axis.length();
        let slope = (cone.apex_radius.abs() - cone.base_radius.abs()) / height;
        Self { unit: axis * (T::ONE / height), height, slope }
    }

    /// A vector's part along the axis and its part across.
    #[inline]
    fn split(&self, v: Vec3<T>) -> (T, Vec3<T>) {
        let along = v.dot(self.unit);
        (along, v - self.unit * along)
    }
}

/// The first visible contact nearer than `limit`.
pub(crate) fn intersect<T: Real>(cone: &Cone<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let mut best = intersect_side(cone, ray, limit, outside_only);
    if cone.capped {
        for (part, cap) in [(BASE_CAP, base_cap(cone)), (APEX_CAP, apex_cap(cone))] {
            let limit = best.map_or(limit, |contact| contact.t);
            if let Some(contact) = plane::intersect_disc(&cap, ray, limit, outside_only) {
                best = Some(Contact::new(contact.t, contact.front(), part));
            }
        }
    }
    best
}

/// Solves |across(t)|² = radius(t)² with the origin moved to where the ray is nearest to the axis, so that the digits
/// are spent near the contacts and not on the way to them. A ray along the axis moves no farther than its end.
fn intersect_side<T: Real>(cone: &Cone<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let axis = Axis::new(cone);
    let (rise, across_rate) = axis.split(ray.direction);
    let square = across_rate.length_squared();
    let middle = (cone.base + (cone.apex - cone.base) * T::HALF - ray.origin).dot(ray.direction);
    let (_, across) = axis.split(ray.at(middle) - cone.base);
    let shift = if square > T::ZERO { -(across.dot(across_rate) / square) } else { T::ZERO };
    let start = middle + shift.min(axis.height).max(-axis.height);
    let (height, across) = axis.split(ray.at(start) - cone.base);
    let radius = cone.base_radius.abs() + axis.slope * height;
    let radius_rate = axis.slope * rise;
    let a = square - radius_rate * radius_rate;
    let b = across.dot(across_rate) - radius * radius_rate;
    let c = across.length_squared() - radius * radius;
    let solid = cone.base_radius > T::ZERO || cone.apex_radius > T::ZERO;
    for t in roots(a, b, c)? {
        let s = height + rise * t;
        // Heights outside the cone also rule out its mirror image behind the tip.
        if s < T::ZERO || s > axis.height {
            continue;
        }
        // The normal is across − radius·slope·axis, up to a positive factor.
        let gradient = (across + across_rate * t).dot(across_rate) - (radius + radius_rate * t) * radius_rate;
        let front = (gradient < T::ZERO) == solid;
        let t = start + t;
        if t > T::ZERO && t < limit && (front || !outside_only) {
            return Some(Contact::new(t, front, SIDE));
        }
    }
    None
}

/// The roots of a·t² + 2·b·t + c in rising order; one root twice where the equation is linear.
fn roots<T: Real>(a: T, b: T, c: T) -> Option<[T; 2]> {
    let discriminant = b * b - a * c;
    if discriminant < T::ZERO {
        return None;
    }
    let root = discriminant.sqrt();
    // The sum that does not cancel; the other root comes from the product of the two.
    let q = if b < T::ZERO { root - b } else { -(root + b) };
    if q == T::ZERO {
        return (a != T::ZERO).then_some([T::ZERO; 2]);
    }
    let second = c / q;
    let first = if a == T::ZERO { second } else { q / a };
    Some(if first < second { [first, second] } else { [second, first] })
}

/// The surface at a contact. A point on the side is moved across the axis onto it.
pub(crate) fn surface<T: Real>(cone: &Cone<T>, ray: &Ray<T>, contact: &Contact<T>) -> Surface<T> {
    match contact.part() {
        BASE_CAP => return plane::disc_surface(&base_cap(cone), ray, contact),
        APEX_CAP => return plane::disc_surface(&apex_cap(cone), ray, contact),
        _ => {}
    }
    let axis = Axis::new(cone);
    let (height, across) = axis.split(ray.at(contact.t) - cone.base);
    let radius = cone.base_radius.abs() + axis.slope * height;
    // A side far thinner than a rounding of its distance is met on its axis.
    let outward = across.normalized_or(-ray.direction);
    let point = cone.base + axis.unit * height + outward * radius;
    let normal = (outward - axis.unit * axis.slope).normalized();
    let solid = cone.base_radius > T::ZERO || cone.apex_radius > T::ZERO;
    // Every term is at most the distance from the base, plus that of the base; each is good to about 6 roundings.
    let size = cone.base.abs() + Vec3::splat(height.abs() + radius.abs());
    let error = size * (T::from_f32(16.0) * T::ROUNDOFF);
    Surface::new(point, if solid { normal } else { -normal }, error)
}

/// The disc at the base; its outside is away from the apex, or towards it when the cone is turned inwards.
fn base_cap<T: Real>(cone: &Cone<T>) -> Disc<T> {
    cap(cone.base, cone.apex, cone.base_radius)
}

fn apex_cap<T: Real>(cone: &Cone<T>) -> Disc<T> {
    cap(cone.apex, cone.base, cone.apex_radius)
}

fn cap<T: Real>(center: Vec3<T>, other: Vec3<T>, radius: T) -> Disc<T> {
    let away = center - other;
    Disc { center, normal: if radius < T::ZERO { -away } else { away }, radius: radius.abs() }
}
