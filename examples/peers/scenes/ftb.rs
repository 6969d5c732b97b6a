//! The scene by which microcontrollers are compared in `RAYTRACER_sample` of hirakuni45/RX: Paul Heckbert's ray tracer on a
//! business card, as FTB wrote it anew for an ATtiny85.
//!
//! Where it differs: the sky there is (0.1, 0, 0.3) + (0.7, 0.2, 0.5)·(1 − z)⁴, and here the sum of both colours in place of the
//! second alone; the light on the balls is there by the square of the cosine; pixels are seen at their upper left corner; and the
//! random numbers that choose the points of the light are others.

use whit::scene::{Emitter, Pattern};
use whit::trace::Termination;
use whit::{Background, Camera, Interface, Light, Material, Object, Rgb, Scene, Shape, Vec3};

use super::{Peer, with_phong};

/// At the size at which it is measured.
pub const FTB: Peer = Peer { name: "ftb", scene: SCENE, size: [320, 240], depth: 2, termination: Termination::Black };

const UP: Vec3<f32> = Vec3::new(0.0, 0.0, 1.0);

const SCENE: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::with_half_height(Vec3::new(0.0, 0.0, 3.0), Vec3::new(1.0, 8.0, 4.0), UP, 0.45);

const SKY: Background<f32> = Background::Sky { horizon: Rgb::new(0.8, 0.2, 0.8), up: UP };

/// A square of side 1/8 around a point.
const LIGHTS: [Light<f32>; 1] = [Light {
    emitter: Emitter::Parallelogram {
        corner: Vec3::new(9.0 - 0.0625, 6.0 - 0.0625, 16.0),
        edge_u: Vec3::new(0.125, 0.0, 0.0),
        edge_v: Vec3::new(0.0, 0.125, 0.0),
    },
    color: Rgb::WHITE,
    falloff: None,
}];

const MIRROR: Material<f32> = material(Rgb::grey(0.8), 0.5);
const GREEN: Material<f32> = material(Rgb::new(0.0, 1.0, 0.0), 0.2);
const CYAN: Material<f32> = material(Rgb::new(0.0, 0.8, 0.8), 0.3);

const FLOOR: Material<f32> = Material::patterned(Pattern::Checker {
    even: Rgb::new(3.0, 3.0, 3.0),
    odd: Rgb::new(3.0, 1.0, 1.0),
    u: Vec3::new(0.2, 0.0, 0.0),
    v: Vec3::new(0.0, 0.2, 0.0),
})
.with_shares(0.1, 0.0, 0.2);

const OBJECTS: [Object<'static, f32>; 5] = [
    Object::new(Shape::plane(Vec3::ZERO, UP), FLOOR),
    Object::new(Shape::sphere(Vec3::new(5.0, 15.0, 8.0), 5.0), MIRROR),
    Object::new(Shape::sphere(Vec3::new(-6.0, 12.0, 4.0), 3.0), MIRROR),
    Object::new(Shape::sphere(Vec3::new(1.0, 10.0, 2.0), 2.0), GREEN),
    Object::new(Shape::sphere(Vec3::new(0.0, 9.0, 5.0), 1.0), CYAN),
];

const fn material(color: Rgb<f32>, reflected: f32) -> Material<f32> {
    let body = Material::matte(color).with_shares(0.05, 0.0, 1.0);
    with_phong(body, 1.0, 32).with_interface(Interface::Mirror { reflected: Rgb::grey(reflected) })
}
