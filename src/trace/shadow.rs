//! How much of a light's light gets to a point.

use super::illumination::Illumination;
use super::media::{Crossing, Media};
use super::{Cut, MOST_PASSED, Observer};
use crate::math::{Real, Rgb};
use crate::path::{has_bent_shadows, is_lit_straight, next_tinted_surface};
use crate::scene::{Effects, Object, Scene, Shadow};

/// How much of a light's light gets to a point.
pub(super) struct Share<T> {
    /// `None` when the point is in a shadow.
    pub light: Option<Rgb<T>>,
    /// Surfaces that the light went straight through on the way.
    pub passed: u32,
}

impl<T> Share<T> {
    /// What gets to a point in a shadow.
    pub(super) const NOTHING: Self = Self { light: None, passed: 0 };
}

/// The share of arriving light that reaches a point inside `media`.
///
/// What casts a full shadow stops it; where shadow rays are bent, that has been seen to. Media attenuate it: those of objects
/// with a tinted shadow, which it goes through in a straight line, and the scene's between them. It goes through no more surfaces than `most` and [`MOST_PASSED`].
pub(super) fn light_share<T: Real, const EFFECTS: u64, const MEDIA: usize, O: Observer>(
    scene: &Scene<'_, T>,
    media: &Media<MEDIA>,
    arriving: &Illumination<T>,
    most: u32,
    observer: &mut O,
) -> Share<T> {
    let effects = const { Effects::from_bits(EFFECTS) };
    let straight = |light| Share { light, passed: 0 };
    let &Illumination { ray, distance, .. } = arriving;
    if !has_bent_shadows::<T, EFFECTS>(scene) && !is_lit_straight::<T, EFFECTS>(scene, &ray, distance) {
        return straight(None);
    }
    if !effects.has(Effects::ATTENUATION) {
        return straight(Some(Rgb::WHITE));
    }
    let is_tinted = |object: &Object<'_, T>| object.shadow == Shadow::Tinted;
    let mut media = media.filtered(scene, is_tinted);
    if !effects.has(Effects::TINTED_SHADOW) {
        return straight(Some(media.transmittance(scene, distance)));
    }
    let (mut ray, mut left, mut share, mut passed) = (ray, distance, Rgb::WHITE, 0);
    while let Some(hit) = next_tinted_surface::<T, EFFECTS>(scene, &ray, left) {
        if passed == most.min(MOST_PASSED.into()) {
            let reason = if passed == most { Cut::Rays } else { Cut::Passed };
            observer.cut(reason, share.map(T::to_f32));
            return Share { light: None, passed };
        }
        passed += 1;
        share = share * media.transmittance(scene, hit.contact.t);
        left = (left - hit.contact.t).max(T::ZERO);
        let surface = hit.surface::<EFFECTS>(&ray, &scene.offset);
        let crossing = Crossing { hit: &hit, ray: &ray, reach: surface.reach(ray.direction, hit.contact.t) };
        let (behind, overflow) = media.behind::<T, EFFECTS>(scene, &crossing, is_tinted);
        if overflow {
            observer.media_overflow();
        }
        media = behind;
        ray = surface.leave(ray.direction, !hit.contact.front());
    }
    Share { light: Some(share * media.transmittance(scene, left)), passed }
}
