//! Products of the brightest lights and factors that a scene may have are beyond the range of the number type. Pixels are
//! numbers all the same: the largest one, and in the other channels what they should be.

use whit::render::{LinearRgb, Size};
use whit::scene::{Falloff, Medium, Tone};
use whit::{
    Background, Camera, Effects, Frame, Interface, Light, Material, Object, Rgb, Scene, Settings, Shape, Tracer, Vec3,
};

use crate::support::UP;

const MOST: f32 = 1e12;
const BODY: Material<f32> = Material::matte(Rgb::new(MOST, 0.0, 1.0)).with_shares(MOST, MOST, MOST);
const LIGHT: Light<f32> = Light::point(Vec3::new(0.0, 1.0, 0.0), Rgb::new(MOST, MOST, 0.0));

/// The pixels of a plane with that material under lights, with a pane of glass above it or without.
fn pixels(material: Material<f32>, lights: &[Light<f32>], tone: Tone<f32>, pane: bool) -> [Rgb<f32>; 16] {
    let camera = Camera::look_at(Vec3::new(0.0, 2.0, 2.0), Vec3::ZERO, UP, 40.0);
    // Glass that takes all of the red light.
    let medium = Medium::VACUUM.with_attenuation(Rgb::new(MOST, 0.0, 0.0));
    let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
    let above = Shape::axis_box(Vec3::new(-9.0, 1.2, -9.0), Vec3::new(9.0, 1.3, 9.0));
    let objects = [
        Object::new(Shape::plane(Vec3::ZERO, UP), material),
        Object::new(above, Material::dielectric(1.0).with_interface(clear)),
    ];
    let shown = if pane { &objects[..] } else { &objects[..1] };
    let scene = Scene { tone, ..Scene::new(camera, Background::Solid(Rgb::BLACK)) };
    let scene = scene.with_objects(shown).with_lights(lights);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 2, 4>::try_new(&scene).unwrap();
    let mut pixels = [Rgb::BLACK; 4 * 4];
    let mut target = LinearRgb::new(Size::new(4, 4), &mut pixels).unwrap();
    Frame::new(&tracer, Settings::new(4, 4).with_depth(2)).unwrap().render(&mut target).unwrap();
    for pixel in pixels {
        assert!([pixel.r, pixel.g, pixel.b].iter().all(|channel| channel.is_finite()), "{pixel:?}");
    }
    pixels
}

#[test]
fn many_lights() {
    for pixel in pixels(BODY, &[LIGHT; 400], Tone::Linear, false) {
        assert_eq!(pixel.r, f32::MAX);
        assert!(pixel.g == 0.0, "{pixel:?}");
    }
}

#[test]
fn a_light_with_a_falloff() {
    let falloff = Falloff { constant: 1e-12, linear: 0.0, quadratic: 0.0 };
    for pixel in pixels(BODY, &[LIGHT.with_falloff(falloff)], Tone::Linear, false) {
        // Blue shines by itself: 1·10¹².
        assert!(pixel.r == f32::MAX && (pixel.b / MOST - 1.0).abs() < 1e-6, "{pixel:?}");
    }
}

#[test]
fn a_body_in_balance() {
    for pixel in pixels(BODY.with_balance(0.0, MOST), &[LIGHT], Tone::Linear, false) {
        assert!(pixel.r == f32::MAX && (pixel.b / MOST / MOST - 1.0).abs() < 1e-6, "{pixel:?}");
    }
}

#[test]
fn a_gain() {
    for pixel in pixels(BODY, &[LIGHT], Tone::Display { gain: MOST, lift: -MOST }, false) {
        assert!(pixel.r == f32::MAX && (pixel.b / MOST / MOST - 1.0).abs() < 1e-6, "{pixel:?}");
    }
}

/// 0·∞ is no number; a number is shown.
#[test]
fn behind_what_takes_all_of_it() {
    let all = pixels(BODY.with_balance(0.0, MOST), &[LIGHT; 2], Tone::Linear, true);
    assert!(all.iter().any(|pixel| pixel.b > 0.0));
}
