//! Pictures with every effect of optics, alone and together, against the `f64` reference.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod reference;

use reference::compare::Difference;
use whit::optics::{Band, attenuation_for, bands, materials};
use whit::render::{LinearRgb, Size};
use whit::scene::{Film, Medium, Spectrum, Thickness};
use whit::{
    Background, Budget, Camera, Effects, Frame, Fresnel, Interface, Light, Material, Object, Pattern, Rgb, Scene,
    Settings, Shape, Stats, Tracer, Vec3,
};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const DEPTH: u8 = 6;
const SIZE: Size = Size::new(160, 120);
static BANDS: [Band; 24] = bands();

const fn v(x: f32, y: f32, z: f32) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

const CAMERA: Camera<f32> = Camera::look_at(v(0.4, 1.6, 5.0), v(0.0, 0.6, 0.0), UP, 45.0);
const SKY: Background<f32> =
    Background::Gradient { below: Rgb::new(0.8, 0.7, 0.6), above: Rgb::new(0.2, 0.4, 0.9), up: UP };
const LIGHTS: [Light<f32>; 2] =
    [Light::point(v(3.0, 5.0, 4.0), Rgb::grey(0.7)), Light::directional(v(-0.5, 1.0, 0.3), Rgb::new(0.3, 0.3, 0.2))];
const FLOOR: Object<'static, f32> = Object::new(Shape::plane(v(0.0, 0.0, 0.0), UP), TILES);
const TILES: Material<f32> = Material::patterned(Pattern::Checker {
    even: Rgb::new(0.7, 0.3, 0.2),
    odd: Rgb::grey(0.8),
    u: v(1.0, 0.0, 0.0),
    v: v(0.0, 0.0, 1.0),
})
.with_shares(0.05, 0.1, 0.7);
const TINT: Rgb<f32> = attenuation_for(Rgb::new(0.3, 0.7, 0.9), 1.0);

/// The library's picture by code for all effects, and its counts.
fn picture<const MEDIA: usize>(scene: &Scene<'_, f32>) -> (Vec<[f32; 3]>, Stats) {
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, { DEPTH as usize + 2 }, MEDIA>::try_new(scene).unwrap();
    let mut pixels = vec![Rgb::BLACK; SIZE.pixels() as usize];
    let mut target = LinearRgb::new(SIZE, &mut pixels).unwrap();
    let settings = Settings { budget: Budget::with_depth(DEPTH), ..Settings::new(SIZE.width, SIZE.height) };
    let mut frame = Frame::observed(&tracer, settings, Stats::default()).unwrap();
    frame.render(&mut target).unwrap();
    let stats = *frame.observer();
    (pixels.iter().map(|color| [color.r, color.g, color.b]).collect(), stats)
}

/// Some pixels are edges, which `f32` and `f64` see on different sides of their middles. The others agree to `rmse`.
fn agrees(name: &str, objects: &[Object<'_, f32>], fresnel: Fresnel, medium: Medium<f32>, rmse: f64) {
    let scene = Scene::new(CAMERA, SKY).with_objects(objects).with_lights(&LIGHTS);
    let scene = scene.with_fresnel(fresnel).with_medium(medium);
    let (found, stats) = if scene.media() == 0 { picture::<0>(&scene) } else { picture::<8>(&scene) };
    let settings = reference::Settings::new(SIZE.width, SIZE.height, DEPTH.into());
    let (expected, counts) = reference::render(&scene, &settings, &reference::Samples::CENTRE);
    let difference = Difference::between(&found, &expected);
    println!("{name:22} {difference}");
    assert_eq!(stats.media_overflows, 0);
    assert!(difference.share_over_1_255 <= 1e-3, "{name}: {difference}");
    assert!(difference.rmse_without_edges <= rmse, "{name}: {difference}");
    for (kind, found, expected) in [
        ("eye", stats.eye, counts.eye),
        ("reflected", stats.reflected, counts.reflected),
        ("transmitted", stats.transmitted, counts.transmitted),
        ("passed", stats.passed, counts.passed),
        ("total internal", stats.total_internal, counts.total_internal),
    ] {
        assert!(
            found.abs_diff(expected) as f64 <= 10.0 + 1e-3 * expected as f64,
            "{name}: {kind}: {found}, {expected}"
        );
    }
}

const VACUUM: Medium<f32> = Medium::VACUUM;

#[test]
fn every_interface_agrees() {
    let gold = Material::conductor(materials::GOLD.index, materials::GOLD.extinction);
    let flint = Medium::dispersive(materials::dispersive::FLINT_GLASS.channels());
    let tinted = Interface::Constant {
        reflected: Rgb::grey(0.2),
        transmitted: Rgb::new(0.7, 0.8, 0.6),
        medium: flint.with_attenuation(TINT),
    };
    let painted =
        Material::matte(Rgb::new(0.2, 0.5, 0.3)).with_shares(0.1, 0.1, 0.7).with_highlight(Rgb::grey(0.3), 30);
    let materials = [
        ("dielectric", 3e-5, Material::dielectric(1.5)),
        ("conductor", 1e-6, gold.with_highlight(Rgb::grey(0.2), 90)),
        ("coat", 1e-6, painted.with_coat(1.6)),
        ("flint", 2e-5, Material::transparent(flint)),
        ("absorbing", 5e-6, Material::transparent(Medium::new(1.4).with_attenuation(TINT))),
        ("constant", 1e-5, Material { interface: tinted, ..gold }),
        (
            "balance",
            1e-6,
            painted.with_interface(Interface::Mirror { reflected: Rgb::grey(0.9) }).with_balance(0.4, 0.9),
        ),
    ];
    for (name, rmse, material) in materials {
        let shapes = [
            Shape::sphere(v(-1.1, 0.8, 0.3), 0.7),
            Shape::axis_box(v(0.3, 0.1, -0.4), v(1.3, 1.1, 0.5)),
            Shape::cone(v(0.0, 0.1, 1.5), 0.4, v(0.2, 0.9, 1.4), 0.2).capped(),
        ];
        let objects = shapes.map(|shape| Object::new(shape, material));
        let objects = [&[FLOOR], &objects[..]].concat();
        agrees(name, &objects, Fresnel::Exact, VACUUM, rmse);
        agrees(name, &objects, Fresnel::Schlick, Medium::new(1.1).with_attenuation(TINT * 0.1), rmse);
    }
}

#[test]
fn every_film_agrees() {
    let draining = Thickness::Gradient { from: 20.0, to: 900.0, origin: v(0.0, 1.5, 0.0), axis: UP * -0.7 };
    let spreading = Thickness::Radial { from: 800.0, to: 50.0, center: v(0.6, 1.0, 0.5), radius: 1.6 };
    let titanium = Material::conductor(materials::TITANIUM.index, materials::TITANIUM.extinction);
    for (name, spectrum, tolerance) in [
        ("three wavelengths", Spectrum::Wavelengths, 2e-5),
        ("bands", Spectrum::Bands(&BANDS), 2e-5),
        // The reference integrates the spectrum in steps of 1 nm.
        ("table", Spectrum::Table, 6e-5),
    ] {
        let soap = Film::new(materials::SOAP_FILM, 300.0).with_spectrum(spectrum);
        let oxide = Film::new(materials::TITANIUM_DIOXIDE, 60.0).with_spectrum(spectrum);
        // One index in all channels: between them the reference goes by wavelength.
        let grey = Material::conductor(Rgb::grey(2.5), Rgb::grey(3.4));
        let metal = if spectrum == Spectrum::Wavelengths { titanium } else { grey };
        let objects = [
            FLOOR,
            Object::new(
                Shape::sphere(v(-1.1, 0.8, 0.3), 0.7),
                Material::dielectric(1.0).with_film(soap.with_thickness(draining)),
            ),
            Object::new(
                Shape::axis_box(v(0.3, 0.1, -0.4), v(1.3, 1.1, 0.5)),
                Material::dielectric(1.5).with_film(oxide.with_thickness(spreading)),
            ),
            Object::new(
                Shape::cone(v(0.0, 0.1, 1.5), 0.4, v(0.2, 0.9, 1.4), 0.2).capped(),
                metal.with_film(oxide.with_thickness(draining)),
            ),
        ];
        agrees(name, &objects, Fresnel::Exact, VACUUM, tolerance);
    }
}

/// Media in media, some of them absorbing, one that splits light, one with a film; the eye inside of one, solid things
/// inside of others, and shadows through them.
#[test]
fn nested_media_agree() {
    let medium = |index, priority| Medium::new(index).with_priority(priority);
    let flint = Medium::dispersive(materials::dispersive::FLINT_GLASS.channels());
    let film = Film::new(1.45, 350.0).with_spectrum(Spectrum::Wavelengths);
    let red = Material::matte(Rgb::new(0.8, 0.1, 0.1)).with_shares(0.05, 0.1, 0.8);
    let transparent = Material::transparent;
    let around = Medium::dispersive(Rgb::new(1.05, 1.2, 1.45)).with_priority(0).with_attenuation(TINT * 0.05);
    let objects = [
        FLOOR,
        Object::new(Shape::sphere(v(-1.1, 0.9, 0.3), 0.8), transparent(medium(1.5, 3))).with_tinted_shadow(),
        Object::new(
            Shape::sphere(v(-1.05, 0.9, 0.3), 0.6),
            transparent(medium(1.33, 2).with_attenuation(TINT)).with_film(film),
        )
        .with_tinted_shadow(),
        Object::new(Shape::sphere(v(-1.1, 0.8, 0.2), 0.25), red),
        Object::new(
            Shape::axis_box(v(0.1, 0.15, -0.4), v(1.3, 1.13, 0.53)),
            transparent(medium(1.6, 1).with_attenuation(TINT * 0.3)),
        )
        .with_tinted_shadow(),
        Object::new(Shape::sphere(v(0.3, 0.9, 0.45), 0.45), transparent(flint.with_priority(5))).without_shadow(),
        Object::new(Shape::cone(v(0.8, 0.31, 0.0), 0.3, v(0.85, 0.92, 0.07), 0.2).capped(), Material::dielectric(1.2)),
        Object::new(Shape::axis_box(v(0.55, -0.2, -0.23), v(0.97, 0.47, 0.13)), transparent(medium(1.0, 9))),
        Object::new(Shape::sphere(v(0.4, 1.6, 5.2), 2.0), transparent(around)).with_tinted_shadow(),
        Object::new(Shape::sphere(v(-0.1, 1.2, 3.9), 0.15), red.with_coat(1.5)),
        Object::new(Shape::sphere(v(1.6, 0.6, 1.3), 0.4), transparent(medium(1.1, 6).with_attenuation(TINT)))
            .without_shadow(),
        Object::new(Shape::sphere(v(1.6, 0.5, 1.2), 0.2), red),
    ];
    agrees("nested", &objects, Fresnel::Exact, VACUUM, 3e-5);
    agrees("nested in fog", &objects, Fresnel::Schlick, Medium::new(1.02).with_attenuation(TINT * 0.1), 2e-5);
}

/// A medium all around, but for a hollow in it.
#[test]
fn a_medium_turned_inside_out_agrees() {
    let around = Medium::new(1.2).with_attenuation(TINT * 0.2);
    let objects = [
        Object::new(Shape::sphere(v(0.0, 0.6, 0.0), -2.5), Material::transparent(around)),
        Object::new(Shape::sphere(v(-0.8, 0.8, 0.3), 0.7), Material::matte(Rgb::new(0.8, 0.5, 0.3))),
        Object::new(Shape::sphere(v(0.8, 0.8, 0.3), 0.7), Material::dielectric(1.5)),
    ];
    agrees("inside out", &objects, Fresnel::Exact, VACUUM, 1e-5);
}

/// A mesh may be one object or an object for each triangle.
#[test]
fn single_triangles_make_a_mesh() {
    use whit::scene::Triangle;
    let [a, b, c, d] = [v(-1.0, 0.1, 1.0), v(1.2, 0.1, 0.9), v(0.1, 0.2, -1.1), v(0.1, 1.9, 0.1)];
    let mesh = [[a, b, d], [b, c, d], [c, a, d], [a, c, b]].map(|vertices| Triangle { vertices });
    let tinted = Material::transparent(Medium::new(1.5).with_attenuation(TINT * 3.0));
    let ball =
        Object::new(Shape::sphere(v(0.1, 0.6, 0.1), 0.25), Material::matte(Rgb::WHITE).with_shares(0.6, 0.0, 0.4));
    let together = [FLOOR, ball, Object::new(Shape::Triangles(&mesh), tinted)];
    let apart: Vec<_> =
        [FLOOR, ball].into_iter().chain(mesh.map(|part| Object::new(Shape::Triangle(part), tinted))).collect();
    let scene = Scene::new(CAMERA, SKY).with_lights(&LIGHTS);
    let pictures = [scene.with_objects(&together), scene.with_objects(&apart)].map(|scene| picture::<4>(&scene));
    assert_eq!(pictures[0], pictures[1]);
    agrees("mesh", &together, Fresnel::Exact, VACUUM, 1e-6);
}

/// A list of media that is too short is told, for branches, for shadow rays and where the eye is.
#[test]
fn forgotten_media_are_counted() {
    use whit::Ray;
    let ball = |radius| {
        let tinted = Material::transparent(Medium::new(1.2).with_attenuation(TINT));
        Object::new(Shape::sphere(v(0.0, 0.0, 0.0), radius), tinted).with_tinted_shadow()
    };
    let stone = Object::new(Shape::sphere(v(0.0, 0.0, 3.0), 0.5), Material::matte(Rgb::WHITE));
    let objects = [stone, ball(1.5), ball(1.0), ball(0.5)];
    let lights = [Light::point(v(0.0, 0.0, -4.0), Rgb::WHITE)];
    let scene = Scene::new(CAMERA, SKY).with_objects(&objects).with_lights(&lights);
    fn overflows<const MEDIA: usize>(scene: &Scene<'_, f32>, from: f32, towards: f32) -> u64 {
        let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0, MEDIA>::try_new(scene).unwrap();
        let mut stats = Stats::default();
        let ray = Ray { origin: v(0.0, 0.0, from), direction: v(0.0, 0.0, towards) };
        let light = tracer.trace(ray, &Budget::with_depth(0), &mut stats);
        assert!(light.max_channel().is_finite());
        stats.media_overflows
    }
    // From the middle, where the list is full from the start; then to the stone, past whose middle the light comes.
    for (from, towards) in [(0.0, -1.0), (2.0, 1.0)] {
        assert_eq!(overflows::<3>(&scene, from, towards), 0);
        assert!(overflows::<2>(&scene, from, towards) > 0, "from {from}");
    }
    // Two bounces into the balls.
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 3, 2>::try_new(&scene).unwrap();
    let mut stats = Stats::default();
    let ray = Ray { origin: v(0.0, 0.0, -3.0), direction: v(0.0, 0.0, 1.0) };
    let _ = tracer.trace(ray, &Budget::with_depth(3), &mut stats);
    assert!(stats.media_overflows > 0);
}
