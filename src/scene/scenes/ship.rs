//! A ship in the air over a cold sea.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, Camera, Law, Level, Light, Material, Medium, Method, Object, Pattern, Profile, Scene, Shape, Steps,
};

/// A superior mirage: one ship, 18 km away on a cold sea, that is seen three times.
///
/// Over the cold air on the sea lies air that is 8 K warmer, 30 m high. Light that goes up into it flatly is bent down again:
/// over the ship hangs its mirror image, upside down and stretched to twice its height, and on the hull of that one stands
/// a third image, erect again and very flat. Look at the funnel and at the masts, of which each is there three times. The
/// eye is 10 m over the sea, at a strong telescope. One unit is a metre.
///
/// The sea is flat here and ends in a bank of haze. The roundness of the Earth, which lowers a ship at that distance by 25 m,
/// is left out.
pub const SHIP: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(HIGH))
    .with_objects(&OBJECTS)
    .with_lights(&LIGHTS)
    .with_profiles(&PROFILES)
    .with_medium(Medium::graded(0));

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 10.0, 0.0), Vec3::new(0.0, 38.0, -18_000.0), UP, 0.33);

const PROFILES: [Profile<'static, f32>; 1] = [Profile {
    level: Level::Height { origin: Vec3::ZERO, up: UP },
    from: -1.0,
    to: 80.0,
    law: Law::inversion(277.0, 285.0, 30.0, 2.5),
    method: Method::Steps(Steps::Controlled { tolerance: 1e-6 }),
}];

const LOW: Rgb<f32> = Rgb::new(0.92, 0.76, 0.62);
const HIGH: Rgb<f32> = Rgb::new(0.42, 0.56, 0.75);
const SEA: Pattern<f32> = Pattern::Gradient {
    from: Rgb::new(0.06, 0.13, 0.2),
    to: Rgb::new(0.3, 0.4, 0.48),
    origin: Vec3::new(0.0, 0.0, -7000.0),
    axis: Vec3::new(0.0, 0.0, -1.0 / 14_000.0),
};
/// The bank of haze, and what of the sky is seen over it.
const SKY: Pattern<f32> =
    Pattern::Gradient { from: LOW, to: HIGH, origin: Vec3::ZERO, axis: Vec3::new(0.0, 1.0 / 120.0, 0.0) };

const fn glow(light: Pattern<f32>) -> Material<f32> {
    Material::patterned(light).with_shares(1.0, 0.0, 0.0)
}

const fn paint(r: f32, g: f32, b: f32) -> Material<f32> {
    Material::matte(Rgb::new(r, g, b)).with_shares(0.4, 0.0, 0.6)
}

const HULL: Material<f32> = paint(0.12, 0.14, 0.2);
const KEEL: Material<f32> = paint(0.5, 0.08, 0.05);
const WHITE: Material<f32> = paint(0.85, 0.85, 0.82);
const FUNNEL: Material<f32> = paint(0.8, 0.15, 0.08);
const BLACK: Material<f32> = paint(0.05, 0.05, 0.06);

/// Where the ship is.
const Z: f32 = -18_000.0;

const fn part(x: [f32; 2], y: [f32; 2], material: Material<f32>) -> Object<'static, f32> {
    let min = Vec3::new(x[0], y[0], Z - 8.0);
    Object::new(Shape::axis_box(min, Vec3::new(x[1], y[1], Z + 8.0)), material)
}

const fn tube(x: f32, y: [f32; 2], radius: f32, material: Material<f32>) -> Object<'static, f32> {
    let shape = Shape::cylinder(Vec3::new(x, y[0], Z), Vec3::new(x, y[1], Z), radius).capped();
    Object::new(shape, material)
}

const OBJECTS: [Object<'static, f32>; 13] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), glow(SEA)),
    Object::new(Shape::axis_box(Vec3::new(-9000.0, -10.0, -20_501.0), Vec3::new(9000.0, 9000.0, -20_500.0)), glow(SKY))
        .without_shadow(),
    part([-54.0, 50.0], [2.5, 11.0], HULL),
    part([-53.0, 48.0], [-1.0, 2.5], KEEL),
    part([36.0, 57.0], [7.0, 13.0], HULL),
    part([-50.0, -23.0], [11.0, 16.0], WHITE),
    part([-46.0, -27.0], [16.0, 18.0], WHITE),
    tube(-37.0, [18.0, 21.0], 3.4, FUNNEL),
    tube(-37.0, [21.0, 22.0], 3.5, BLACK),
    tube(-5.0, [11.0, 20.5], 0.7, BLACK),
    tube(26.0, [11.0, 22.0], 0.7, BLACK),
    part([-18.0, -8.0], [11.0, 13.0], FUNNEL),
    part([3.0, 20.0], [11.0, 14.0], WHITE),
];

const LIGHTS: [Light<f32>; 1] = [Light::directional(Vec3::new(0.6, 0.5, 1.0), Rgb::new(1.0, 0.95, 0.88))];
