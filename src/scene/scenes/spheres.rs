//! A reflective sphere, a transmissive one, and one that is both by the angle.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::scene::{Background, Camera, Interface, Light, Material, Medium, Object, Scene, Shape};

/// Three spheres of a lecture on reflection and transmission: constant k_r, constant k_t, and Fresnel's division.
pub const SPHERES: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 2.2, 8.0), Vec3::new(0.0, 0.8, 0.0), UP, 36.0);
const SKY: Background<f32> = Background::Gradient { below: Rgb::grey(0.8), above: Rgb::new(0.2, 0.35, 0.7), up: UP };

const FLOOR: Material<f32> =
    Material::patterned(checker(Rgb::grey(0.85), Rgb::new(0.55, 0.1, 0.08), 0.8)).with_shares(0.05, 0.1, 0.75);
const WALL: Material<f32> = Material::matte(Rgb::new(0.75, 0.72, 0.65)).with_shares(0.05, 0.1, 0.75);
const REFLECTIVE: Material<f32> = Material::matte(Rgb::new(0.1, 0.1, 0.12))
    .with_highlight(Rgb::grey(0.6), 80)
    .with_interface(Interface::Mirror { reflected: Rgb::grey(0.8) });
const TRANSMISSIVE: Material<f32> = Material::dielectric(1.5).with_interface(Interface::Constant {
    reflected: Rgb::grey(0.1),
    transmitted: Rgb::new(0.85, 0.9, 0.88),
    medium: Medium::new(1.5),
});

const OBJECTS: [Object<'static, f32>; 5] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), FLOOR),
    Object::new(Shape::plane(Vec3::new(0.0, 0.0, -6.0), Vec3::new(0.0, 0.0, 1.0)), WALL),
    Object::new(Shape::sphere(Vec3::new(-2.1, 0.9, 0.0), 0.9), REFLECTIVE),
    Object::new(Shape::sphere(Vec3::new(0.0, 0.9, 0.4), 0.9), TRANSMISSIVE),
    Object::new(Shape::sphere(Vec3::new(2.1, 0.9, 0.0), 0.9), Material::dielectric(1.5)).without_shadow(),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::point(Vec3::new(3.0, 6.0, 5.0), Rgb::grey(0.8)),
    Light::point(Vec3::new(-5.0, 4.0, 3.0), Rgb::new(0.2, 0.22, 0.3)),
];
