//! How light gets from a point to the next surface: in a straight line.

use crate::intersect::{Hit, Ray, nearest, occluded};
use crate::math::Real;
use crate::scene::{Scene, Shadow};

/// The surface that light comes from along a ray. A plane that is met beyond any scene, at its horizon, is not seen.
#[inline]
pub(crate) fn next_surface<'a, T: Real, const EFFECTS: u64>(scene: &Scene<'a, T>, ray: &Ray<T>) -> Option<Hit<'a, T>> {
    nearest::<T, EFFECTS>(scene.objects, ray, T::FARTHEST, |_| true)
}

/// The surface of an object with a tinted shadow that light meets first along a ray, before `distance`.
pub(crate) fn next_tinted_surface<'a, T: Real, const EFFECTS: u64>(
    scene: &Scene<'a, T>,
    ray: &Ray<T>,
    distance: T,
) -> Option<Hit<'a, T>> {
    nearest::<T, EFFECTS>(scene.objects, ray, distance, |object| object.shadow == Shadow::Tinted)
}

/// Whether light reaches the origin of a ray from the given distance along it. A surface that the light lies on, to 2⁻¹³ of
/// the distance, is not in its way.
#[inline]
pub(crate) fn is_lit<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, ray: &Ray<T>, distance: T) -> bool {
    !occluded::<T, EFFECTS>(scene.objects, ray, distance * T::from_f32(1.0 - 1.0 / 8192.0))
}
