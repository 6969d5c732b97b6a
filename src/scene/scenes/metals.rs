//! Six metals on a varnished table.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::optics::materials::{self, Conductor};
use crate::scene::{Background, Camera, Light, Material, Object, Pattern, Scene, Shape};

/// Balls of six metals, each by its measured complex index of refraction, and a row of lamps on a varnished table that
/// runs away from the eye. From the front: copper and gold, silver, iron, aluminium and chromium.
///
/// The varnish reflects more the flatter light meets it, as the Fresnel equations have it: 7 % in the foreground, where
/// the wood shows, and 80 % at the far end, where the table is a mirror. Compare each lamp with its reflection, and
/// follow those of the windows towards the eye. The metals have no colour but that of their reflectance.
pub const METALS: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 2.3, 7.0), Vec3::new(0.0, 0.55, 0.0), UP, 42.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.6, 0.5, 0.4), above: Rgb::new(0.06, 0.07, 0.1), up: UP };

const WOOD: Material<f32> = Material::patterned(Pattern::Checker {
    even: Rgb::new(0.3, 0.12, 0.045),
    odd: Rgb::new(0.2, 0.075, 0.03),
    u: Vec3::new(1.0 / 0.6, 0.0, 0.0),
    v: Vec3::new(0.0, 0.0, 1.0 / 3.0),
})
.with_coat(1.5);

/// What shines by itself and takes no light.
const LAMP: Material<f32> = Material::matte(Rgb::new(0.98, 0.95, 0.88)).with_shares(1.0, 0.0, 0.0);

const fn metal(x: f32, z: f32, metal: Conductor) -> Object<'static, f32> {
    Object::new(Shape::sphere(Vec3::new(x, 0.7, z), 0.7), Material::conductor(metal.index, metal.extinction))
}

const fn lamp(z: f32) -> Object<'static, f32> {
    Object::new(Shape::sphere(Vec3::new(0.55, 0.12, z), 0.12), LAMP).without_shadow()
}

const fn panel(min: Vec3<f32>, max: Vec3<f32>) -> Object<'static, f32> {
    Object::new(Shape::axis_box(min, max), LAMP).without_shadow()
}

/// A bright window behind the far end of the table.
const fn window(x: f32) -> Object<'static, f32> {
    panel(Vec3::new(x - 2.5, 1.0, -46.0), Vec3::new(x + 2.5, 10.0, -45.0))
}

const OBJECTS: [Object<'static, f32>; 21] = [
    Object::new(Shape::axis_box(Vec3::new(-6.0, -0.3, -40.0), Vec3::new(6.0, 0.0, 8.0)), WOOD),
    metal(-1.35, 2.4, materials::COPPER),
    metal(1.6, 1.2, materials::GOLD),
    metal(-0.7, -1.0, materials::SILVER),
    metal(3.9, -3.5, materials::IRON),
    metal(-3.8, -6.0, materials::ALUMINIUM),
    metal(2.2, -9.0, materials::CHROMIUM),
    lamp(3.1),
    lamp(1.6),
    lamp(-0.8),
    lamp(-4.0),
    lamp(-8.0),
    lamp(-13.0),
    lamp(-20.0),
    window(-15.5),
    window(-5.0),
    window(5.0),
    window(15.5),
    panel(Vec3::new(-9.0, 1.5, -6.0), Vec3::new(-8.8, 6.5, 6.0)),
    panel(Vec3::new(8.8, 2.5, -2.0), Vec3::new(9.0, 5.0, 4.0)),
    panel(Vec3::new(-2.0, 8.0, -3.0), Vec3::new(2.0, 8.2, 3.0)),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::sphere(Vec3::new(0.0, 7.5, 0.0), 0.8, Rgb::new(0.95, 0.9, 0.82)),
    Light::sphere(Vec3::new(-8.7, 4.0, 1.0), 0.8, Rgb::new(0.5, 0.48, 0.45)),
];
