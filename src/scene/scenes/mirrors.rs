//! Two facing mirrors: light that never gets out.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::scene::{Background, Camera, Light, Material, Object, Scene, Shape};

/// A ball and a pillar between two mirrors that face each other: the deeper the tree, the longer the row of images.
pub const MIRRORS: Scene<'static, f32> =
    Scene::new(CAMERA, Background::Solid(Rgb::new(0.35, 0.45, 0.6))).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.75, 1.35, 2.6), Vec3::new(-0.2, 0.95, 0.0), UP, 62.0);

const FLOOR: Material<f32> =
    Material::patterned(checker(Rgb::grey(0.8), Rgb::new(0.15, 0.25, 0.2), 0.5)).with_shares(0.05, 0.1, 0.75);
const MIRROR: Material<f32> = Material::mirror(Rgb::new(0.9, 0.93, 0.91));
const RED: Material<f32> =
    Material::matte(Rgb::new(0.8, 0.12, 0.08)).with_shares(0.05, 0.1, 0.8).with_highlight(Rgb::grey(0.5), 50);
const YELLOW: Material<f32> = Material::matte(Rgb::new(0.85, 0.6, 0.1)).with_shares(0.05, 0.1, 0.8);

const OBJECTS: [Object<'static, f32>; 5] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), FLOOR),
    Object::new(Shape::axis_box(Vec3::new(-2.2, 0.0, -2.1), Vec3::new(2.2, 2.4, -2.0)), MIRROR),
    Object::new(Shape::axis_box(Vec3::new(-2.2, 0.0, 3.0), Vec3::new(2.2, 2.4, 3.1)), MIRROR),
    Object::new(Shape::sphere(Vec3::new(-0.6, 0.5, 0.3), 0.5), RED),
    Object::new(Shape::cylinder(Vec3::new(0.75, 0.0, -0.4), Vec3::new(0.75, 1.3, -0.4), 0.2).capped(), YELLOW),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::point(Vec3::new(1.3, 4.5, 1.5), Rgb::grey(0.85)),
    Light::directional(Vec3::new(-0.4, 1.0, 0.1), Rgb::grey(0.15)),
];
