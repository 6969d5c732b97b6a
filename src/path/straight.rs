//! How light gets from a point to the next surface in a straight line.

use crate::intersect::{Hit, Ray, Wanted, search_scene};
use crate::math::Real;
use crate::scene::Scene;

/// The surface that light comes from along a ray. A plane that is met beyond any scene, at its horizon, is not seen.
#[inline]
pub(crate) fn next_surface<'a, T: Real, const EFFECTS: u64>(scene: &Scene<'a, T>, ray: &Ray<T>) -> Option<Hit<'a, T>> {
    search_scene::<T, EFFECTS>(scene, ray, T::FARTHEST, Wanted::Nearest)
}

/// The surface of an object with a tinted shadow that light meets first along a ray, before `distance`.
pub(crate) fn next_tinted_surface<'a, T: Real, const EFFECTS: u64>(
    scene: &Scene<'a, T>,
    ray: &Ray<T>,
    distance: T,
) -> Option<Hit<'a, T>> {
    search_scene::<T, EFFECTS>(scene, ray, distance, Wanted::NearestTinted)
}

/// Whether light reaches the origin of a ray from the given distance along it. A surface that the light lies on, to 2⁻¹³ of
/// the distance, is not in its way.
#[inline]
pub(super) fn is_lit<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, ray: &Ray<T>, distance: T) -> bool {
    let limit = distance * T::from_f32(1.0 - 1.0 / 8192.0);
    search_scene::<T, EFFECTS>(scene, ray, limit, Wanted::Shadow).is_none()
}
