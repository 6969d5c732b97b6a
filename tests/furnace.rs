//! The white furnace: what loses no light is invisible in a uniform background, at every depth, when branches that are
//! cut take the background.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::optics::{Band, bands, materials::dispersive};
use whit::render::{LinearRgb, Size};
use whit::scene::{Film, Medium, Spectrum, Thickness};
use whit::{
    Background, Camera, Effects, Frame, Fresnel, Interface, Material, Object, Rgb, Scene, Settings, Shape, Tracer, Vec3,
};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const LIGHT: f32 = 0.5;
static BANDS: [Band; 12] = bands();

/// Renders objects alone in the light, to every depth up to 10.
fn assert_invisible(name: &str, objects: &[Object<'static, f32>], fresnel: Fresnel) {
    let camera = Camera::look_at(Vec3::new(0.0, 0.5, 3.0), Vec3::ZERO, UP, 50.0);
    let scene = Scene::new(camera, Background::Solid(Rgb::grey(LIGHT))).with_objects(objects).with_fresnel(fresnel);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 12, 8>::try_new(&scene).unwrap();
    for depth in 0..=10 {
        let mut pixels = vec![Rgb::BLACK; 24 * 24];
        let mut target = LinearRgb::new(Size::new(24, 24), &mut pixels).unwrap();
        Frame::new(&tracer, Settings::new(24, 24).with_depth(depth)).unwrap().render(&mut target).unwrap();
        for (i, pixel) in pixels.iter().enumerate() {
            let error = [pixel.r, pixel.g, pixel.b].map(|channel| (channel - LIGHT).abs());
            assert!(error.iter().all(|&error| error < 1e-5), "{name}, depth {depth}, pixel {i}: {pixel:?}");
        }
    }
}

fn shapes() -> [Shape<'static, f32>; 3] {
    [
        Shape::sphere(Vec3::ZERO, 0.9),
        Shape::axis_box(Vec3::splat(-0.6), Vec3::new(0.5, 0.6, 0.7)),
        Shape::cone(Vec3::new(-0.2, -0.7, 0.0), 0.8, Vec3::new(0.1, 0.8, 0.2), 0.3).capped(),
    ]
}

/// A body that shines as bright as the background, under a clear coat: what does not reflect the one shows the other.
fn shining() -> Material<f32> {
    Material::matte(Rgb::grey(LIGHT)).with_shares(1.0, 0.0, 0.0)
}

fn lossless() -> Vec<(&'static str, Material<f32>)> {
    let constant = Interface::Constant {
        reflected: Rgb::new(0.25, 0.5, 0.0),
        transmitted: Rgb::new(0.75, 0.5, 1.0),
        medium: Medium::new(1.4),
    };
    let film = |spectrum| Film::new(1.33, 400.0).with_spectrum(spectrum);
    let gradient = Thickness::Gradient { from: 0.0, to: 900.0, origin: Vec3::splat(-1.0), axis: UP * 0.5 };
    let radial = Thickness::Radial { from: 900.0, to: 50.0, center: UP, radius: 1.5 };
    let glass = Material::dielectric(1.5);
    vec![
        ("glass", glass),
        ("air in nothing", Material::dielectric(1.0)),
        ("a bubble in glass", Material::dielectric(0.6)),
        ("mirror", Material::mirror(Rgb::WHITE)),
        ("metal", Material::metal(Rgb::WHITE)),
        ("perfect conductor", Material::conductor(Rgb::grey(1e-3), Rgb::grey(1e3))),
        ("constant", Material { interface: constant, ..glass }),
        ("flint", Material::transparent(Medium::dispersive(dispersive::FLINT_GLASS.channels()))),
        ("soap, three wavelengths", Material::dielectric(1.0).with_film(film(Spectrum::Wavelengths))),
        ("soap, bands", Material::dielectric(1.0).with_film(film(Spectrum::Bands(&BANDS)))),
        ("soap, table", Material::dielectric(1.0).with_film(film(Spectrum::Table))),
        ("draining film", glass.with_film(film(Spectrum::Table).with_thickness(gradient))),
        ("dense film", glass.with_film(Film::new(2.4, 300.0).with_thickness(radial))),
        ("coat", shining().with_coat(1.5)),
        ("balance", Material { interface: glass.interface, ..shining().with_balance(0.3, 1.0) }),
        ("unattenuated medium", Material::transparent(Medium::new(1.5).with_attenuation(Rgb::BLACK))),
    ]
}

#[test]
fn lossless_materials_are_invisible() {
    for (name, material) in lossless() {
        for shape in shapes() {
            for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
                assert_invisible(name, &[Object::new(shape, material)], fresnel);
            }
        }
    }
}

/// Overlapping, nested and touching media, the camera inside of one.
#[test]
fn nested_media_are_invisible() {
    let medium = |index, priority| Material::transparent(Medium::new(index).with_priority(priority));
    let dispersive = Medium::dispersive(dispersive::FLINT_GLASS.channels()).with_priority(5);
    let objects = [
        Object::new(Shape::sphere(Vec3::ZERO, 1.0), medium(1.5, 2)),
        Object::new(Shape::sphere(Vec3::ZERO, 0.8), medium(1.33, 1)),
        Object::new(Shape::axis_box(Vec3::splat(-0.5), Vec3::new(0.7, 0.2, 0.9)), medium(1.31, 3)),
        Object::new(Shape::sphere(Vec3::new(0.3, 0.4, 0.5), 0.4), Material::transparent(dispersive)),
        Object::new(Shape::plane(Vec3::new(0.0, -0.3, 0.0), UP), medium(1.2, 0)),
        Object::new(Shape::sphere(Vec3::new(0.0, 0.5, 3.0), 1.5), medium(1.7, 4)),
    ];
    for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
        assert_invisible("nested", &objects, fresnel);
    }
}
