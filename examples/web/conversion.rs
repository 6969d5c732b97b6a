//! From the library's scenes, which are in `f32`, to the number type of a module.

use whit::{Background, Camera, Real, Rgb, Scene, Vec3};

use crate::Number;
use crate::memory::empty_scene;

/// A built-in scene in that number type. The page must hold no frame of the one before. `None` when there is no room for it.
pub fn converted(scene: &Scene<'static, f32>) -> Option<Scene<'static, Number>> {
    let nowhere = Camera::with_half_height(Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, Number::ZERO);
    let buffer = empty_scene(nowhere, Background::Solid(Rgb::BLACK));
    buffer.copy_from(scene, Number::from_f32).ok()?;
    Some(buffer.as_scene())
}
