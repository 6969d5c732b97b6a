//! A film of oil on a puddle.

use super::{UP, checker};
use crate::math::{Rgb, Vec3};
use crate::optics::materials::{OLIVE_OIL, WATER};
use crate::scene::{Background, Camera, Film, Light, Material, Object, Scene, Shape, Thickness};

/// Two puddles under an overcast sky, on each a drop of oil that has spread, and a traffic cone.
///
/// The oil is thickest in the middle and thins out to nothing before the edge of the puddle, where bare water mirrors
/// the grey sky. Each ring is a thickness: from the outside it gets brighter than the water, then come brown, blue and
/// yellow, and after those magenta and green in turn, paler and paler. The colours are pale throughout, for the oil's
/// upper face mirrors much more than its lower face.
pub const OIL: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.3, 4.0, 5.2), Vec3::new(0.1, 0.15, 0.0), UP, 37.0);

/// An overcast sky.
const SKY: Background<f32> = Background::Gradient { below: Rgb::grey(0.2), above: Rgb::new(4.4, 4.5, 4.6), up: UP };

const PAVING: Material<f32> =
    Material::patterned(checker(Rgb::new(0.027, 0.026, 0.024), Rgb::grey(0.019), 0.6)).with_shares(0.0, 0.1, 0.75);
const ORANGE: Material<f32> = Material::matte(Rgb::new(0.6, 0.1, 0.01)).with_shares(0.0, 0.15, 0.7);
const WHITE: Material<f32> = Material::matte(Rgb::grey(0.5)).with_shares(0.0, 0.15, 0.7);

/// A puddle with a drop of oil, so many nanometres thick in the middle.
const fn puddle(x: f32, z: f32, radius: f32, thickest: f32) -> Object<'static, f32> {
    let film = Film::new(OLIVE_OIL, 0.0).with_thickness(Thickness::Radial {
        from: thickest,
        to: 0.0,
        center: Vec3::new(x - 0.1 * radius, 0.02, z + 0.1 * radius),
        radius: 0.85 * radius,
    });
    let water = Material::dielectric(WATER).with_film(film);
    Object::new(Shape::disc(Vec3::new(x, 0.02, z), UP, radius), water).without_shadow()
}

const OBJECTS: [Object<'static, f32>; 7] = [
    puddle(-0.1, 0.2, 2.0, 750.0),
    puddle(-1.9, -2.3, 0.8, 400.0),
    Object::new(Shape::plane(Vec3::ZERO, UP), PAVING),
    Object::new(Shape::axis_box(Vec3::new(1.2, 0.0, -2.0), Vec3::new(2.2, 0.06, -1.0)), ORANGE),
    Object::new(Shape::cone(Vec3::new(1.7, 0.0, -1.5), 0.4, Vec3::new(1.7, 0.55, -1.5), 0.27), ORANGE),
    Object::new(Shape::cone(Vec3::new(1.7, 0.55, -1.5), 0.27, Vec3::new(1.7, 0.85, -1.5), 0.18), WHITE),
    Object::new(Shape::cone(Vec3::new(1.7, 0.85, -1.5), 0.18, Vec3::new(1.7, 1.3, -1.5), 0.05).capped(), ORANGE),
];

const LIGHTS: [Light<f32>; 1] = [Light::directional(Vec3::new(-0.4, 1.0, 0.5), Rgb::grey(1.4))];
