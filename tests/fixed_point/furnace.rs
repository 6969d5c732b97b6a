//! The white furnace: what loses no light is nearly invisible in a uniform background.

use whit::math::{Q16, Q20};
use whit::optics::{Band, bands, materials::dispersive};
use whit::render::{LinearRgb, Size};
use whit::scene::{Cone, Film, Medium, Spectrum, Thickness, Triangle};
use whit::{
    Background, Camera, Frame, Fresnel, Interface, Material, Object, Real, Rgb, Scene, Settings, Shape, Tracer, Vec3,
};

use super::meshes::Mesh;
use super::{ALL, converted};

const LIGHT: f32 = 0.5;
const DEEPEST: u8 = 8;
/// How far a pixel may be off, in units in the last place, at each depth: the most that was seen is 6.
const MOST: [f32; DEEPEST as usize + 1] = [2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 7.0, 7.0, 7.0];
static BANDS: [Band; 12] = bands();

fn shapes() -> Vec<Vec<Shape<'static, f32>>> {
    let capped = |base: f32, apex: f32| {
        let (low, high) = (Vec3::new(-0.2, -0.7, 0.0), Vec3::new(0.1, 0.8, 0.2));
        Shape::Cone(Cone { base: low, apex: high, base_radius: base, apex_radius: apex, capped: true })
    };
    let mesh = Mesh::icosahedron().placed([0.8, 0.9, 1.0], [0.1, 0.0, 0.0]).triangles();
    vec![
        vec![Shape::sphere(Vec3::ZERO, 0.9)],
        vec![Shape::axis_box(Vec3::splat(-0.6), Vec3::new(0.5, 0.6, 0.7))],
        vec![capped(0.8, 0.3)],
        vec![capped(0.5, 0.5)],
        mesh.into_iter().map(|Triangle { vertices: [a, b, c] }| Shape::triangle(a, b, c)).collect(),
    ]
}

fn lossless() -> Vec<(&'static str, Material<f32>)> {
    let constant = Interface::Constant {
        reflected: Rgb::new(0.25, 0.5, 0.0),
        transmitted: Rgb::new(0.75, 0.5, 1.0),
        medium: Medium::new(1.4),
    };
    let film = |spectrum| Film::new(1.33, 400.0).with_spectrum(spectrum);
    let glass = Material::dielectric(1.5);
    let radial = Thickness::Radial { from: 900.0, to: 50.0, center: Vec3::new(0.0, 1.0, 0.0), radius: 1.5 };
    let shining = Material::matte(Rgb::grey(LIGHT)).with_shares(1.0, 0.0, 0.0);
    vec![
        ("glass", glass),
        ("dense glass", Material::dielectric(4.0)),
        ("air in nothing", Material::dielectric(1.0)),
        ("a bubble in glass", Material::dielectric(0.6)),
        ("mirror", Material::mirror(Rgb::WHITE)),
        ("metal", Material::metal(Rgb::WHITE)),
        ("constant", Material { interface: constant, ..glass }),
        ("flint", Material::transparent(Medium::dispersive(dispersive::FLINT_GLASS.channels()))),
        ("soap, three wavelengths", Material::dielectric(1.0).with_film(film(Spectrum::Wavelengths))),
        ("soap, bands", Material::dielectric(1.0).with_film(film(Spectrum::Bands(&BANDS)))),
        ("soap, table", Material::dielectric(1.0).with_film(film(Spectrum::Table))),
        ("dense film", glass.with_film(Film::new(2.4, 300.0).with_thickness(radial))),
        ("coat", shining.with_coat(1.5)),
        ("balance", Material { interface: glass.interface, ..shining.with_balance(0.3, 1.0) }),
        ("unattenuated", Material::transparent(Medium::new(1.5).with_attenuation(Rgb::BLACK))),
    ]
}

/// The largest difference from the background, in units in the last place.
fn error<T: Real>(scene: &Scene<'_, T>, depth: u8) -> f32 {
    let tracer = Tracer::<T, ALL, 12, 8>::try_new(scene).unwrap();
    let mut pixels = vec![Rgb::BLACK; 24 * 24];
    let mut target = LinearRgb::new(Size::new(24, 24), &mut pixels).unwrap();
    Frame::new(&tracer, Settings { budget: whit::Budget::with_depth(depth), ..Settings::new(24, 24) })
        .unwrap()
        .render(&mut target)
        .unwrap();
    let off = |x: f32| (x - LIGHT).abs() / T::SMALLEST.to_f32();
    pixels.iter().flat_map(|p| [p.r, p.g, p.b]).map(off).fold(0.0, f32::max)
}

fn assert_invisible<T: Real>() {
    for (name, material) in lossless() {
        for shapes in shapes() {
            let objects: Vec<_> = shapes.into_iter().map(|shape| Object::new(shape, material)).collect();
            for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
                let camera = Camera::look_at(Vec3::new(0.0, 0.5, 3.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 50.0);
                let scene = Scene::new(camera, Background::Solid(Rgb::grey(LIGHT))).with_objects(&objects);
                let scene = converted::<T>(&scene.with_fresnel(fresnel));
                for (depth, most) in (0..=DEEPEST).zip(MOST) {
                    let error = error(&scene.as_scene(), depth);
                    assert!(error <= most, "{name}, depth {depth}: {error} units, {:?}", objects[0].shape);
                }
            }
        }
    }
}

#[test]
fn what_loses_no_light_is_invisible() {
    assert_invisible::<Q16>();
    assert_invisible::<Q20>();
}
