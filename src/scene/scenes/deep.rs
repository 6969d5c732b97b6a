//! The colours of deep water.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::optics::materials;
use crate::scene::{Background, Camera, Light, Material, Medium, Object, Pattern, Scene, Shape};

/// An island of white tiles that falls away into the sea. Around the shore the water is clear; a few metres down the
/// red light is gone and the tiles are blue-green; then only blue is left; then nothing.
///
/// Sunlight loses its colours by Beer's law on the way down and again on the way up to the eye. The balls on the slope
/// are all of the same red. One unit is 40 metres, and the water absorbs as was measured in pure water.
pub const DEEP: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

/// The length of a scene unit.
const METRES: f32 = 40.0;

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 10.5, 11.0), Vec3::new(0.0, 0.0, 1.5), UP, 38.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.75, 0.82, 0.9), above: Rgb::new(0.25, 0.45, 0.8), up: UP };

const C: Rgb<f32> = materials::WATER_EXTINCTION;
const SEA: Material<f32> = Material::transparent(Medium::new(materials::SEAWATER).with_attenuation(Rgb::new(
    METRES * C.r,
    METRES * C.g,
    METRES * C.b,
)));
const TILES: Material<f32> = Material::patterned(checker(Rgb::grey(0.9), Rgb::grey(0.6), 0.4));
const RED: Material<f32> = Material::matte(Rgb::new(0.85, 0.05, 0.04));
const STRIPES: Material<f32> = Material::patterned(Pattern::Checker {
    even: Rgb::grey(0.9),
    odd: Rgb::new(0.8, 0.05, 0.04),
    u: Vec3::new(0.0, 2.5, 0.0),
    v: Vec3::ZERO,
});

/// The island is the top of a ball of this radius around the place straight under the origin at this depth.
const RADIUS: f32 = 12.0;
const DEPTH: f32 = RADIUS - 0.16;

/// A red ball on the slope, at a distance from the middle of the island.
const fn ball(distance: f32) -> Object<'static, f32> {
    // The height of a circle near its top.
    let h = distance * distance / (2.0 * RADIUS);
    let y = RADIUS - DEPTH - h * (1.0 + h / (2.0 * RADIUS));
    Object::new(Shape::sphere(Vec3::new(0.8 * distance, y + 0.15, 0.6 * distance), 0.2), RED)
}

const OBJECTS: [Object<'static, f32>; 9] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), SEA).with_tinted_shadow(),
    Object::new(Shape::sphere(Vec3::new(0.0, -DEPTH, 0.0), RADIUS), TILES),
    Object::new(Shape::cone(Vec3::ZERO, 0.4, Vec3::new(0.0, 2.0, 0.0), 0.28).capped(), STRIPES),
    Object::new(Shape::cone(Vec3::new(0.0, 2.0, 0.0), 0.36, Vec3::new(0.0, 2.4, 0.0), 0.0).capped(), RED),
    ball(1.4),
    ball(2.4),
    ball(3.5),
    ball(4.3),
    ball(5.4),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::directional(Vec3::new(-0.6, 1.0, 0.35), Rgb::new(0.85, 0.82, 0.76)),
    Light::directional(UP, Rgb::new(0.12, 0.13, 0.15)),
];
