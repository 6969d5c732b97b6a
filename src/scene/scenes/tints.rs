//! Coloured glass.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::optics::attenuation_for;
use crate::scene::{Background, Camera, Light, Material, Medium, Object, Scene, Shape};

/// Slabs of amber, green and blue glass, each twice as thick as the one before, and their coloured shadows.
///
/// By Beer's law twice the thickness squares the share of light that is left, channel by channel: a colour does not
/// just darken, it also changes. Thin amber is yellow, thick amber a deep orange.
pub const TINTS: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.6, 6.5, 11.0), Vec3::new(0.15, 0.1, -0.3), UP, 31.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.8, 0.8, 0.8), above: Rgb::new(0.3, 0.4, 0.55), up: UP };

const TABLE: Material<f32> = Material::matte(Rgb::grey(0.9));

/// Glass that leaves this share of the light over a tenth of a unit.
const fn glass(color: Rgb<f32>) -> Material<f32> {
    Material::transparent(Medium::new(1.5).with_attenuation(attenuation_for(color, 0.1)))
}

const AMBER: Material<f32> = glass(Rgb::new(0.97, 0.86, 0.5));
const GREEN: Material<f32> = glass(Rgb::new(0.7, 0.95, 0.75));
const BLUE: Material<f32> = glass(Rgb::new(0.65, 0.85, 0.97));

/// Slab `number` of the row whose backs are at z, let into the table so that no air is left below.
const fn slab(number: u32, z: f32, material: Material<f32>) -> Object<'static, f32> {
    let (x, thickness) = (1.4 * number as f32 - 3.2, 0.1 * (1 << number) as f32);
    let (min, max) = (Vec3::new(x, -0.1, z), Vec3::new(x + 0.9, 1.1, z + thickness));
    Object::new(Shape::axis_box(min, max), material).with_tinted_shadow()
}

const OBJECTS: [Object<'static, f32>; 16] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), TABLE),
    slab(0, -4.5, AMBER),
    slab(1, -4.5, AMBER),
    slab(2, -4.5, AMBER),
    slab(3, -4.5, AMBER),
    slab(4, -4.5, AMBER),
    slab(0, -1.5, GREEN),
    slab(1, -1.5, GREEN),
    slab(2, -1.5, GREEN),
    slab(3, -1.5, GREEN),
    slab(4, -1.5, GREEN),
    slab(0, 1.5, BLUE),
    slab(1, 1.5, BLUE),
    slab(2, 1.5, BLUE),
    slab(3, 1.5, BLUE),
    slab(4, 1.5, BLUE),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::directional(Vec3::new(-0.3, 1.0, -0.9), Rgb::new(0.95, 0.93, 0.88)),
    Light::directional(UP, Rgb::grey(0.1)),
];
