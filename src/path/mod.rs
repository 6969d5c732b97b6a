//! How light gets from a point to the next surface: in a straight line.

use crate::intersect::{Hit, Ray, nearest, occluded};
use crate::math::Real;
use crate::scene::Scene;

/// The surface that light comes from along a ray.
#[inline]
pub(crate) fn next_surface<'a, T: Real, const EFFECTS: u64>(scene: &Scene<'a, T>, ray: &Ray<T>) -> Option<Hit<'a, T>> {
    nearest::<T, EFFECTS>(scene.objects, ray)
}

/// Whether light reaches the origin of a ray from the given distance along it.
#[inline]
pub(crate) fn is_lit<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, ray: &Ray<T>, distance: T) -> bool {
    !occluded::<T, EFFECTS>(scene.objects, ray, distance)
}
