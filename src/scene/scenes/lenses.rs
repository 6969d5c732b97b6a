//! Two lenses of graded glass and one of plain glass.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, Camera, Law, Level, Light, Material, Medium, Method, Object, Pattern, Profile, Scene, Shape, Steps,
};

/// Three balls of the same size on a checkered floor: Luneburg's lens on the left, plain glass in the middle, Maxwell's
/// fish-eye on the right.
///
/// The index of the two lenses is that of the air at the rim, so that they mirror nothing and light enters them unbent;
/// plain glass has its mirror image of the sky and a bright rim. Luneburg's lens brings all parallel light to one point of
/// its far side. So an eye far away sees the world from that point: the whole half behind the ball, upside down, in a
/// circle. The fish-eye bends light twice as much, along circles: at its right rim the ball of glass is seen. Glass bends
/// light at its surface alone.
pub const LENSES: Scene<'static, f32> =
    Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS).with_profiles(&PROFILES);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.3, 2.1, 9.0), Vec3::new(0.04, 0.95, 0.0), UP, 31.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.95, 0.9, 0.85), above: Rgb::new(0.12, 0.3, 0.75), up: UP };

const LUNEBURG: Vec3<f32> = Vec3::new(-2.3, 1.02, 0.0);
const GLASS: Vec3<f32> = Vec3::new(0.0, 1.02, 0.0);
const FISH_EYE: Vec3<f32> = Vec3::new(2.3, 1.02, 0.0);

const PROFILES: [Profile<'static, f32>; 2] = [
    ball(LUNEBURG, Law::luneburg(1.0), Steps::Fixed { length: 0.02 }),
    ball(FISH_EYE, Law::FishEye { index: 2.0, radius: 1.0 }, Steps::Controlled { tolerance: 1e-5 }),
];

const fn ball(center: Vec3<f32>, law: Law<'static, f32>, steps: Steps<f32>) -> Profile<'static, f32> {
    let level = Level::Radius { center, radius: 0.0 };
    Profile { level, from: 0.0, to: 1.0, law, method: Method::Steps(steps) }
}

/// A little grey, for a shadow.
const TINT: Rgb<f32> = Rgb::new(0.16, 0.12, 0.1);

const fn lens(center: Vec3<f32>, medium: Medium<f32>) -> Object<'static, f32> {
    Object::new(Shape::sphere(center, 1.0), Material::transparent(medium.with_attenuation(TINT))).with_tinted_shadow()
}

const FLOOR: Pattern<f32> = checker(Rgb::new(0.85, 0.82, 0.75), Rgb::new(0.22, 0.26, 0.3), 0.8);

const fn pillar(x: f32, z: f32, color: Rgb<f32>) -> Object<'static, f32> {
    let shape = Shape::cylinder(Vec3::new(x, 0.0, z), Vec3::new(x, 2.4, z), 0.22).capped();
    Object::new(shape, Material::matte(color).with_shares(0.1, 0.0, 0.9))
}

const RED: Rgb<f32> = Rgb::new(0.85, 0.1, 0.06);
const YELLOW: Rgb<f32> = Rgb::new(0.95, 0.7, 0.08);
const BLUE: Rgb<f32> = Rgb::new(0.1, 0.25, 0.8);

const OBJECTS: [Object<'static, f32>; 10] = [
    Object::new(Shape::axis_box(Vec3::new(-9.0, -0.5, -9.0), Vec3::new(9.0, 0.0, 12.0)), Material::patterned(FLOOR)),
    lens(LUNEBURG, Medium::graded(0)),
    lens(GLASS, Medium::new(1.5)),
    lens(FISH_EYE, Medium::graded(1)),
    pillar(-5.0, -4.0, RED),
    pillar(-3.4, -4.0, YELLOW),
    pillar(-1.2, -4.0, BLUE),
    pillar(1.2, -4.0, RED),
    pillar(3.4, -4.0, YELLOW),
    pillar(5.0, -4.0, BLUE),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::directional(Vec3::new(-0.5, 1.0, 0.45), Rgb::new(0.8, 0.77, 0.72)),
    Light::directional(Vec3::new(0.6, 0.5, -0.3), Rgb::new(0.2, 0.22, 0.25)),
];
