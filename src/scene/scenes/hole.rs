//! A black hole.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::scene::{Background, BlackHole, Camera, Light, Material, Object, Pattern, Scene, Shape, Steps};

/// A black hole, the disc of hot gas around it, a ball far behind it and one beside it, under the stars. One unit is the
/// mass of the hole, GM/c².
///
/// The disc is flat, as its front shows. Its far side stands over the hole nevertheless, and its underside is below it:
/// light from there is bent around the hole. Further in, the same again as a thin ring, of the radius 3√3 units; inside of it
/// is the dark of light that would come from the hole. The blue ball is straight behind the hole and is seen as a ring around
/// all of it. The green one is stretched along such a ring. The disc's colours are those of paint: neither Doppler's shift
/// nor that of gravity is in them.
pub const HOLE: Scene<'static, f32> =
    Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS).with_black_hole(BLACK_HOLE);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 4.2, 39.8), Vec3::ZERO, Vec3::new(0.12, 1.0, 0.0), 45.0);

const SKY: Background<f32> =
    Background::Stars { sky: Rgb::new(0.004, 0.005, 0.01), brightness: 1.6, cells: 60, radius: 0.09 };

const BLACK_HOLE: BlackHole<f32> =
    BlackHole { center: Vec3::ZERO, mass: 1.0, steps: Steps::Controlled { tolerance: 1e-5 } };

/// A part of the disc, with rings of two colours.
const fn part(inner: f32, outer: f32, even: Rgb<f32>, odd: Rgb<f32>) -> Object<'static, f32> {
    let rings = Pattern::Rings { even, odd, center: Vec3::ZERO, width: 0.5 };
    glow(Shape::annulus(Vec3::ZERO, UP, inner, outer), rings)
}

const fn glow(shape: Shape<'static, f32>, light: Pattern<f32>) -> Object<'static, f32> {
    Object::new(shape, Material::patterned(light).with_shares(1.0, 0.0, 0.0)).without_shadow()
}

/// A ball of squares.
const fn ball(center: Vec3<f32>, radius: f32, even: Rgb<f32>, odd: Rgb<f32>) -> Object<'static, f32> {
    let side = 1.0 / (0.4 * radius);
    let color = Pattern::Checker { even, odd, u: Vec3::new(0.0, side, 0.0), v: Vec3::new(side, 0.0, 0.0) };
    Object::new(Shape::sphere(center, radius), Material::patterned(color).with_shares(0.35, 0.0, 0.65))
}

const OBJECTS: [Object<'static, f32>; 7] = [
    part(6.0, 7.0, Rgb::new(1.0, 0.95, 0.85), Rgb::new(1.0, 0.86, 0.62)),
    part(7.0, 8.0, Rgb::new(1.0, 0.78, 0.42), Rgb::new(0.95, 0.62, 0.28)),
    part(8.0, 9.5, Rgb::new(0.9, 0.5, 0.18), Rgb::new(0.75, 0.35, 0.1)),
    part(9.5, 11.0, Rgb::new(0.62, 0.26, 0.07), Rgb::new(0.45, 0.15, 0.035)),
    part(11.0, 12.5, Rgb::new(0.32, 0.09, 0.02), Rgb::new(0.18, 0.045, 0.012)),
    ball(Vec3::new(-5.0, -16.0, -180.0), 10.0, Rgb::new(0.04, 0.16, 0.6), Rgb::new(0.1, 0.4, 0.75)),
    ball(Vec3::new(13.0, 6.5, -12.0), 2.4, Rgb::new(0.08, 0.5, 0.12), Rgb::new(0.5, 0.75, 0.3)),
];

const LIGHTS: [Light<f32>; 1] = [Light::directional(Vec3::new(-0.4, 0.6, 1.0), Rgb::grey(1.0))];
