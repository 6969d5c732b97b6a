//! The scene of `raystones`, which compares processors by the pixels of it that they render in a second and megahertz: Bruno
//! Levy's port of Dmitry Sokolov's tinyraytracer, in the tutorial of learn-fpga.
//!
//! Where it differs: light that is reflected totally in the glass goes on in a fixed direction there, and here it is reflected;
//! and the glass has highlights on its inside there.

use whit::scene::{Medium, Pattern};
use whit::trace::Termination;
use whit::{Background, Camera, Interface, Light, Material, Object, Rgb, Scene, Shape, Vec3};

use super::{Peer, with_phong};

/// At the size at which it is measured.
pub const RAYSTONES: Peer =
    Peer { name: "raystones", scene: SCENE, size: [40, 20], depth: 2, termination: Termination::Background };

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);

const SCENE: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), UP, 60.0);

const SKY: Background<f32> = Background::Gradient { below: Rgb::BLACK, above: Rgb::new(0.2, 0.7, 1.3), up: UP };

const LIGHTS: [Light<f32>; 3] = [
    Light::point(Vec3::new(-20.0, 20.0, 20.0), Rgb::grey(1.5)),
    Light::point(Vec3::new(30.0, 50.0, -25.0), Rgb::grey(1.8)),
    Light::point(Vec3::new(30.0, 20.0, 30.0), Rgb::grey(1.7)),
];

const IVORY: Material<f32> = with_phong(matte(Rgb::new(0.4, 0.4, 0.3), 0.6), 0.3, 50).with_interface(mirror(0.1));
const RED_RUBBER: Material<f32> = with_phong(matte(Rgb::new(0.3, 0.1, 0.1), 0.9), 0.1, 10);
const MIRROR: Material<f32> = with_phong(Material::mirror(Rgb::grey(0.8)), 10.0, 142);
const GLASS: Material<f32> = with_phong(
    Material::dielectric(1.5).with_interface(Interface::Constant {
        reflected: Rgb::grey(0.1),
        transmitted: Rgb::grey(0.8),
        medium: Medium::new(1.5),
    }),
    0.5,
    125,
);

const FLOOR: Material<f32> = Material::patterned(Pattern::Checker {
    even: Rgb::new(0.3, 0.2, 0.1),
    odd: Rgb::grey(0.3),
    u: Vec3::new(0.5, 0.0, 0.0),
    v: Vec3::new(0.0, 0.0, -0.5),
});

/// The floor is a rectangle: a box without thickness.
const OBJECTS: [Object<'static, f32>; 5] = [
    Object::new(Shape::sphere(Vec3::new(-3.0, 0.0, -16.0), 2.0), IVORY),
    Object::new(Shape::sphere(Vec3::new(-1.0, -1.5, -12.0), 2.0), GLASS),
    Object::new(Shape::sphere(Vec3::new(1.5, -0.5, -18.0), 3.0), RED_RUBBER),
    Object::new(Shape::sphere(Vec3::new(7.0, 5.0, -18.0), 4.0), MIRROR),
    Object::new(Shape::axis_box(Vec3::new(-10.0, -4.0, -30.0), Vec3::new(10.0, -4.0, -10.0)), FLOOR),
];

const fn matte(color: Rgb<f32>, diffuse: f32) -> Material<f32> {
    Material::matte(color).with_shares(0.0, 0.0, diffuse)
}

const fn mirror(share: f32) -> Interface<f32> {
    Interface::Mirror { reflected: Rgb::grey(share) }
}
