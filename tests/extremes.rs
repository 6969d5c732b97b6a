//! Whatever validation accepts renders finite pixels: materials and media at the ends of their ranges.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::optics::{Band, bands};
use whit::render::{LinearRgb, Size};
use whit::scene::{Film, Medium, Spectrum, Thickness};
use whit::{
    Background, Camera, Effects, Frame, Fresnel, Interface, Light, Material, Object, Rgb, Scene, Settings, Shape,
    Tracer, Vec3,
};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const INDICES: [f32; 6] = [1e-3, 0.6, 1.0, 1.000_000_1, 2.5, 1e3];
static BANDS: [Band; 8] = bands();
static WRONG_BANDS: [Band; 2] =
    [Band { wavelength: 1.0, weight: Rgb::grey(1e3) }, Band { wavelength: 1e6, weight: Rgb::grey(-1e3) }];

fn assert_finite(material: Material<f32>, around: Medium<f32>, fresnel: Fresnel) {
    let camera = Camera::look_at(Vec3::new(0.2, 0.7, 3.0), Vec3::ZERO, UP, 60.0);
    let objects = [
        Object::new(Shape::sphere(Vec3::new(-0.6, 0.0, 0.0), 0.8), material),
        Object::new(Shape::axis_box(Vec3::new(0.0, -0.7, -0.6), Vec3::new(0.9, 0.5, 0.4)), material),
        Object::new(Shape::plane(UP * -0.7, UP), Material::matte(Rgb::grey(0.5)).with_coat(1.5)),
    ];
    let lights = [Light::point(Vec3::new(2.0, 4.0, 3.0), Rgb::WHITE)];
    let scene = Scene::new(camera, Background::Solid(Rgb::WHITE)).with_objects(&objects).with_lights(&lights);
    let scene = scene.with_medium(around).with_fresnel(fresnel);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 8, 4>::try_new(&scene).unwrap();
    let mut pixels = [Rgb::BLACK; 10 * 8];
    let mut target = LinearRgb::new(Size::new(10, 8), &mut pixels).unwrap();
    Frame::new(&tracer, Settings::new(10, 8).with_depth(6)).unwrap().render(&mut target).unwrap();
    for pixel in pixels {
        let fine = [pixel.r, pixel.g, pixel.b].iter().all(|channel| (0.0..=20.0).contains(channel));
        assert!(fine, "{pixel:?}: {material:?} in {around:?}, {fresnel:?}");
    }
}

#[test]
fn interfaces() {
    for n in INDICES {
        for m in INDICES {
            let around = Medium::new(m);
            let constant =
                Interface::Constant { reflected: Rgb::grey(0.5), transmitted: Rgb::grey(0.5), medium: Medium::new(n) };
            let materials = [
                Material::dielectric(n),
                Material::transparent(Medium::dispersive(Rgb::new(n, m, 1.5))),
                Material::matte(Rgb::grey(0.5)).with_coat(n),
                Material::dielectric(n).with_interface(constant),
                Material::conductor(Rgb::new(n, m, n), Rgb::new(0.0, 1e3, m)),
                Material::conductor(Rgb::grey(n), Rgb::grey(0.0)).with_balance(1.0, 1.0),
            ];
            for material in materials {
                for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
                    assert_finite(material, around, fresnel);
                }
            }
        }
    }
}

#[test]
fn attenuation() {
    for c in [0.0, 1e-38, 1.0, 1e12] {
        let tinted = Medium::new(1.5).with_attenuation(Rgb::new(c, 0.0, 1.0));
        for around in [Medium::VACUUM, tinted] {
            assert_finite(Material::transparent(tinted.with_priority(255)), around, Fresnel::Exact);
        }
    }
}

#[test]
fn films() {
    let spectra = [Spectrum::Wavelengths, Spectrum::Bands(&BANDS), Spectrum::Bands(&WRONG_BANDS), Spectrum::Table];
    for n in INDICES {
        for index in INDICES {
            for base in INDICES {
                for thickness in [0.0, 1e-30, 300.0, 1e5] {
                    for spectrum in spectra {
                        assert_finite_film(Film::new(index, thickness).with_spectrum(spectrum), base, n);
                    }
                }
            }
        }
    }
}

fn assert_finite_film(film: Film<f32>, base: f32, around: f32) {
    let varying = Thickness::Radial { from: 0.0, to: 1e5, center: Vec3::ZERO, radius: 1e-12 };
    let conductor = Material::conductor(Rgb::grey(base), Rgb::new(0.0, 3.0, 1e3));
    assert_finite(Material::dielectric(base).with_film(film), Medium::new(around), Fresnel::Exact);
    assert_finite(conductor.with_film(film.with_thickness(varying)), Medium::new(around), Fresnel::Exact);
}
