//! How much of a light's light gets to a point.

use super::illumination::Illumination;
use super::media::Media;
use super::{Cut, MOST_PASSED, Observer};
use crate::math::{Real, Rgb};
use crate::path::{is_lit, next_tinted_surface};
use crate::scene::{Effects, Scene, Shadow};

/// The share of arriving light that reaches a point inside `media`; `None` when it is in a shadow.
///
/// What casts a full shadow stops it. Media attenuate it: those of objects with a tinted shadow, which it goes through
/// in a straight line, and the scene's between them. Each surface on the way uses up a ray of `rays`.
pub(super) fn light_share<T: Real, const EFFECTS: u64, const MEDIA: usize, O: Observer>(
    scene: &Scene<'_, T>,
    media: &Media<MEDIA>,
    arriving: &Illumination<T>,
    rays: &mut u32,
    observer: &mut O,
) -> Option<Rgb<T>> {
    let effects = const { Effects::from_bits(EFFECTS) };
    let &Illumination { ray, distance, .. } = arriving;
    if !is_lit::<T, EFFECTS>(scene, &ray, distance) {
        return None;
    }
    if !effects.has(Effects::ATTENUATION) {
        return Some(Rgb::WHITE);
    }
    let mut media = media.filtered(scene, |object| object.shadow == Shadow::Tinted);
    if !effects.has(Effects::TINTED_SHADOW) {
        return Some(media.transmittance(scene, distance));
    }
    let (mut ray, mut left, mut share) = (ray, distance, Rgb::WHITE);
    for _ in 0..MOST_PASSED {
        let Some(hit) = next_tinted_surface::<T, EFFECTS>(scene, &ray, left) else {
            return Some(share * media.transmittance(scene, left));
        };
        share = share * media.transmittance(scene, hit.contact.t);
        *rays = rays.saturating_sub(1);
        left = (left - hit.contact.t).max(T::ZERO);
        let (behind, overflow) = media.behind(scene, &hit);
        if overflow {
            observer.media_overflow();
        }
        media = behind;
        ray = hit.surface::<EFFECTS>(&ray).leave(ray.direction, !hit.contact.front());
    }
    observer.cut(Cut::Passed, share.map(T::to_f32));
    None
}
