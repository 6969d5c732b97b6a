//! Ray against cylinder and cone, open or capped.

use super::{Contact, Located, Ray, ray};
use crate::math::{Real, Vec3};
use crate::scene::Cone;

/// The part of a contact with the side; the others are caps.
pub(super) const SIDE: u32 = 0;
const BASE_CAP: u32 = 1;
const APEX_CAP: u32 = 2;

/// The axis of a cone: the radius is `base_radius` + slope·s at the height s above the base.
struct Axis<T> {
    unit: Vec3<T>,
    height: T,
    slope: T,
}

impl<T: Real> Axis<T> {
    fn new(cone: &Cone<T>) -> Self {
        let axis = cone.apex - cone.base;
        // Of no height there is no cone: validation sees to it.
        let (unit, height) = T::direction_and_length(axis).unwrap_or((axis, T::ONE));
        Self { unit, height, slope: (cone.apex_radius.abs() - cone.base_radius.abs()) / height }
    }

    /// A vector's part along the axis and its part across.
    fn split(&self, v: Vec3<T>) -> (T, Vec3<T>) {
        let along = v.dot(self.unit);
        (along, v - self.unit * along)
    }
}

/// A ray along and across the axis of a cone: at the distance `start` + t it is `height` + `rise`·t above the base, and
/// a·t² + 2·b·t + c is the square of its distance from the axis less that of the radius there.
///
/// `start` is where the ray is nearest to the axis between the ends, so that the digits are spent near the contacts and
/// not on the way to them.
struct Passage<T: Real> {
    start: T,
    height: T,
    rise: T,
    a: T::Wide,
    b: T::Wide,
    c: T::Wide,
}

impl<T: Real> Passage<T> {
    #[inline]
    fn new(cone: &Cone<T>, axis: &Axis<T>, ends: &Span<T>, ray: &Ray<T>) -> Self {
        let (rise, across_rate) = axis.split(ray.direction);
        let square = across_rate.square();
        let middle = (cone.base + (cone.apex - cone.base) * T::HALF - ray.origin).dot(ray.direction);
        let (_, across) = axis.split(ray.at(middle) - cone.base);
        let shift = if square > T::NOTHING { -T::ratio(across.products(across_rate), square) } else { T::ZERO };
        let start = (middle + shift).max(ends.enter.0).min(ends.leave.0);
        let (height, across) = axis.split(ray.at(start) - cone.base);
        let radius = cone.base_radius.abs() + axis.slope * height;
        let radius_rate = axis.slope * rise;
        Self {
            start,
            height,
            rise,
            a: square - radius_rate.product(radius_rate),
            b: across.products(across_rate) - radius.product(radius_rate),
            c: across.square() - radius.product(radius),
        }
    }
}

/// Two distances along a ray, between which it is inside, and the parts of the surface there.
#[derive(Clone, Copy)]
struct Span<T> {
    enter: (T, u32),
    leave: (T, u32),
}

/// The first visible contact nearer than `limit`.
#[inline]
pub(crate) fn intersect<T: Real>(cone: &Cone<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    if goes_past(cone, ray) { None } else { intersect_near(cone, ray, limit, outside_only) }
}

/// The same with a cone that the ray may meet.
fn intersect_near<T: Real>(cone: &Cone<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let axis = Axis::new(cone);
    let ends = between_ends(cone, &axis, ray)?;
    if T::IS_FIXED && (ends.enter.0 >= limit || ends.leave.0 <= T::ZERO) {
        // What is far away is not even looked at: it may be beyond all numbers.
        return None;
    }
    let passage = Passage::new(cone, &axis, &ends, ray);
    let solid = cone.base_radius > T::ZERO || cone.apex_radius > T::ZERO;
    let Passage { start, height, rise, a, b, c } = passage;
    if cone.capped {
        let Span { enter, leave } = passage.within(&ends)?;
        let contacts = [(enter, solid), (leave, !solid)].map(|((t, part), front)| Contact::new(t, front, part));
        return ray::first(contacts, limit, outside_only);
    }
    for t in roots(a, b, c)? {
        let s = height.widened() + rise.product(t);
        // Heights outside the cone also rule out its mirror image behind the tip.
        if s < T::NOTHING || s > axis.height.widened() {
            continue;
        }
        // Half the rate at which the ray leaves the side.
        let front = (t.times(a) + b < T::NOTHING) == solid;
        let t = start + t;
        if t > T::ZERO && t < limit && (front || !outside_only) {
            return Some(Contact::new(t, front, SIDE));
        }
    }
    None
}

/// Whether a ray surely goes past the sphere around a cone, or away from it.
///
/// With f from the origin to the middle of the axis, the line meets the sphere where (f·d)² ≥ f² − r². An origin outside has
/// both ends within 2·|f|, so that f is good to 8u·|f|, and both sides to 32u·f²; 64 are taken.
#[inline]
fn goes_past<T: Real>(cone: &Cone<T>, ray: &Ray<T>) -> bool {
    if T::IS_FIXED {
        return false;
    }
    // All lengths are twice what they are.
    let middle = (cone.base - ray.origin) + (cone.apex - ray.origin);
    let radius = cone.base_radius.abs().max(cone.apex_radius.abs()) * T::TWO;
    let along = middle.dot(ray.direction);
    let square = (cone.apex - cone.base).length_squared() + radius * radius;
    let outside = middle.length_squared().lowered(64.0) - square;
    along * along < outside || (along < T::ZERO && outside > T::ZERO)
}

impl<T: Real> Passage<T> {
    /// Of the span between the caps, what is within the side. A span that is cut by both is closed at their rims, however
    /// they are rounded.
    fn within(&self, caps: &Span<T>) -> Option<Span<T>> {
        let Self { start, a, b, c, .. } = *self;
        let Some([first, second]) = roots(a, b, c) else {
            // The ray meets no side: it runs inside or outside all along.
            return (a < T::NOTHING || c <= T::NOTHING).then_some(*caps);
        };
        let (first, second) = (start + first, start + second);
        let [before, behind] = [caps.until(first), caps.from(second)];
        let inside = if a > T::NOTHING {
            caps.from(first).until(second)
        } else if a < T::NOTHING {
            // Steeper than the side: outside between the roots, of which one belongs to the mirror image.
            if before.length() > behind.length() { before } else { behind }
        } else if b > T::NOTHING {
            before
        } else {
            behind
        };
        (inside.enter.0 <= inside.leave.0).then_some(inside)
    }
}

/// Where a ray is between the ends of a cone.
fn between_ends<T: Real>(cone: &Cone<T>, axis: &Axis<T>, ray: &Ray<T>) -> Option<Span<T>> {
    // In fixed point the unit vector has fewer digits.
    let up = if T::IS_FIXED { cone.apex - cone.base } else { axis.unit };
    let [base, apex] = [cone.base, cone.apex].map(|end| (end - ray.origin).products(up));
    let rise = ray.direction.products(up);
    if rise == T::NOTHING {
        let span = Span { enter: (-T::MAX, SIDE), leave: (T::MAX, SIDE) };
        return (base <= T::NOTHING && apex >= T::NOTHING).then_some(span);
    }
    // A tip has no cap.
    let base_part = if cone.base_radius == T::ZERO { SIDE } else { BASE_CAP };
    let apex_part = if cone.apex_radius == T::ZERO { SIDE } else { APEX_CAP };
    let (base, apex) = ((T::ratio(base, rise), base_part), (T::ratio(apex, rise), apex_part));
    Some(if rise > T::NOTHING { Span { enter: base, leave: apex } } else { Span { enter: apex, leave: base } })
}

impl<T: Real> Span<T> {
    fn from(&self, t: T) -> Self {
        Self { enter: if t > self.enter.0 { (t, SIDE) } else { self.enter }, leave: self.leave }
    }

    fn until(&self, t: T) -> Self {
        Self { enter: self.enter, leave: if t < self.leave.0 { (t, SIDE) } else { self.leave } }
    }

    fn length(&self) -> T {
        self.leave.0 - self.enter.0
    }
}

/// The roots of a·t² + 2·b·t + c in rising order; one root twice where the equation is linear.
fn roots<T: Real>(a: T::Wide, b: T::Wide, c: T::Wide) -> Option<[T; 2]> {
    let root = T::root_of_discriminant(a, b, c)?;
    // The sum that does not cancel; the other root comes from the product of the two.
    let q = if b < T::NOTHING { root - b } else { -(root + b) };
    if q == T::NOTHING {
        return (a != T::NOTHING).then_some([T::ZERO; 2]);
    }
    let second = T::ratio(c, q);
    let first = if a == T::NOTHING { second } else { T::ratio(q, a) };
    Some(if first < second { [first, second] } else { [second, first] })
}

/// The point of a contact with the side, moved across the axis onto it, and the radius there.
#[inline]
pub(crate) fn locate<T: Real>(cone: &Cone<T>, ray: &Ray<T>, contact: &Contact<T>) -> (Located<T>, T) {
    let axis = Axis::new(cone);
    let (height, across) = axis.split(ray.at(contact.t) - cone.base);
    let radius = cone.base_radius.abs() + axis.slope * height;
    // At the tip, and where a side is thinner than a rounding of its distance, rounding is all there is across the axis.
    let noise = height.roundings(8.0);
    let across = if across.square() > noise.product(noise) { axis.split(across).1 } else { Vec3::ZERO };
    let outward = across.normalized_or(axis.unit.tangents().0);
    let point = cone.base + axis.unit * height + outward * radius;
    let normal = (outward - axis.unit * axis.slope).normalized();
    let solid = cone.base_radius > T::ZERO || cone.apex_radius > T::ZERO;
    // Every term is at most the height and the larger radius, plus the distance of the base; each is good to about 6
    // roundings.
    let size = height.abs() + cone.base_radius.abs().max(cone.apex_radius.abs());
    let error = if T::IS_FIXED {
        // Where the base is costs nothing.
        Vec3::splat(size.roundings(8.0))
    } else {
        (cone.base.abs() + Vec3::splat(size)).map(|size| size.roundings(16.0))
    };
    (Located { point, normal: if solid { normal } else { -normal }, error }, radius.abs())
}

/// The disc at the end of a cone that a contact is with, by its centre and the direction across it.
///
/// The outside is away from the other end, or towards it when the cone is turned inwards.
#[inline]
pub(crate) fn cap<T: Real>(cone: &Cone<T>, contact: &Contact<T>) -> (Vec3<T>, Vec3<T>) {
    let (center, other, radius) = if contact.part() == BASE_CAP {
        (cone.base, cone.apex, cone.base_radius)
    } else {
        (cone.apex, cone.base, cone.apex_radius)
    };
    let away = center - other;
    (center, if radius < T::ZERO { -away } else { away })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intersect::numbers::Numbers;

    /// Rays that touch the sphere around a cone at its rim, where the cone does, from ever farther away and from next to it.
    #[test]
    fn cones_that_are_met_are_not_gone_past() {
        let mut hits = 0;
        for round in 0..40_000_u32 {
            let numbers = Numbers(round);
            let (number, vector) = (|i| numbers.number(i), |i| numbers.vector(i));
            let scale = 10_f32.powi((number(900) * 8.0) as i32);
            let (base, axis) = (vector(0) * scale, vector(10) * scale);
            let radius = axis.length() * 10_f32.powi((number(901) * 3.0) as i32);
            let capped = round % 2 == 0;
            let cone = Cone { base, apex: base + axis, base_radius: radius, apex_radius: radius * 0.5, capped };
            let across = axis.cross(vector(20)).normalized();
            let rim = base + across * (radius * (1.0 - 1e-7));
            let along = vector(30).cross(rim - (base + axis * 0.5)).normalized();
            let origin = rim - along * (scale * 10_f32.powi(round as i32 % 9 - 3));
            let ray = Ray { origin, direction: (rim - origin).normalized() };
            if intersect_near(&cone, &ray, f32::MAX, false).is_some() {
                assert!(!goes_past(&cone, &ray), "{cone:?} {ray:?}");
                hits += 1;
            }
        }
        assert!(hits > 4000, "{hits}");
    }
}
