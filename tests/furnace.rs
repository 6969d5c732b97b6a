//! The white furnace: what loses no light is invisible in a uniform background, at every depth, when branches that are
//! cut take the background.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::optics::{Band, bands, materials::dispersive};
use whit::render::{LinearRgb, Size};
use whit::scene::{BlackHole, Film, Law, Level, Medium, Method, Profile, Spectrum, Steps, Thickness};
use whit::{
    Background, Budget, Camera, Effects, Frame, Fresnel, Interface, Material, Object, Rgb, Scene, Settings, Shape,
    Stats, Tracer, Vec3,
};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const LIGHT: f32 = 0.5;
static BANDS: [Band; 12] = bands();

/// Objects alone in the light.
fn alone<'a>(objects: &'a [Object<'a, f32>], fresnel: Fresnel) -> Scene<'a, f32> {
    let camera = Camera::look_at(Vec3::new(0.0, 0.5, 3.0), Vec3::ZERO, UP, 50.0);
    Scene::new(camera, Background::Solid(Rgb::grey(LIGHT))).with_objects(objects).with_fresnel(fresnel)
}

fn assert_invisible(name: &str, objects: &[Object<'static, f32>], fresnel: Fresnel) {
    assert_scene_invisible(name, &alone(objects, fresnel));
}

/// Renders a scene to every depth up to 10.
fn assert_scene_invisible(name: &str, scene: &Scene<'_, f32>) {
    for depth in 0..=10 {
        let (pixels, _) = render(scene, depth);
        for (i, pixel) in pixels.iter().enumerate() {
            let error = [pixel.r, pixel.g, pixel.b].map(|channel| (channel - LIGHT).abs());
            assert!(error.iter().all(|&error| error < 1e-5), "{name}, depth {depth}, pixel {i}: {pixel:?}");
        }
    }
}

fn render(scene: &Scene<'_, f32>, depth: u8) -> (Vec<Rgb<f32>>, Stats) {
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 12, 8>::try_new(scene).unwrap();
    let mut pixels = vec![Rgb::BLACK; 24 * 24];
    let mut target = LinearRgb::new(Size::new(24, 24), &mut pixels).unwrap();
    let mut frame = Frame::observed(
        &tracer,
        Settings { budget: Budget::with_depth(depth), ..Settings::new(24, 24) },
        Stats::default(),
    )
    .unwrap();
    frame.render(&mut target).unwrap();
    let stats = *frame.observer();
    (pixels, stats)
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

/// Every way to take light through a medium.
const METHODS: [Method<f32>; 4] = [
    Method::Layers { thickness: 0.05 },
    Method::Steps(Steps::Fixed { length: 0.05 }),
    Method::Steps(Steps::Controlled { tolerance: 1e-3 }),
    Method::Steps(Steps::Controlled { tolerance: 1e-6 }),
];

/// A ball of graded glass around the origin, and laws for it: Luneburg's lens and the fish-eye, both of which have the index 1
/// at the rim, and two lenses with a step there.
const RADIUS: f32 = 0.9;
const LENSES: [(&str, Law<'static, f32>); 4] = [
    ("Luneburg's lens", Law::luneburg(RADIUS)),
    ("fish-eye", Law::FishEye { index: 2.0, radius: RADIUS }),
    ("fish-eye with a step", Law::FishEye { index: 3.0, radius: 1.2 }),
    ("thinner than air", Law::Polynomial { constant: -0.6, linear: 0.3, quadratic: 0.1 }),
];

fn lens(law: Law<'static, f32>, method: Method<f32>) -> Profile<'static, f32> {
    let level = Level::Radius { center: Vec3::ZERO, radius: 0.0 };
    Profile { level, from: 0.0, to: RADIUS, law, method }
}

/// Whatever bends light in a lossless lens, and however roughly it is followed, as much comes out as goes in.
#[test]
fn lossless_lenses_are_invisible() {
    for (name, law) in LENSES {
        for method in METHODS {
            let glass = Object::new(Shape::sphere(Vec3::ZERO, RADIUS), Material::transparent(Medium::graded(0)));
            let (profiles, objects) = ([lens(law, method)], [glass]);
            for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
                let scene = alone(&objects, fresnel).with_profiles(&profiles);
                assert_scene_invisible(&format!("{name} by {method:?}"), &scene);
            }
        }
    }
}

/// The eye in graded air, with glass, a mirror and a graded lens in it.
#[test]
fn graded_air_is_invisible() {
    let air = Law::Exponential { far: 1.0, excess: 0.3, scale: 0.4 };
    for method in METHODS {
        for level in
            [Level::Height { origin: -UP, up: UP }, Level::Radius { center: Vec3::new(0.0, -8.0, 0.0), radius: 7.0 }]
        {
            let profiles =
                [lens(Law::luneburg(RADIUS), method), Profile { level, from: 0.0, to: 3.0, law: air, method }];
            let objects = [
                Object::new(Shape::sphere(UP, 0.5), Material::transparent(Medium::graded(0))),
                Object::new(Shape::sphere(-UP, 0.7), Material::dielectric(1.5)),
                Object::new(Shape::axis_box(Vec3::splat(0.3), Vec3::new(0.9, 0.6, 0.7)), Material::mirror(Rgb::WHITE)),
            ];
            let scene = alone(&objects, Fresnel::Exact).with_profiles(&profiles).with_medium(Medium::graded(1));
            assert_scene_invisible(&format!("air by {method:?}"), &scene);
        }
    }
}

/// Around a black hole all light is there or none: outside of the shadow the background, and in it nothing.
#[test]
fn a_black_hole_takes_all_light_or_none() {
    for steps in
        [Steps::Fixed { length: 0.05 }, Steps::Controlled { tolerance: 1e-3 }, Steps::Controlled { tolerance: 1e-6 }]
    {
        let scene = alone(&[], Fresnel::Exact).with_black_hole(BlackHole { center: Vec3::ZERO, mass: 0.1, steps });
        let (pixels, stats) = render(&scene, 3);
        let black = pixels.iter().filter(|pixel| **pixel == Rgb::BLACK).count();
        let full = pixels.iter().filter(|pixel| **pixel == Rgb::grey(LIGHT)).count();
        assert_eq!(black + full, pixels.len());
        assert_eq!(stats.captured, black as u64);
        assert_eq!((stats.cut_by_steps, stats.cut_by_depth), (0, 0));
        // From 3.04 away, a disc whose radius has the sine 3√3·0.1/3.04, about: 4.5 pixels.
        assert!((54..=72).contains(&black), "{steps:?}: {black}");
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
