//! Soap bubbles: the colours of a film that drains.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::optics::materials::SOAP_FILM;
use crate::scene::{Background, Camera, Film, Material, Object, Pattern, Scene, Shape, Thickness};

/// Three soap bubbles and the window behind the viewer that they mirror.
///
/// Inside and outside is air; only the film is seen. It has drained: it is thickest below, and so much
/// thinner than a wave of light at the top that it mirrors nothing there, which is called black. Each thickness has its
/// colour, so there are level bands, the palest at the bottom. The window is seen twice, upright in the front of a
/// bubble and upside down in its back.
pub const BUBBLE: Scene<'static, f32> = Scene::new(CAMERA, ROOM).with_objects(&OBJECTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.15, 6.0), Vec3::new(0.12, 0.02, 0.0), UP, 27.0);

/// Bright behind the viewer, dark ahead.
const ROOM: Background<f32> = Background::Gradient {
    below: Rgb::new(0.001, 0.002, 0.008),
    above: Rgb::new(2.1, 2.2, 2.4),
    up: Vec3::new(0.0, 0.0, 1.0),
};

const fn bubble(x: f32, y: f32, z: f32, radius: f32, bottom: f32) -> Object<'static, f32> {
    let center = Vec3::new(x, y, z);
    let film = Film::new(SOAP_FILM, 0.0).with_thickness(Thickness::Gradient {
        from: bottom,
        to: 8.0,
        origin: Vec3::new(x, y - radius, z),
        axis: Vec3::new(0.0, 1.0 / (1.8 * radius), 0.0),
    });
    Object::new(Shape::sphere(center, radius), Material::dielectric(1.0).with_film(film))
}

const fn pane(x: f32, y: f32) -> Object<'static, f32> {
    let light = Pattern::Gradient {
        from: Rgb::new(9.0, 9.0, 8.5),
        to: Rgb::new(11.0, 12.0, 14.0),
        origin: Vec3::new(0.0, 1.0, 0.0),
        axis: Vec3::new(0.0, 0.2, 0.0),
    };
    let shape = Shape::axis_box(Vec3::new(x, y, 8.0), Vec3::new(x + 2.0, y + 2.4, 8.1));
    Object::new(shape, Material::patterned(light).with_shares(1.0, 0.0, 0.0))
}

const OBJECTS: [Object<'static, f32>; 7] = [
    bubble(-0.25, 0.0, 0.0, 1.15, 780.0),
    bubble(1.3, 0.75, -0.6, 0.42, 480.0),
    bubble(1.22, -0.72, 0.4, 0.3, 950.0),
    pane(-6.2, 1.0),
    pane(-4.0, 1.0),
    pane(-6.2, 3.6),
    pane(-4.0, 3.6),
];
