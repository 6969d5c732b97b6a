//! Materials and media that no light can go through are refused, by the name of the object and the field.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::optics::Band;
use whit::scene::{Balance, Film, Medium, Shadow, Spectrum, Thickness};
use whit::trace::TracerError;
use whit::{Background, Camera, Effects, Interface, Material, Object, Rgb, Scene, Shape, Tracer, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
const PLAIN: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(Rgb::BLACK));
const SPHERE: Shape<'static, f32> = Shape::sphere(Vec3::ZERO, 1.0);
const NAN: f32 = f32::NAN;

/// What is said of the second of two objects.
fn refused(object: Object<'static, f32>) -> String {
    let objects = [Object::new(SPHERE, Material::dielectric(1.5)), object];
    let scene = PLAIN.with_objects(&objects);
    let error = Tracer::<f32, { Effects::ALL.bits() }, 5, 2>::try_new(&scene).map(|_| ()).unwrap_err();
    assert_eq!(scene.check().unwrap_err().to_string(), error.to_string());
    error.to_string()
}

fn material(material: Material<f32>) -> String {
    let message = refused(Object::new(SPHERE, material));
    message.strip_prefix("object 1: ").unwrap().to_owned()
}

#[test]
fn indices() {
    const RANGE: &str = "expected an index of refraction from 1e-3 to 1e3";
    for index in [0.0, -1.5, NAN, f32::INFINITY] {
        assert_eq!(material(Material::dielectric(index)), format!("interface.medium.index: {RANGE}"));
        assert_eq!(material(Material::mirror(Rgb::WHITE).with_coat(index)), format!("interface.index: {RANGE}"));
        for channel in 0..3 {
            let mut indices = [1.5; 3];
            indices[channel] = index;
            let [r, g, b] = indices;
            let dispersive = Medium::dispersive(Rgb::new(r, g, b));
            assert_eq!(material(Material::transparent(dispersive)), format!("interface.medium.index: {RANGE}"));
            let conductor = Material::conductor(Rgb::new(r, g, b), Rgb::WHITE);
            assert_eq!(material(conductor), format!("interface.index: {RANGE}"));
        }
    }
}

#[test]
fn attenuation_and_extinction() {
    for wrong in [-0.1, NAN, f32::INFINITY] {
        for color in [Rgb::new(wrong, 0.0, 0.0), Rgb::new(0.0, wrong, 0.0), Rgb::new(0.0, 0.0, wrong)] {
            let medium = Medium::new(1.5).with_attenuation(color);
            let message = "interface.medium.attenuation: expected a number from 0 to 1e12";
            assert_eq!(material(Material::transparent(medium)), message);
            let constant = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
            assert_eq!(material(Material::dielectric(1.5).with_interface(constant)), message);
            let conductor = Material::conductor(Rgb::WHITE, color);
            assert_eq!(material(conductor), "interface.extinction: expected an extinction coefficient from 0 to 1e3");
            let scene = PLAIN.with_medium(medium);
            let message = "scene: medium.attenuation: expected a number from 0 to 1e12";
            assert_eq!(scene.check().unwrap_err().to_string(), message);
        }
    }
    assert_eq!(
        PLAIN.with_medium(Medium::new(0.0)).validate().unwrap_err().to_string(),
        "scene: medium.index: expected an index of refraction from 1e-3 to 1e3"
    );
}

#[test]
fn reflectances() {
    for wrong in [-0.1, 1.1, NAN] {
        let color = Rgb::new(0.5, wrong, 0.5);
        assert_eq!(material(Material::metal(color)), "interface.r0: expected a number from 0 to 1");
        assert_eq!(material(Material::mirror(color)), "interface.reflected: expected a number from 0 to 1");
    }
}

#[test]
fn films() {
    let film = |thickness| material(Material::dielectric(1.5).with_film(thickness));
    let varying = |thickness| {
        let film = Film::new(1.33, 0.0).with_thickness(thickness);
        material(Material::conductor(Rgb::WHITE, Rgb::WHITE).with_film(film))
    };
    const NANOMETRES: &str = "interface.film.thickness: expected a thickness from 0 to 1e5 nm";
    for wrong in [-1.0, NAN, f32::INFINITY] {
        assert_eq!(film(Film::new(1.33, wrong)), NANOMETRES);
        assert_eq!(varying(Thickness::Gradient { from: wrong, to: 0.0, origin: UP, axis: UP }), NANOMETRES);
        assert_eq!(varying(Thickness::Radial { from: 0.0, to: wrong, center: UP, radius: 1.0 }), NANOMETRES);
        let message = "interface.film.thickness.radius: expected a number from 1e-12 to 1e12";
        assert_eq!(varying(Thickness::Radial { from: 0.0, to: 0.0, center: UP, radius: wrong }), message);
    }
    let message = "interface.film.index: expected an index of refraction from 1e-3 to 1e3";
    assert_eq!(film(Film::new(0.0, 100.0)), message);
    let spectrum = |bands| film(Film::new(1.33, 100.0).with_spectrum(Spectrum::Bands(bands)));
    assert_eq!(spectrum(&[]), "interface.film.spectrum: expected at least one band");
    const WRONG: [Band; 1] = [Band { wavelength: 0.0, weight: Rgb::WHITE }];
    assert_eq!(
        spectrum(&WRONG),
        "interface.film.spectrum: expected wavelengths from 1 to 1e6 nm with weights from -1e3 to 1e3"
    );
}

#[test]
fn balances() {
    let balance = |ratio, brightness| {
        let balance = Some(Balance { ratio, brightness });
        material(Material { balance, ..Material::mirror(Rgb::WHITE) })
    };
    assert_eq!(balance(1.5, 0.5), "balance.ratio: expected a number from 0 to 1");
    assert_eq!(balance(NAN, 0.5), "balance.ratio: expected a number from 0 to 1");
    assert_eq!(balance(0.5, -1.0), "balance.brightness: expected a number from 0 to 1e12");
    let message = "balance.brightness: expected at most 1/ratio, so that no light comes from nowhere";
    assert_eq!(balance(0.5, 2.1), message);
}

#[test]
fn shadows_and_media() {
    let tinted = Object { shadow: Shadow::Tinted, ..Object::new(SPHERE, Material::mirror(Rgb::WHITE)) };
    assert_eq!(refused(tinted), "object 1: shadow: expected a tinted shadow only under a transparent interface");
    let ranked = [Object::new(SPHERE, Material::dielectric(1.5).with_priority(1))];
    let scene = PLAIN.with_objects(&ranked);
    let error = Tracer::<f32, { Effects::ALL.bits() }, 5>::try_new(&scene).map(|_| ()).unwrap_err();
    assert_eq!(error, TracerError::NoMedia);
    assert_eq!(error.to_string(), "the scene has media that attenuate or overlap: expected MEDIA above 0");
}
