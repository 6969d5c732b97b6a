//! Glass, gold, plastic and a checkered floor.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::scene::{Background, Camera, Interface, Light, Material, Object, Pattern, Scene, Shape};

/// A glass ball between a gold ball, a plastic ball, a painted box and a cone, on a glossy checkered floor.
pub const SHOWCASE: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.6, 2.3, 7.0), Vec3::new(0.1, 0.85, 0.0), UP, 36.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.75, 0.8, 0.85), above: Rgb::new(0.1, 0.22, 0.5), up: UP };

const FLOOR: Material<f32> = Material::patterned(checker(Rgb::new(0.82, 0.8, 0.76), Rgb::new(0.07, 0.08, 0.1), 1.0))
    .with_shares(0.04, 0.08, 0.75)
    .with_interface(Interface::Metal { r0: Rgb::grey(0.04) });
const GOLD: Material<f32> = Material::metal(Rgb::new(1.0, 0.76, 0.33)).with_highlight(Rgb::new(0.9, 0.7, 0.3), 120);
const GLASS: Material<f32> = Material::dielectric(1.5).with_highlight(Rgb::grey(0.5), 400);
const PLASTIC: Material<f32> = Material::matte(Rgb::new(0.75, 0.06, 0.05))
    .with_shares(0.03, 0.1, 0.8)
    .with_highlight(Rgb::grey(0.55), 60)
    .with_interface(Interface::Metal { r0: Rgb::grey(0.04) });
const PAINT: Material<f32> = Material::matte(Rgb::new(0.06, 0.2, 0.55)).with_shares(0.05, 0.1, 0.8);
const GREENS: Material<f32> = Material::patterned(Pattern::Gradient {
    from: Rgb::new(0.9, 0.85, 0.2),
    to: Rgb::new(0.02, 0.35, 0.2),
    origin: Vec3::ZERO,
    axis: Vec3::new(0.0, 0.6, 0.0),
})
.with_shares(0.05, 0.1, 0.8);

const OBJECTS: [Object<'static, f32>; 6] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), FLOOR),
    Object::new(Shape::sphere(Vec3::new(0.15, 1.0, 0.9), 1.0), GLASS).without_shadow(),
    Object::new(Shape::sphere(Vec3::new(-2.15, 1.05, -0.9), 1.05), GOLD),
    Object::new(Shape::sphere(Vec3::new(1.75, 0.5, 1.75), 0.5), PLASTIC),
    Object::new(Shape::axis_box(Vec3::new(1.5, 0.0, -1.9), Vec3::new(2.8, 1.3, -0.6)), PAINT),
    Object::new(Shape::cone(Vec3::new(0.0, 0.0, -2.6), 0.8, Vec3::new(0.0, 1.7, -2.6), 0.15).capped(), GREENS),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::point(Vec3::new(4.5, 7.0, 5.0), Rgb::new(0.95, 0.9, 0.82)),
    Light::directional(Vec3::new(-0.7, 0.8, 0.5), Rgb::new(0.16, 0.19, 0.25)),
];
