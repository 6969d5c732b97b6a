//! A conductor that differs in nothing from what is around it reflects nothing, and is not 0/0.

use whit::optics::fresnel_conductor;
use whit::{Background, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::support::{Alone, scene, shoot};

#[test]
fn its_reflectance_is_a_share() {
    for cosine in [0.0, 1e-45, 1e-30, 1e-20, 1e-10, 0.5, 1.0] {
        let found = fresnel_conductor(1.0_f32, 0.0, cosine);
        assert!((0.0..=1.0).contains(&found.s) && (0.0..=1.0).contains(&found.p), "{cosine:e}: {found:?}");
    }
}

/// A smooth triangle whose normals face away from the eye is seen at a cosine of 0.
#[test]
fn pixels_are_numbers() {
    use whit::scene::SmoothTriangle;
    let vertices = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
    let shape = Shape::SmoothTriangle(SmoothTriangle { vertices, normals: [Vec3::new(1.0, 0.0, -0.1); 3] });
    let objects = [Object::new(shape, Material::conductor(Rgb::WHITE, Rgb::BLACK))];
    let scene = scene(Background::Solid(Rgb::grey(0.5))).with_objects(&objects);
    let tracer = Alone::try_new(&scene).unwrap();
    let ray = Ray { origin: Vec3::new(0.0, 0.0, 3.0), direction: Vec3::new(0.0, 0.0, -1.0) };
    let light = shoot(&tracer, ray, 2).0;
    assert!(light.r.is_finite(), "{light:?}");
}
