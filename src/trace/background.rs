//! What a ray sees that meets nothing.

use super::stars::stars;
use crate::math::{Real, Rgb, Vec3};
use crate::scene::{Background, Effects, Scene};

/// The light from far away in a direction.
pub(super) fn background<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, direction: Vec3<T>) -> Rgb<T> {
    let effects = const { Effects::from_bits(EFFECTS) };
    match scene.background {
        Background::Solid(color) => color,
        Background::Gradient { below, above, up } if effects.has(Effects::BACKGROUND_GRADIENT) => {
            // Both are unit vectors but for their rounding, which must not make negative light.
            let height = ((T::ONE + direction.dot(up)) * T::HALF).abs();
            below.mix(above, height.min(T::ONE))
        }
        Background::Sky { horizon, up } if effects.has(Effects::SKY) => {
            let dark = T::ONE - direction.dot(up);
            let square = dark * dark;
            horizon * (square * square)
        }
        Background::Stars { sky, brightness, cells, radius } if effects.has(Effects::STARS) => {
            sky + stars(direction, cells, radius) * brightness
        }
        _ => Rgb::BLACK,
    }
}
