//! A mirage on a hot road.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, Camera, Law, Level, Light, Material, Medium, Method, Object, Pattern, Profile, Scene, Shape, Steps,
};

/// A hot road that looks wet: an inferior mirage, seen through a telescope by an eye 1.3 m over the road.
///
/// The air is at 30 °C, and 40 K hotter at the road; the heat is gone some centimetres above it. Light that comes down to
/// the road more flatly than √(2·Δn), 8 mrad, is bent up again before it gets there. So from 170 m on no road is seen but
/// the sky in its place, and the car, 300 m away, stands over its own mirror image. Look at the marks on the road, which end
/// where the water seems to begin, and at the posts, of which the first pair is 200 m away and the last one 400 m: the
/// further away, the more of a post is mirrored, and its foot is not seen. One unit is a metre.
pub const MIRAGE: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(HAZE))
    .with_objects(&OBJECTS)
    .with_lights(&LIGHTS)
    .with_profiles(&PROFILES)
    .with_medium(Medium::graded(0));

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.7, 1.3, 0.0), Vec3::new(-0.1, 0.0, -300.0), UP, 1.5);

const PROFILES: [Profile<'static, f32>; 1] = [Profile {
    level: Level::Height { origin: Vec3::ZERO, up: UP },
    from: -0.01,
    to: 0.4,
    law: Law::warm_air(303.0, 40.0, 0.025),
    method: Method::Steps(Steps::Controlled { tolerance: 1e-6 }),
}];

const HAZE: Rgb<f32> = Rgb::new(0.8, 0.86, 0.9);
const BLUE: Rgb<f32> = Rgb::new(0.3, 0.52, 0.85);

/// In the light of the sun and of the sky.
const fn plain(color: Rgb<f32>) -> Material<f32> {
    Material::matte(color).with_shares(0.4, 0.0, 0.6)
}

const fn glow(color: Pattern<f32>) -> Material<f32> {
    Material::patterned(color).with_shares(1.0, 0.0, 0.0)
}

const ROAD: Material<f32> = plain(Rgb::new(0.17, 0.165, 0.16));
const PAINT: Material<f32> = plain(Rgb::new(0.8, 0.78, 0.7));
const SAND: Material<f32> = plain(Rgb::new(0.62, 0.46, 0.28));
const RED: Material<f32> = plain(Rgb::new(0.75, 0.04, 0.03)).with_highlight(Rgb::grey(0.3), 30);
const WINDOW: Material<f32> = plain(Rgb::new(0.1, 0.14, 0.18));
const BLACK: Material<f32> = plain(Rgb::grey(0.03));
const LAMP: Material<f32> = glow(Pattern::Solid(Rgb::new(1.0, 0.95, 0.75)));
/// From pale to blue over 20 mrad.
const SKY: Material<f32> =
    glow(Pattern::Gradient { from: HAZE, to: BLUE, origin: Vec3::ZERO, axis: Vec3::new(0.0, 1.0 / 400.0, 0.0) });

const fn block(min: [f32; 3], max: [f32; 3], material: Material<f32>) -> Object<'static, f32> {
    let [a, b, c] = min;
    let [d, e, f] = max;
    Object::new(Shape::axis_box(Vec3::new(a, b, c), Vec3::new(d, e, f)), material)
}

/// A mark in the middle of the road, on it by some millimetres.
const fn mark(z: f32) -> Object<'static, f32> {
    block([-0.08, -0.1, -z - 6.0], [0.08, 0.003, -z], PAINT)
}

const fn line(x: f32) -> Object<'static, f32> {
    block([x - 0.07, -0.1, -2000.0], [x + 0.07, 0.003, 0.0], PAINT)
}

const fn post(x: f32, z: f32) -> Object<'static, f32> {
    block([x - 0.06, -0.1, -z - 0.06], [x + 0.06, 1.0, -z + 0.06], PAINT)
}

const fn band(x: f32, z: f32) -> Object<'static, f32> {
    block([x - 0.065, 0.7, -z - 0.065], [x + 0.065, 0.85, -z + 0.065], BLACK)
}

const fn hill(x: f32, radius: f32, height: f32, color: Rgb<f32>) -> Object<'static, f32> {
    let center = Vec3::new(x, height - radius, -9000.0);
    Object::new(Shape::sphere(center, radius), glow(Pattern::Solid(color))).without_shadow()
}

/// Of the front of the car.
const Z: f32 = -300.0;
/// Of its middle; it comes towards the eye on its side of the road.
const X: f32 = -1.25;

const fn part(x: [f32; 2], y: [f32; 2], z: [f32; 2], material: Material<f32>) -> Object<'static, f32> {
    block([X + x[0], y[0], Z - z[1]], [X + x[1], y[1], Z - z[0]], material)
}

const fn wheel(x: f32, z: f32) -> Object<'static, f32> {
    let (from, to) = (Vec3::new(X + x - 0.1, 0.33, Z - z), Vec3::new(X + x + 0.1, 0.33, Z - z));
    Object::new(Shape::cylinder(from, to, 0.33).capped(), BLACK)
}

const fn lamp(x: f32) -> Object<'static, f32> {
    Object::new(Shape::sphere(Vec3::new(X + x, 0.68, Z), 0.12), LAMP).without_shadow()
}

const OBJECTS: [Object<'static, f32>; 46] = [
    Object::new(Shape::plane(Vec3::new(0.0, -0.003, 0.0), UP), SAND),
    block([-2.6, -0.1, -2000.0], [2.6, 0.0, 10.0], ROAD),
    line(-2.4),
    line(2.4),
    mark(60.0),
    mark(72.0),
    mark(84.0),
    mark(96.0),
    mark(108.0),
    mark(120.0),
    mark(132.0),
    mark(144.0),
    mark(156.0),
    mark(168.0),
    mark(180.0),
    post(-3.1, 200.0),
    post(-3.1, 250.0),
    post(-3.1, 300.0),
    post(-3.1, 350.0),
    post(-3.1, 400.0),
    post(3.1, 200.0),
    post(3.1, 250.0),
    post(3.1, 300.0),
    post(3.1, 350.0),
    post(3.1, 400.0),
    band(-3.1, 200.0),
    band(-3.1, 250.0),
    band(-3.1, 300.0),
    band(3.1, 200.0),
    band(3.1, 250.0),
    band(3.1, 300.0),
    part([-0.88, 0.88], [0.25, 0.85], [0.0, 4.2], RED),
    part([-0.72, 0.72], [0.85, 1.38], [1.3, 3.6], WINDOW),
    part([-0.76, 0.76], [1.36, 1.46], [1.25, 3.65], RED),
    part([-0.45, 0.45], [0.42, 0.6], [-0.02, 0.1], BLACK),
    part([-1.04, -0.88], [0.88, 1.0], [1.4, 1.5], RED),
    part([0.88, 1.04], [0.88, 1.0], [1.4, 1.5], RED),
    wheel(-0.72, 0.7),
    wheel(0.72, 0.7),
    wheel(-0.72, 3.4),
    wheel(0.72, 3.4),
    lamp(-0.66),
    lamp(0.66),
    hill(-150.0, 900.0, 30.0, Rgb::new(0.42, 0.5, 0.62)),
    hill(170.0, 600.0, 45.0, Rgb::new(0.36, 0.45, 0.58)),
    block([-3000.0, -400.0, -20001.0], [3000.0, 3000.0, -20000.0], SKY).without_shadow(),
];

const LIGHTS: [Light<f32>; 1] = [Light::directional(Vec3::new(0.5, 0.8, 0.6), Rgb::new(1.0, 0.97, 0.92))];
