//! A glass of water.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::optics::materials;
use crate::scene::{Background, Camera, Light, Material, Medium, Object, Pattern, Scene, Shape, Triangle};

/// A glass of water with ice and a straw.
///
/// Four transparent things lie within each other. Each place belongs to the one of the highest priority that holds it,
/// so that every border is one between the two media that meet there (Schmidt and Budge, "Simple Nested Dielectrics in
/// Ray Traced Images", 2002). Look at the straw, which breaks at the water, at the ice, which hardly shows in water and
/// well above it, and at the bottom of the glass. Eight bounces show all this; twelve add the last glints.
pub const GLASS: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 2.7, 7.4), Vec3::new(0.15, 1.4, 0.0), UP, 27.0);

const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.9, 0.95, 1.0), above: Rgb::new(0.1, 0.25, 0.5), up: UP };

const TABLE: Material<f32> =
    Material::patterned(checker(Rgb::new(0.8, 0.76, 0.7), Rgb::new(0.5, 0.3, 0.2), 1.0)).with_shares(0.05, 0.1, 0.8);

/// The glass, bottom and all, is a solid cone.
const SOLID: Medium<f32> =
    Medium::new(materials::CROWN_GLASS).with_attenuation(Rgb::new(0.5, 0.15, 0.3)).with_priority(1);
/// Air takes its inside out of it.
const AIR: Medium<f32> = Medium::new(1.0).with_priority(2);
/// Water takes the place of air. It reaches a little into the wall, so that there is no air between water and glass.
const WATER: Medium<f32> = Medium::new(materials::WATER).with_attenuation(Rgb::new(0.2, 0.07, 0.03)).with_priority(3);
/// Ice takes the place of water and of air.
const ICE: Medium<f32> = Medium::new(materials::ICE).with_priority(4);

/// What shines by itself, brighter than white.
const LAMP: Material<f32> = Material::matte(Rgb::grey(0.9)).with_shares(5.0, 0.0, 0.0);

const STRAW: Material<f32> = Material::patterned(Pattern::Checker {
    even: Rgb::grey(0.9),
    odd: Rgb::new(0.85, 0.08, 0.06),
    u: Vec3::new(0.0, 5.0, 0.0),
    v: Vec3::ZERO,
})
.with_shares(0.1, 0.1, 0.7);

/// Around the y axis, by the slope of the wall; its radius is so much more than that of the inner wall.
const fn frustum(from: f32, to: f32, more: f32) -> Shape<'static, f32> {
    let (base, apex) = (0.68 + 0.1 * from + more, 0.68 + 0.1 * to + more);
    Shape::cone(Vec3::new(0.0, from, 0.0), base, Vec3::new(0.0, to, 0.0), apex).capped()
}

/// The corners of a cube's triangles, counter-clockwise from outside; bit k of a corner is its side along axis k.
const CORNERS: [u8; 36] =
    [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6];

/// A cube turned by a quaternion (w, x, y, z) of any length.
#[allow(clippy::indexing_slicing)] // In range by the tables; iterators are not const.
const fn cube(center: Vec3<f32>, half: f32, [w, x, y, z]: [f32; 4]) -> [Triangle<f32>; 12] {
    let s = half / (w * w + x * x + y * y + z * z);
    let mut triangles = [Triangle { vertices: [center; 3] }; 12];
    let mut i = 0;
    while i < CORNERS.len() {
        let corner = CORNERS[i];
        let p = if corner & 1 == 0 { -s } else { s };
        let q = if corner & 2 == 0 { -s } else { s };
        let r = if corner & 4 == 0 { -s } else { s };
        triangles[i / 3].vertices[i % 3] = Vec3::new(
            center.x + p * (w * w + x * x - y * y - z * z) + 2.0 * (q * (x * y - w * z) + r * (x * z + w * y)),
            center.y + q * (w * w - x * x + y * y - z * z) + 2.0 * (p * (x * y + w * z) + r * (y * z - w * x)),
            center.z + r * (w * w - x * x - y * y + z * z) + 2.0 * (p * (x * z - w * y) + q * (y * z + w * x)),
        );
        i += 1;
    }
    triangles
}

const CUBES: [[Triangle<f32>; 12]; 2] = [
    cube(Vec3::new(-0.38, 1.55, 0.0), 0.28, [4.0, 0.4, 1.2, 0.3]),
    cube(Vec3::new(0.34, 1.52, 0.3), 0.28, [4.0, 0.3, -0.8, -0.4]),
];

const OBJECTS: [Object<'static, f32>; 7] = [
    Object::new(Shape::axis_box(Vec3::new(-9.0, 3.0, 2.0), Vec3::new(-8.0, 8.0, 6.0)), LAMP).without_shadow(),
    Object::new(Shape::axis_box(Vec3::new(-7.0, -0.4, -7.0), Vec3::new(7.0, 0.0, 7.0)), TABLE),
    Object::new(frustum(0.001, 2.4, 0.07), Material::transparent(SOLID)).with_tinted_shadow(),
    Object::new(frustum(0.22, 2.45, 0.0), Material::transparent(AIR)).with_tinted_shadow(),
    Object::new(frustum(0.21, 1.7, 0.004), Material::transparent(WATER)).with_tinted_shadow(),
    Object::new(Shape::Triangles(CUBES.as_flattened()), Material::transparent(ICE)).with_tinted_shadow(),
    Object::new(Shape::cylinder(Vec3::new(-0.4, 0.3, -0.3), Vec3::new(1.0, 3.0, -0.45), 0.07).capped(), STRAW),
];

const LIGHTS: [Light<f32>; 2] = [
    Light::directional(Vec3::new(-0.7, 1.0, 0.45), Rgb::new(0.8, 0.78, 0.74)),
    Light::point(Vec3::new(3.0, 6.0, 5.0), Rgb::grey(0.2)),
];
