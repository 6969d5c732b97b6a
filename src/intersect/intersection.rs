//! What a ray meets first, for the caller.

use super::{Hit, Ray, Surface};
use crate::math::{Real, Vec3};
use crate::scene::Offset;

/// Where a ray meets the first surface: what is under a pixel, and where rays go on from there.
#[derive(Clone, Copy, Debug)]
pub struct Intersection<T> {
    /// The object, by its place in the scene's list.
    pub object: usize,
    /// Which primitive of the object, where its shape is a list; else 0.
    pub primitive: usize,
    /// Distance along the ray, in scene units; along the path, where light is bent.
    pub distance: T,
    /// Where the ray goes there, a unit vector: its own direction, where light is not bent.
    pub direction: Vec3<T>,
    /// The point, brought back onto the surface.
    pub point: Vec3<T>,
    /// Unit geometric normal, on the outside.
    pub normal: Vec3<T>,
    /// Whether the ray comes from outside.
    pub from_outside: bool,
    /// From the point to the nearest place that is surely outside, along the normal; the other way it is surely inside.
    pub offset: Vec3<T>,
}

/// Where light goes that starts as a ray.
#[derive(Clone, Copy, Debug)]
pub enum Destination<T> {
    /// To a surface.
    Surface(Intersection<T>),
    /// Past everything, at last in this direction, a unit vector.
    Away(Vec3<T>),
    /// Into a black hole.
    Captured,
    /// It is not known: it took all of its steps.
    OutOfSteps,
}

impl<T: Real> Intersection<T> {
    pub(crate) fn new<const EFFECTS: u64>(hit: &Hit<'_, T>, object: usize, ray: &Ray<T>, offset: &Offset<T>) -> Self {
        let Surface { point, normal, offset, .. } = hit.surface::<EFFECTS>(ray, offset);
        Self {
            object,
            primitive: hit.primitive,
            distance: hit.contact.t,
            direction: ray.direction,
            point,
            normal,
            from_outside: hit.contact.front(),
            offset,
        }
    }

    /// A ray that leaves the surface to the side that `direction`, a unit vector, points to. It does not meet the
    /// surface again where that is convex.
    #[must_use]
    pub fn leave(&self, direction: Vec3<T>) -> Ray<T> {
        let outside = direction.dot(self.normal) > T::ZERO;
        let origin = if outside { self.point + self.offset } else { self.point - self.offset };
        Ray { origin, direction }
    }
}
