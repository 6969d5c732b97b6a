//! Materials and media that no light can go through, and what bends it as nothing can, are refused, by the name of the place
//! and the field.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::optics::Band;
use whit::scene::{
    Balance, BlackHole, Film, Law, Level, Medium, Method, Place, Profile, SceneError, Shadow, Spectrum, Steps,
    Thickness,
};
use whit::trace::TracerError;
use whit::{
    Background, Camera, Effects, Interface, Material, Object, Pattern, Rgb, Scene, SceneBuf, Shape, Tracer, Vec3,
};

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

const FLAT: Level<f32> = Level::Height { origin: Vec3::ZERO, up: UP };
const AIR: Profile<'static, f32> = Profile {
    level: FLAT,
    from: 0.0,
    to: 2.0,
    law: Law::Exponential { far: 1.0, excess: 0.1, scale: 0.5 },
    method: Method::Steps(Steps::Controlled { tolerance: 1e-5 }),
};
const WRONG: [f32; 4] = [-1.0, NAN, f32::INFINITY, 1e13];

/// What is said of the second of two profiles: in constants, in `f32` and in `f64`.
fn profile(profile: Profile<'static, f32>) -> (&'static str, &'static str) {
    let profiles = [AIR, profile];
    let scene = PLAIN.with_profiles(&profiles).with_medium(Medium::graded(1));
    let error = scene.check().unwrap_err();
    assert_eq!(scene.validate().unwrap_err(), error);
    assert_eq!(error.place, Place::Profile(1), "{error}");
    assert!(error.to_string().starts_with("profile 1: "));
    if !matches!(profile.law, Law::Table { .. }) {
        let wide = SceneBuf::<f64, 1, 1, 2>::from_scene(&scene, f64::from).unwrap();
        assert_eq!(wide.as_scene().validate().unwrap_err(), error);
    }
    (error.field, error.expected)
}

fn law(law: Law<'static, f32>) -> (&'static str, &'static str) {
    profile(Profile { law, ..AIR })
}

#[test]
fn profiles_are_checked() {
    let scene = PLAIN.with_profiles(&[AIR]).with_medium(Medium::graded(0));
    assert!(scene.check().is_ok() && scene.validate().is_ok());
    const { assert!(PLAIN.with_profiles(&[AIR]).with_medium(Medium::graded(0)).check().is_ok()) };
    const LENGTH: &str = "a finite number of at most 1e12";
    for wrong in [NAN, f32::INFINITY, 2e12] {
        assert_eq!(profile(Profile { from: -wrong, ..AIR }), ("from", LENGTH));
        assert_eq!(profile(Profile { to: wrong, ..AIR }), ("to", LENGTH));
        let origin = Vec3::new(0.0, wrong, 0.0);
        assert_eq!(profile(Profile { level: Level::Height { origin, up: UP }, ..AIR }), ("level.origin", LENGTH));
        let level = Level::Radius { center: origin, radius: 1.0 };
        assert_eq!(profile(Profile { level, ..AIR }), ("level.center", LENGTH));
    }
    for to in [0.0, -1.0, 1e-13] {
        assert_eq!(profile(Profile { to, ..AIR }), ("to", "a level above `from`"));
    }
    for up in [Vec3::ZERO, UP * 2.0, UP * NAN] {
        let level = Level::Height { origin: Vec3::ZERO, up };
        assert_eq!(profile(Profile { level, ..AIR }), ("level.up", "a vector of length 1"));
    }
    for radius in WRONG {
        let level = Level::Radius { center: Vec3::ZERO, radius };
        assert_eq!(profile(Profile { level, ..AIR }), ("level.radius", "a number from 0 to 1e12"));
    }
    let level = Level::Radius { center: Vec3::ZERO, radius: 1.0 };
    assert_eq!(profile(Profile { level, from: -1.5, ..AIR }), ("from", "at least −`level.radius`"));
}

#[test]
fn methods_are_checked() {
    let method = |method| profile(Profile { method, ..AIR });
    const POSITIVE: &str = "a number from 1e-12 to 1e12";
    for wrong in [0.0, -1.0, NAN, f32::INFINITY] {
        assert_eq!(method(Method::Layers { thickness: wrong }), ("method.thickness", POSITIVE));
        assert_eq!(method(Method::Steps(Steps::Fixed { length: wrong })), ("method.length", POSITIVE));
        let tolerance = ("method.tolerance", "a number from 1e-7 to 0.1");
        assert_eq!(method(Method::Steps(Steps::Controlled { tolerance: wrong })), tolerance);
    }
    let layers = ("method.thickness", "a thickness that makes at most 65535 layers");
    assert_eq!(method(Method::Layers { thickness: 1e-5 }), layers);
}

#[test]
fn laws_are_checked() {
    const INDEX: (&str, &str) =
        ("law", "numbers that give an index of refraction from 1e-3 to 1e3 between the levels `from` and `to`");
    const POSITIVE: &str = "a number from 1e-12 to 1e12";
    for wrong in [0.0, -1.0, NAN, f32::INFINITY] {
        let scale = ("law.scale", POSITIVE);
        assert_eq!(law(Law::Exponential { far: 1.0, excess: 0.1, scale: wrong }), scale);
        assert_eq!(law(Law::Thermal { excess: 0.1, ratio: 0.1, scale: wrong }), scale);
        let inversion = Law::Inversion { below: 0.1, above: 0.2, height: 1.0, thickness: wrong };
        assert_eq!(law(inversion), ("law.thickness", POSITIVE));
        assert_eq!(law(Law::FishEye { index: 1.5, radius: wrong }), ("law.radius", POSITIVE));
        assert_eq!(law(Law::Table { spacing: wrong, values: &[0.1, 0.2] }), ("law.spacing", POSITIVE));
    }
    for wrong in [NAN, f32::INFINITY] {
        assert_eq!(law(Law::Polynomial { constant: wrong, linear: 0.0, quadratic: 0.0 }), INDEX);
        assert_eq!(law(Law::Polynomial { constant: 1.0, linear: wrong, quadratic: 0.0 }), INDEX);
        assert_eq!(law(Law::Polynomial { constant: 1.0, linear: 0.0, quadratic: wrong }), INDEX);
        assert_eq!(law(Law::Exponential { far: wrong, excess: 0.1, scale: 0.5 }), INDEX);
        assert_eq!(law(Law::Exponential { far: 1.0, excess: wrong, scale: 0.5 }), INDEX);
        assert_eq!(law(Law::Thermal { excess: wrong, ratio: 0.1, scale: 0.5 }), INDEX);
        assert_eq!(law(Law::Inversion { below: wrong, above: 0.2, height: 1.0, thickness: 0.5 }), INDEX);
        assert_eq!(law(Law::Inversion { below: 0.1, above: wrong, height: 1.0, thickness: 0.5 }), INDEX);
        let height = ("law.height", "a finite number of at most 1e12");
        assert_eq!(law(Law::Inversion { below: 0.1, above: 0.2, height: wrong, thickness: 0.5 }), height);
        assert_eq!(law(Law::FishEye { index: wrong, radius: 1.0 }), INDEX);
    }
    // What cancels out to nothing but rounding.
    let digits = ("law", "terms of at most 1e6 times their sum, so that digits are left of it");
    assert_eq!(law(Law::Polynomial { constant: -1e7, linear: 0.0, quadratic: 1e7 }).0, "law");
    let high = Profile { from: 1e7, to: 1e7 + 1.0, ..AIR };
    let linear = Law::Polynomial { constant: -1e7, linear: 1.0, quadratic: 0.0 };
    assert_eq!(profile(Profile { law: linear, ..high }), digits);
    assert_eq!(law(Law::Exponential { far: -4_194_304.0, excess: 4_194_306.0, scale: 1e9 }), digits);
    // Below nothing at one end, at the other, and in between only.
    assert_eq!(law(Law::Polynomial { constant: -1.0, linear: 0.1, quadratic: 0.0 }), INDEX);
    assert_eq!(law(Law::Polynomial { constant: 0.5, linear: -1.0, quadratic: 0.0 }), INDEX);
    assert_eq!(law(Law::Polynomial { constant: 0.0, linear: -4.0, quadratic: 2.0 }), INDEX);
    assert_eq!(law(Law::Exponential { far: 1.0, excess: -1.0, scale: 0.5 }), INDEX);
    assert_eq!(law(Law::Exponential { far: 1e4, excess: 0.0, scale: 0.5 }), INDEX);
    for ratio in WRONG {
        let warmth = ("law.ratio", "a temperature from 1e-3 to 1e12 times that far up, everywhere");
        assert_eq!(law(Law::Thermal { excess: 0.0, ratio, scale: 0.5 }), warmth);
    }
    assert_eq!(law(Law::FishEye { index: 1.0, radius: 0.01 }), INDEX);
}

/// Tables are slices of numbers, so the ones in `f64` are made by hand.
#[test]
fn tables_are_checked() {
    const TABLE: &str = "two values at least, each of an index from 0.1 to 10, and at most twice its neighbour's";
    const SHORT: &str = "values up to the level `to`";
    let cases: [(&'static [f32], &str); 9] = [
        (&[], TABLE),
        (&[0.1], TABLE),
        (&[0.1, NAN, 0.1, 0.1, 0.1], TABLE),
        (&[0.1, 0.1, 0.1, 0.1, f32::INFINITY], TABLE),
        (&[0.1, -0.95, 0.1, 0.1, 0.1], TABLE),
        (&[8.0, 9.5, 8.0, 8.0, 8.0], TABLE),
        (&[0.1, 0.1, 0.1, 0.1, 1.3], TABLE),
        (&[1.3, 0.1, 0.1, 0.1, 0.1], TABLE),
        (&[0.1, 0.1, 0.1, 0.1], SHORT),
    ];
    for (values, expected) in cases {
        assert_eq!(law(Law::Table { spacing: 0.5, values }), ("law.values", expected), "{values:?}");
        let error = wide_table(0.5, values).unwrap_err();
        assert_eq!(error, SceneError { place: Place::Profile(0), field: "law.values", expected }, "{values:?}");
    }
    assert!(wide_table(0.5, &[0.1, 0.2, 0.1, 0.2, 0.1]).is_ok());
    assert_eq!(wide_table(NAN, &[0.1, 0.2]).unwrap_err().field, "law.spacing");
    let long = Profile { law: Law::Table { spacing: 1.0, values: &[0.1, 0.2, 0.3] }, ..AIR };
    assert_eq!(profile(Profile { to: -1.0, ..long }).0, "to");
    assert_eq!(profile(Profile { method: Method::Layers { thickness: 0.0 }, ..long }).0, "method.thickness");
}

fn wide_table(spacing: f32, values: &[f32]) -> Result<(), SceneError> {
    let values: Vec<f64> = values.iter().map(|x| f64::from(*x)).collect();
    let profiles = [Profile {
        level: Level::Height { origin: Vec3::ZERO, up: UP.map(f64::from) },
        from: 0.0,
        to: 2.0,
        law: Law::Table { spacing: f64::from(spacing), values: &values },
        method: Method::Steps(Steps::Fixed { length: 0.1 }),
    }];
    let wide = SceneBuf::<f64, 1, 1>::from_scene(&PLAIN, f64::from).unwrap();
    wide.as_scene().with_profiles(&profiles).validate()
}

/// What is said of a scene: in constants, in `f32` and in `f64`.
fn whole(scene: &Scene<'_, f32>) -> String {
    let error = scene.check().unwrap_err();
    assert_eq!(scene.validate().unwrap_err(), error);
    let wide = SceneBuf::<f64, 2, 1, 2>::from_scene(scene, f64::from).unwrap();
    assert_eq!(wide.as_scene().validate().unwrap_err(), error);
    error.to_string()
}

#[test]
fn media_name_profiles_that_are_there() {
    const EXPECTED: &str = "expected the number of one of the scene's profiles";
    let glass = |number| Object::new(SPHERE, Material::transparent(Medium::graded(number)));
    for (profiles, missing) in [(&[][..], 0), (&[][..], 255), (&[AIR][..], 1), (&[AIR, AIR][..], 2)] {
        let scene = PLAIN.with_profiles(profiles);
        assert_eq!(whole(&scene.with_medium(Medium::graded(missing))), format!("scene: medium.index: {EXPECTED}"));
        let objects = [Object::new(SPHERE, Material::dielectric(1.5)), glass(missing)];
        let message = format!("object 1: interface.medium.index: {EXPECTED}");
        assert_eq!(whole(&scene.with_objects(&objects)), message);
        let medium = Medium::graded(missing);
        let constant = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
        let objects = [objects[0], Object::new(SPHERE, Material::dielectric(1.5).with_interface(constant))];
        assert_eq!(whole(&scene.with_objects(&objects)), message);
    }
    // A profile that no medium names is checked all the same.
    let unused = [Profile { to: NAN, ..AIR }];
    assert_eq!(whole(&PLAIN.with_profiles(&unused)), "profile 0: to: expected a finite number of at most 1e12");
}

#[test]
fn black_holes_are_checked() {
    const STEPS: Steps<f32> = Steps::Controlled { tolerance: 1e-5 };
    const HOLE: BlackHole<f32> = BlackHole { center: Vec3::ZERO, mass: 1.0, steps: STEPS };
    let hole = |hole| whole(&PLAIN.with_black_hole(hole));
    assert!(PLAIN.with_black_hole(HOLE).check().is_ok() && PLAIN.with_black_hole(HOLE).validate().is_ok());
    for mass in [0.0, -1.0, 1e-10, NAN, f32::INFINITY, 2e9] {
        assert_eq!(hole(BlackHole { mass, ..HOLE }), "scene: black_hole.mass: expected a number from 1e-9 to 1e9");
    }
    for wrong in [NAN, f32::INFINITY, 2e12] {
        let center = Vec3::new(0.0, 0.0, wrong);
        let message = "scene: black_hole.center: expected a finite number of at most 1e12";
        assert_eq!(hole(BlackHole { center, ..HOLE }), message);
    }
    // The eye is 5 away.
    for mass in [2.5, 3.0, 1e9] {
        let message = "scene: black_hole.center: expected an eye outside of the horizon at 2·`mass`";
        assert_eq!(hole(BlackHole { mass, ..HOLE }), message);
    }
    for length in [0.0, -1.0, 0.6, NAN] {
        let message = "scene: black_hole.steps.length: expected a share of the distance from 1e-4 to 0.5";
        assert_eq!(hole(BlackHole { steps: Steps::Fixed { length }, ..HOLE }), message);
    }
    for tolerance in [0.0, -1.0, 0.2, NAN] {
        let message = "scene: black_hole.steps.tolerance: expected a number from 1e-7 to 0.1";
        assert_eq!(hole(BlackHole { steps: Steps::Controlled { tolerance }, ..HOLE }), message);
    }
    let both = PLAIN.with_black_hole(HOLE).with_profiles(&[AIR]);
    assert_eq!(whole(&both), "scene: profiles: expected no profile where there is a black hole");
}

#[test]
fn rings_stars_and_annuli_are_checked() {
    const POSITIVE: &str = "expected a number from 1e-12 to 1e12";
    for wrong in [NAN, -1.0, f32::INFINITY] {
        let rings =
            |even, odd, width| material(Material::patterned(Pattern::Rings { even, odd, center: Vec3::ZERO, width }));
        let color = Rgb::new(0.5, wrong, 0.5);
        assert_eq!(rings(color, Rgb::WHITE, 1.0), "body.color.even: expected a number from 0 to 1e12");
        assert_eq!(rings(Rgb::WHITE, color, 1.0), "body.color.odd: expected a number from 0 to 1e12");
        assert_eq!(rings(Rgb::WHITE, Rgb::WHITE, wrong), format!("body.color.width: {POSITIVE}"));
        let stars = |sky, brightness, cells, radius| {
            whole(&Scene { background: Background::Stars { sky, brightness, cells, radius }, ..PLAIN })
        };
        assert_eq!(stars(color, 1.0, 9, 0.2), "scene: background.sky: expected a number from 0 to 1e12");
        let message = "scene: background.brightness: expected a number from 0 to 1e12";
        assert_eq!(stars(Rgb::BLACK, wrong, 9, 0.2), message);
        assert_eq!(stars(Rgb::BLACK, 1.0, 0, 0.2), "scene: background.cells: expected at least 1");
        let message = "scene: background.radius: expected a share of a cell from 1e-3 to 0.5";
        assert_eq!(stars(Rgb::BLACK, 1.0, 9, wrong), message);
        let annulus = |center, normal, inner, outer| {
            refused(Object::new(Shape::annulus(center, normal, inner, outer), Material::matte(Rgb::WHITE)))
        };
        assert_eq!(annulus(Vec3::ZERO, UP, 0.5, wrong), format!("object 1: outer: {POSITIVE}"));
        assert_eq!(annulus(Vec3::ZERO, UP, wrong, 1.0), "object 1: inner: expected a radius from 0 to `outer`");
        let message = "object 1: normal: expected finite numbers, not all zero";
        assert_eq!(annulus(Vec3::ZERO, Vec3::ZERO, 0.5, 1.0), message);
    }
    let center = Vec3::new(NAN, 0.0, 0.0);
    let rings = Pattern::Rings { even: Rgb::WHITE, odd: Rgb::BLACK, center, width: 1.0 };
    let message = "body.color.center: expected a finite number of at most 1e12";
    assert_eq!(material(Material::patterned(rings)), message);
}
