//! Along an interface between equal media there is nothing to be seen, however small the cosine.

use whit::optics::{Polarized, fresnel_dielectric};
use whit::{Background, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::naive::snell;
use crate::support::{Alone, scene, shoot};

const COSINES: [f32; 9] = [0.0, 1e-45, 1e-40, 1e-38, 1e-30, 1e-22, 1e-20, 1e-19, 1e-12];

/// 0/0
#[test]
fn the_textbook_form_is_not_a_number() {
    assert!(snell::reflectance(1.5, 1.5, 0.0).is_nan());
}

#[test]
fn nothing_is_reflected() {
    for n in [1e-3, 1.0, 1.5, 1e3] {
        for cosine in COSINES {
            let expected = Some((Polarized { s: 0.0, p: 0.0 }, cosine));
            assert_eq!(fresnel_dielectric(n, n, cosine), expected, "{n} at {cosine:e}");
        }
    }
}

/// Over a box with the index of its surroundings, at a slope that is still a number.
#[test]
fn pixels_are_numbers() {
    let solid = Shape::axis_box(Vec3::new(-1.0, -1.0, -1.0), Vec3::new(1.0, 0.0, 1.0));
    let objects = [Object::new(solid, Material::dielectric(1.0))];
    let scene = scene(Background::Solid(Rgb::grey(0.5))).with_objects(&objects);
    let tracer = Alone::try_new(&scene).unwrap();
    for y in COSINES {
        let ray = Ray { origin: Vec3::new(0.0, y, 0.0), direction: Vec3::new(0.6, -y, 0.8) };
        assert_eq!(shoot(&tracer, ray, 5).0, Rgb::grey(0.5), "slope {y:e}");
    }
}
