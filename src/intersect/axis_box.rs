//! Ray against axis-aligned box.

use super::{Contact, Located, Ray, ray::first};
use crate::math::{Real, Vec3};
use crate::scene::AxisBox;

/// The slab in which the ray is inside the box, as entry and exit.
struct Span<T> {
    enter: T,
    enter_axis: u32,
    leave: T,
    leave_axis: u32,
}

impl<T: Real> Span<T> {
    /// Cuts the span by the slab of one axis; `None` when the ray runs along the slab and outside it. Taking that case
    /// apart keeps 0/0 and 0·∞ out of the test.
    #[inline]
    fn cut(self, axis: u32, origin: T, direction: T, low: T, high: T) -> Option<Self> {
        if direction == T::ZERO {
            return (origin >= low && origin <= high).then_some(self);
        }
        let (a, b) = T::quotients(low - origin, high - origin, direction);
        let (near, far) = if direction > T::ZERO { (a, b) } else { (b, a) };
        let mut span = self;
        if near > span.enter {
            (span.enter, span.enter_axis) = (near, axis);
        }
        if far < span.leave {
            (span.leave, span.leave_axis) = (far, axis);
        }
        Some(span)
    }
}

/// The first visible contact nearer than `limit`; `part` is the axis across the face.
#[inline]
pub(crate) fn intersect<T: Real>(shape: &AxisBox<T>, ray: &Ray<T>, limit: T, outside_only: bool) -> Option<Contact<T>> {
    let AxisBox { min, max } = shape;
    let (o, d) = (ray.origin, ray.direction);
    // Neither end of these is a contact.
    let mut span = Span { enter: T::ZERO, enter_axis: 0, leave: limit, leave_axis: 0 };
    let slabs = [(o.x, d.x, min.x, max.x), (o.y, d.y, min.y, max.y), (o.z, d.z, min.z, max.z)];
    for (axis, (origin, direction, low, high)) in (0..).zip(slabs) {
        span = span.cut(axis, origin, direction, low, high)?;
        if span.enter > span.leave {
            return None;
        }
    }
    let entry = Contact::new(span.enter, true, span.enter_axis);
    let exit = Contact::new(span.leave, false, span.leave_axis);
    first([entry, exit], limit, outside_only)
}

/// The point of a contact. The coordinate across the face is the face's own, without any error; the others are those of
/// a point of the face, so that what starts next to an edge and goes inside does start inside.
#[inline]
pub(crate) fn locate<T: Real>(shape: &AxisBox<T>, ray: &Ray<T>, contact: &Contact<T>) -> Located<T> {
    let mut point = ray.at(contact.t).max(shape.min).min(shape.max);
    if T::IS_FIXED {
        // What starts in an edge would not get out of the other face.
        let step = Vec3::splat(T::SMALLEST);
        point = point.min(shape.max - step).max(shape.min + step);
    }
    let mut normal = Vec3::ZERO;
    let (direction, low, high, coordinate, across) = match contact.part() {
        0 => (ray.direction.x, shape.min.x, shape.max.x, &mut point.x, &mut normal.x),
        1 => (ray.direction.y, shape.min.y, shape.max.y, &mut point.y, &mut normal.y),
        _ => (ray.direction.z, shape.min.z, shape.max.z, &mut point.z, &mut normal.z),
    };
    // A ray that goes up enters by the low face and leaves by the high one.
    let at_low = (direction > T::ZERO) == contact.front();
    (*coordinate, *across) = if at_low { (low, -T::ONE) } else { (high, T::ONE) };
    Located { point, normal, error: Vec3::ZERO }
}
