//! What has no room in fixed point is refused, and told by its place, its field and what is expected.

use whit::math::{Q16, Q20};
use whit::render::{Settings, SettingsError, Size};
use whit::scene::{
    Aperture, Balance, BlackHole, Cone, Emitter, Exponent, Extent, Falloff, Film, Highlight, Index, Law, Lens, Level,
    Lobe, Medium, Method, Place, Profile, SmoothTriangle, Steps, Thickness,
};
use whit::{
    Background, Camera, Frame, Interface, Light, Material, Object, Pattern, Real, Rgb, Scene, SceneBuf, Shape, Tone,
    Tracer, Vec3,
};

use super::ALL;

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const EYE: Camera<f32> = Camera::with_half_height(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 0.5);

type Buffer<T> = SceneBuf<T, 4, 2, 2>;

/// What is said of a scene; nothing if it is accepted.
fn said<T: Real>(change: impl Fn(&mut Buffer<f32>)) -> Option<(Place, &'static str, &'static str)> {
    let mut scene = SceneBuf::new(EYE, Background::Solid(Rgb::grey(0.5)));
    change(&mut scene);
    let scene = Buffer::<T>::from_scene(&scene.as_scene(), T::from_f32).unwrap();
    let error = scene.as_scene().validate().err()?;
    let refused = Tracer::<T, ALL, 4, 2>::try_new(&scene.as_scene()).unwrap_err();
    assert_eq!(refused.to_string(), error.to_string());
    Some((error.place, error.field, error.expected))
}

/// Asserts that a scene is refused in both types, in such words for `Q16` and such for `Q20`.
fn assert_said(place: Place, field: &'static str, [q16, q20]: [&'static str; 2], change: impl Fn(&mut Buffer<f32>)) {
    assert_eq!(said::<Q16>(&change), Some((place, field, q16)));
    assert_eq!(said::<Q20>(&change), Some((place, field, q20)));
    assert_eq!(said::<f32>(&change), None, "{field}");
}

fn assert_same_said(place: Place, field: &'static str, expected: &'static str, change: impl Fn(&mut Buffer<f32>)) {
    assert_said(place, field, [expected; 2], change);
}

const COORDINATE: [&str; 2] = ["a number from -1024 to 1024", "a number from -64 to 64"];
const AMOUNT: [&str; 2] = ["a number from 0 to 64", "a number from 0 to 16"];
const THICKNESS: [&str; 2] = ["a thickness of at most 15360 nm", "a thickness of at most 960 nm"];
const DIRECTION: &str = "a direction of length 1/64 to 1.5";
const COURSE: &str = "a direction of length 1/64 or more";
const INDEX: &str = "an index of refraction from 1/2 to 4";
const FAR: f32 = 1025.0;
const BRIGHT: f32 = 65.0;

fn matte() -> Material<f32> {
    Material::matte(Rgb::WHITE)
}

fn add(shape: Shape<'static, f32>) -> impl Fn(&mut Buffer<f32>) {
    move |scene| scene.add_object(Object::new(shape, matte())).unwrap()
}

fn made_of(material: Material<f32>) -> impl Fn(&mut Buffer<f32>) {
    move |scene| {
        scene.add_object(Object::new(Shape::sphere(Vec3::ZERO, 1.0), matte())).unwrap();
        scene.add_object(Object::new(Shape::sphere(Vec3::ZERO, 1.0), material)).unwrap();
    }
}

fn lit_by(light: Light<f32>) -> impl Fn(&mut Buffer<f32>) {
    move |scene| scene.add_light(light).unwrap()
}

#[test]
fn what_is_in_range_is_accepted() {
    assert_eq!(said::<Q16>(add(Shape::sphere(Vec3::splat(1024.0), -1024.0))), None);
    assert_eq!(said::<Q20>(add(Shape::sphere(Vec3::splat(-64.0), 64.0))), None);
    assert_eq!(said::<Q16>(lit_by(Light::point(UP, Rgb::grey(64.0)))), None);
    assert_eq!(said::<Q20>(lit_by(Light::point(UP, Rgb::grey(16.0)))), None);
}

#[test]
fn cameras_beyond_the_range() {
    let at = Place::Camera;
    assert_said(at, "eye", COORDINATE, |scene| scene.camera.eye.z = FAR);
    assert_said(at, "target", COORDINATE, |scene| scene.camera.target.x = -FAR);
    assert_said(at, "up", COORDINATE, |scene| scene.camera.up = UP * FAR);
    assert_same_said(at, "up", COURSE, |scene| scene.camera.up = UP * 0.015);
    assert_same_said(at, "half_height", "a tangent from 1e-3 to 8", |scene| scene.camera.half_height = 8.1);
    assert_same_said(at, "half_height", "a tangent from 1e-3 to 8", |scene| scene.camera.half_height = 9e-4);
    let lens = |radius, focus| {
        move |scene: &mut Buffer<f32>| scene.camera.lens = Some(Lens { aperture: Aperture::Disc { radius }, focus })
    };
    assert_said(at, "lens.aperture", COORDINATE, lens(FAR, 1.0));
    assert_said(at, "lens.focus", COORDINATE, lens(1.0, FAR));
    assert_eq!(EYE.extent, Extent::PixelEdges);
}

#[test]
fn surroundings_beyond_the_range() {
    let (at, c) = (Place::Scene, Rgb::grey(BRIGHT));
    assert_said(at, "background", AMOUNT, |scene| scene.background = Background::Solid(c));
    let gradient =
        |below, above| move |scene: &mut Buffer<f32>| scene.background = Background::Gradient { below, above, up: UP };
    assert_said(at, "background.below", AMOUNT, gradient(c, Rgb::WHITE));
    assert_said(at, "background.above", AMOUNT, gradient(Rgb::WHITE, c));
    assert_said(at, "background.horizon", AMOUNT, |scene| scene.background = Background::Sky { horizon: c, up: UP });
    let stars = |sky, brightness, cells, radius| {
        move |scene: &mut Buffer<f32>| scene.background = Background::Stars { sky, brightness, cells, radius }
    };
    assert_said(at, "background.sky", AMOUNT, stars(c, 1.0, 9, 0.1));
    assert_said(at, "background.brightness", AMOUNT, stars(Rgb::WHITE, BRIGHT, 9, 0.1));
    assert_said(at, "background.cells", COORDINATE, stars(Rgb::WHITE, 1.0, 1025, 0.1));
    let radius = "a share of a cell from 1/64 to 0.5";
    assert_same_said(at, "background.radius", radius, stars(Rgb::WHITE, 1.0, 9, 0.01));
    assert_said(at, "tone.gain", COORDINATE, |scene| scene.tone = Tone::Display { gain: FAR, lift: 0.0 });
    assert_said(at, "tone.lift", COORDINATE, |scene| scene.tone = Tone::Display { gain: 1.0, lift: -FAR });
    assert_same_said(at, "medium.index", INDEX, |scene| scene.medium = Medium::new(4.1));
    let thick = Medium::new(1.0).with_attenuation(Rgb::grey(FAR));
    assert_said(at, "medium.attenuation", COORDINATE, move |scene| scene.medium = thick);
}

#[test]
fn shapes_beyond_the_range() {
    let (at, far) = (Place::Object(0), Vec3::new(0.0, FAR, 0.0));
    let (zero, one) = (Vec3::ZERO, Vec3::splat(1.0));
    assert_said(at, "center", COORDINATE, add(Shape::sphere(far, 1.0)));
    assert_said(at, "radius", COORDINATE, add(Shape::sphere(zero, FAR)));
    assert_said(at, "point", COORDINATE, add(Shape::plane(far, UP)));
    assert_same_said(at, "normal", DIRECTION, add(Shape::plane(zero, UP * 2.0)));
    assert_same_said(at, "normal", DIRECTION, add(Shape::disc(zero, UP * 0.01, 1.0)));
    assert_said(at, "radius", COORDINATE, add(Shape::disc(zero, UP, FAR)));
    assert_said(at, "outer", COORDINATE, add(Shape::annulus(zero, UP, 1.0, FAR)));
    assert_said(at, "max", COORDINATE, add(Shape::axis_box(zero, one * FAR)));
    assert_said(at, "vertices", COORDINATE, add(Shape::triangle(zero, one, far)));
    let smooth =
        |normal| Shape::SmoothTriangle(SmoothTriangle { vertices: [zero, one, UP], normals: [UP, UP, normal] });
    assert_said(at, "normals", COORDINATE, add(smooth(UP * FAR)));
    assert_same_said(at, "normals", COURSE, add(smooth(UP * 0.01)));
    let cone = |apex, base_radius, apex_radius| {
        Shape::Cone(Cone { base: zero, apex, base_radius, apex_radius, capped: false })
    };
    assert_said(at, "apex", COORDINATE, add(cone(far, 1.0, 1.0)));
    assert_said(at, "base_radius", COORDINATE, add(cone(UP, FAR, FAR)));
    let flat = "a radius that differs from the other by at most 4 times the height";
    assert_same_said(at, "apex_radius", flat, add(cone(UP, 1.0, 5.1)));
    assert_same_said(at, "apex_radius", flat, add(cone(UP, -5.1, -1.0)));
}

/// What is smaller than the spacing of the numbers is nothing.
#[test]
fn shapes_below_the_spacing() {
    let sphere = add(Shape::sphere(Vec3::ZERO, 1e-7));
    assert_same_said(Place::Object(0), "radius", "a number from 1e-12 to 1e12", sphere);
}

#[test]
fn materials_beyond_the_range() {
    let at = Place::Object(1);
    let (bright, white) = (Rgb::grey(BRIGHT), Rgb::WHITE);
    assert_said(at, "body.color", AMOUNT, made_of(Material::matte(bright)));
    let far = Vec3::splat(FAR);
    let checker = Pattern::Checker { even: white, odd: white, u: far, v: UP };
    assert_said(at, "body.color", COORDINATE, made_of(Material::patterned(checker)));
    let rings = Pattern::Rings { even: white, odd: bright, center: UP, width: 1.0 };
    assert_said(at, "body.color", AMOUNT, made_of(Material::patterned(rings)));
    assert_said(at, "body.emission", AMOUNT, made_of(matte().with_shares(BRIGHT, 0.0, 0.0)));
    assert_said(at, "body.ambient", AMOUNT, made_of(matte().with_shares(0.0, BRIGHT, 0.0)));
    assert_said(at, "body.diffuse", AMOUNT, made_of(matte().with_shares(0.0, 0.0, BRIGHT)));
    let sent = "a colour whose product with `ambient` + `diffuse` is in range";
    assert_same_said(at, "body.color", sent, made_of(Material::matte(Rgb::grey(10.0)).with_shares(0.0, 0.5, 6.0)));
    assert_said(at, "highlight.color", AMOUNT, made_of(matte().with_highlight(bright, 5)));
    let highlight = Highlight { color: white, lobe: Lobe::Blinn, exponent: Exponent::Real(FAR) };
    assert_said(at, "highlight.exponent", COORDINATE, made_of(Material { highlight: Some(highlight), ..matte() }));
    let balance = Balance { ratio: 0.0, brightness: BRIGHT };
    assert_said(at, "balance.brightness", AMOUNT, made_of(Material { balance: Some(balance), ..matte() }));
}

#[test]
fn interfaces_beyond_the_range() {
    let at = Place::Object(1);
    assert_same_said(at, "interface.medium.index", INDEX, made_of(Material::dielectric(4.1)));
    assert_same_said(at, "interface.medium.index", INDEX, made_of(Material::dielectric(0.49)));
    let dispersive = Material::transparent(Medium::dispersive(Rgb::new(1.5, 1.5, 4.1)));
    assert_same_said(at, "interface.medium.index", INDEX, made_of(dispersive));
    assert_same_said(at, "interface.index", INDEX, made_of(matte().with_coat(5.0)));
    let thick = Material::transparent(Medium::new(1.5).with_attenuation(Rgb::grey(FAR)));
    assert_said(at, "interface.medium.attenuation", COORDINATE, made_of(thick));
    let constant = |reflected, transmitted| {
        let interface = Interface::Constant { reflected, transmitted, medium: Medium::new(1.5) };
        made_of(matte().with_interface(interface))
    };
    let whole = "at most what is not reflected";
    assert_same_said(at, "interface.transmitted", whole, constant(Rgb::grey(0.75), Rgb::grey(0.5)));
    let (one, much, little) = (Rgb::WHITE, Rgb::new(1.0, 1.0, 12.5), Rgb::grey(0.25));
    assert_same_said(at, "interface.index", "a number from 0 to 12", made_of(Material::conductor(much, one)));
    assert_same_said(at, "interface.extinction", "a number from 0 to 12", made_of(Material::conductor(one, much)));
    let small = "with `interface.index`, a complex number of size 1/2 or more";
    assert_same_said(at, "interface.extinction", small, made_of(Material::conductor(little, little)));
}

#[test]
fn films_beyond_the_range() {
    let at = Place::Object(1);
    let film = |film| made_of(Material::dielectric(1.5).with_film(film));
    assert_same_said(at, "interface.film.index", INDEX, film(Film::new(4.5, 100.0)));
    assert_said(at, "interface.film.thickness", THICKNESS, film(Film::new(1.5, 15_361.0)));
    let gradient = |to, axis| {
        film(Film::new(1.5, 0.0).with_thickness(Thickness::Gradient { from: 0.0, to, origin: Vec3::ZERO, axis }))
    };
    assert_said(at, "interface.film.thickness", THICKNESS, gradient(99_000.0, UP));
    assert_said(at, "interface.film.thickness", COORDINATE, gradient(1.0, UP * FAR));
    let radial = Thickness::Radial { from: 0.0, to: 1.0, center: UP, radius: FAR };
    assert_said(at, "interface.film.thickness", COORDINATE, film(Film::new(1.5, 0.0).with_thickness(radial)));
}

#[test]
fn lights_beyond_the_range() {
    let (at, white, far) = (Place::Light(0), Rgb::WHITE, Vec3::splat(-FAR));
    assert_said(at, "color", AMOUNT, lit_by(Light::point(UP, Rgb::new(0.0, 0.0, BRIGHT))));
    assert_said(at, "position", COORDINATE, lit_by(Light::point(far, white)));
    assert_said(at, "towards", COORDINATE, lit_by(Light::directional(UP * FAR, white)));
    assert_same_said(at, "towards", COURSE, lit_by(Light::directional(UP * 0.01, white)));
    assert_said(at, "center", COORDINATE, lit_by(Light::sphere(far, 1.0, white)));
    assert_said(at, "radius", COORDINATE, lit_by(Light::sphere(UP, FAR, white)));
    let emitter = Emitter::Parallelogram { corner: UP, edge_u: UP, edge_v: far };
    assert_said(at, "edge_v", COORDINATE, lit_by(Light { emitter, ..Light::point(UP, white) }));
    let falloff = |constant, linear, quadratic| {
        lit_by(Light::point(UP, white).with_falloff(Falloff { constant, linear, quadratic }))
    };
    assert_same_said(at, "falloff.constant", "a number of at least 1/64", falloff(0.01, 0.0, 0.0));
    assert_said(at, "falloff.linear", COORDINATE, falloff(1.0, FAR, 0.0));
    assert_said(at, "falloff.quadratic", COORDINATE, falloff(1.0, 0.0, FAR));
}

#[test]
fn what_bends_light() {
    let expected = "nothing that bends light, in fixed point";
    let steps = Steps::Fixed { length: 0.1 };
    let profile = Profile {
        level: Level::Height { origin: Vec3::ZERO, up: UP },
        from: 0.0,
        to: 1.0,
        law: Law::Exponential { far: 1.0, excess: 0.1, scale: 1.0 },
        method: Method::Steps(steps),
    };
    assert_same_said(Place::Scene, "profiles", expected, |scene| scene.add_profile(profile).unwrap());
    let hole = BlackHole { center: Vec3::ZERO, mass: 0.1, steps };
    assert_same_said(Place::Scene, "black_hole", expected, |scene| scene.black_hole = Some(hole));
    // That there is no such profile is said of all number types.
    let graded = |scene: &mut Buffer<f32>| scene.medium = Medium { index: Index::Profile(0), ..Medium::VACUUM };
    let missing = "the number of one of the scene's profiles";
    assert_eq!(said::<Q16>(graded), Some((Place::Scene, "medium.index", missing)));
    assert_eq!(said::<f32>(graded), Some((Place::Scene, "medium.index", missing)));
}

fn size_error<T: Real>(width: u32, height: u32) -> Option<SettingsError> {
    let c = T::from_f32;
    let camera = Camera::with_half_height(EYE.eye.map(c), EYE.target.map(c), EYE.up.map(c), T::HALF);
    let scene = Scene::new(camera, Background::Solid(Rgb::BLACK));
    let tracer = Tracer::<T, ALL, 8>::try_new(&scene).unwrap();
    Frame::new(&tracer, Settings::new(width, height)).err()
}

/// A column must be a number.
#[test]
fn pictures_that_are_too_wide() {
    let error = |width, height, largest| Some(SettingsError::Size { asked: Size::new(width, height), largest });
    assert_eq!(size_error::<Q16>(16_383, 16_383), None);
    assert_eq!(size_error::<Q16>(16_384, 1), error(16_384, 1, 16_383));
    assert_eq!(size_error::<Q16>(1, 16_384), error(1, 16_384, 16_383));
    assert_eq!(size_error::<Q20>(1023, 1023), None);
    assert_eq!(size_error::<Q20>(1024, 1), error(1024, 1, 1023));
}
