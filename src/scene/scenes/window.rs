//! Snell's window.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::optics::materials;
use crate::scene::{Background, Camera, Light, Material, Medium, Object, Pattern, Scene, Shape};

/// What a fish sees that looks straight up from the bottom of a pool: the whole world above the water, down to the
/// horizon, in a circle of 48.6° around the zenith. Around it the surface is a perfect mirror of the pool.
///
/// The rim of the circle is at the critical angle θ, where sin θ = 1/n; outside of it the reflection is total. Look at
/// the leaning pole, which breaks at the surface, and at the pillars, which stand on the rim. One unit is a metre: the
/// water takes the red light from all that is far.
pub const WINDOW: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

// Not quite in the middle, where sight lines would go along the borders of tiles.
const CAMERA: Camera<f32> =
    Camera::look_at(Vec3::new(0.06, -3.0, 0.04), Vec3::new(0.06, 0.0, 0.04), Vec3::new(0.0, 0.0, -1.0), 114.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(1.5, 1.4, 1.2), above: Rgb::new(0.15, 0.38, 0.9), up: UP };

const X: Vec3<f32> = Vec3::new(1.0, 0.0, 0.0);
const Z: Vec3<f32> = Vec3::new(0.0, 0.0, 1.0);

const WATER: Material<f32> =
    Material::transparent(Medium::new(materials::WATER).with_attenuation(materials::WATER_EXTINCTION));
const STONE: Material<f32> = Material::matte(Rgb::new(0.75, 0.68, 0.55)).with_shares(0.3, 0.0, 0.7);
const WOOD: Material<f32> = Material::matte(Rgb::new(0.6, 0.33, 0.15)).with_shares(0.3, 0.0, 0.7);
const RED: Material<f32> = Material::matte(Rgb::new(0.9, 0.1, 0.05)).with_shares(0.3, 0.0, 0.7);
const SUN: Material<f32> = Material::matte(Rgb::new(1.0, 0.97, 0.9)).with_shares(1.0, 0.0, 0.0);

/// Squares of half a metre on a wall or a floor that runs in two directions.
const fn tiles(u: Vec3<f32>, v: Vec3<f32>) -> Material<f32> {
    let [u, v] = [Vec3::new(2.0 * u.x, 2.0 * u.y, 2.0 * u.z), Vec3::new(2.0 * v.x, 2.0 * v.y, 2.0 * v.z)];
    let color = Pattern::Checker { even: Rgb::new(0.9, 0.9, 0.88), odd: Rgb::new(0.35, 0.6, 0.65), u, v };
    Material::patterned(color).with_shares(0.3, 0.0, 0.7)
}

const fn ground(min: Vec3<f32>, max: Vec3<f32>, along: Vec3<f32>) -> Object<'static, f32> {
    Object::new(Shape::axis_box(min, max), tiles(along, UP))
}

const fn pillar(x: f32, z: f32) -> Object<'static, f32> {
    Object::new(Shape::cylinder(Vec3::new(x, 0.0, z), Vec3::new(x, 6.0, z), 0.4).capped(), STONE)
}

const fn post(x: f32, z: f32) -> Object<'static, f32> {
    Object::new(Shape::cylinder(Vec3::new(x, -4.0, z), Vec3::new(x, 1.0, z), 0.1).capped(), WOOD)
}

const OBJECTS: [Object<'static, f32>; 19] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), WATER).with_tinted_shadow(),
    Object::new(Shape::plane(Vec3::new(0.0, -3.5, 0.0), UP), tiles(X, Z)),
    ground(Vec3::new(-99.0, -4.0, -99.0), Vec3::new(99.0, 0.1, -4.5), X),
    ground(Vec3::new(-99.0, -4.0, 4.5), Vec3::new(99.0, 0.1, 99.0), X),
    ground(Vec3::new(-99.0, -4.0, -4.5), Vec3::new(-10.0, 0.1, 4.5), Z),
    ground(Vec3::new(10.0, -4.0, -4.5), Vec3::new(99.0, 0.1, 4.5), Z),
    pillar(-6.0, -6.0),
    pillar(-2.0, -6.0),
    pillar(2.0, -6.0),
    pillar(6.0, -6.0),
    pillar(-6.0, 6.0),
    pillar(-2.0, 6.0),
    Object::new(Shape::axis_box(Vec3::new(1.5, 1.0, -0.6), Vec3::new(12.0, 1.15, 0.6)), WOOD),
    post(1.7, -0.5),
    post(1.7, 0.5),
    Object::new(Shape::cylinder(Vec3::new(-1.6, -4.0, -2.6), Vec3::new(-1.2, 3.0, 0.9), 0.06).capped(), RED),
    Object::new(Shape::axis_box(Vec3::new(-1.0, -0.25, 1.2), Vec3::new(0.8, 0.4, 1.9)), RED),
    Object::new(Shape::sphere(Vec3::new(-6.6, -2.8, -1.0), 0.7), RED),
    Object::new(Shape::sphere(Vec3::new(-30.0, 80.0, -25.0), 5.0), SUN).without_shadow(),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::directional(Vec3::new(-0.3, 0.8, -0.25), Rgb::new(0.95, 0.92, 0.85)),
    Light::directional(Vec3::new(0.5, 0.6, 0.5), Rgb::new(0.2, 0.22, 0.25)),
];
