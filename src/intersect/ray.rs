//! Rays, and where they meet a surface.

use crate::math::{Real, Vec3};

/// A half-line: origin + t·direction for t > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<T> {
    /// Where it starts.
    pub origin: Vec3<T>,
    /// Where it goes; a unit vector, so that t is a distance.
    pub direction: Vec3<T>,
}

impl<T: Real> Ray<T> {
    /// The point at distance `t`.
    #[inline]
    #[must_use]
    pub fn at(&self, t: T) -> Vec3<T> {
        self.origin + self.direction * t
    }
}

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Contact<T> {
    /// Distance along the ray, above 0.
    pub t: T,
    /// Side and part in one word, which goes through memory faster than two bytes: 2·part + (1 from outside).
    face: u32,
}

impl<T: Copy> Contact<T> {
    /// `part` is which part of the shape it is, where a shape has parts: the axis of a box's face, the side or a cap
    /// of a cone.
    #[inline(always)]
    pub(crate) fn new(t: T, front: bool, part: u32) -> Self {
        Self { t, face: 2 * part + u32::from(front) }
    }

    /// Whether the ray comes from outside.
    #[inline(always)]
    pub(crate) fn front(&self) -> bool {
        self.face & 1 == 1
    }

    #[inline(always)]
    pub(crate) fn part(&self) -> u32 {
        self.face / 2
    }
}

/// Of two candidates in the order of the ray, the first that lies between 0 and `limit` and may be seen.
#[inline]
pub(crate) fn first<T: Real>(candidates: [Contact<T>; 2], limit: T, outside_only: bool) -> Option<Contact<T>> {
    let [near, far] = candidates;
    let is_met = |c: Contact<T>| c.t > T::ZERO && c.t < limit && (c.front() || !outside_only);
    if is_met(near) {
        Some(near)
    } else if is_met(far) {
        Some(far)
    } else {
        None
    }
}
