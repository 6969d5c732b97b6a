//! Pairs of small scenes that differ by one effect or a few that go together.
//!
//! This file is part of two programs: the tool, and the probes that it builds to see what a tracer is made of.
#![allow(dead_code)] // A probe uses one scene.

use whit::optics::{Band, bands, materials};
use whit::scene::{
    Aperture, BlackHole, Emitter, Exponent, Falloff, Film, Fresnel, HierarchyBuf, Highlight, Law, Lens, Level, Lobe,
    Medium, Method, Offset, PackedSpheres, Profile, ShadowRays, SmoothTriangle, Spectrum, Sphere, Steps, Thickness,
    Triangle,
};
use whit::{Background, Camera, Interface, Light, Material, Object, Pattern, Rgb, Scene, Shape, Tone, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const ORIGIN: Vec3<f32> = Vec3::new(0.0, 0.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 1.2, 3.0), Vec3::new(0.0, 0.8, 0.0), UP, 50.0);
const LENS: Lens<f32> = Lens { aperture: Aperture::Disc { radius: 0.02 }, focus: 3.0 };
const SUN: Light<f32> = Light::directional(Vec3::new(0.4, 1.0, 0.6), Rgb::grey(0.8));
const LAMP: Light<f32> = Light::point(Vec3::new(2.0, 4.0, 3.0), Rgb::grey(0.8));
const BODY: Material<f32> = Material::matte(Rgb::new(0.6, 0.5, 0.3));
const FLOOR: Object<'static, f32> = Object::new(Shape::plane(ORIGIN, UP), BODY);
const SKY: Background<f32> = Background::Solid(Rgb::new(0.5, 0.6, 0.8));
const BALL: Shape<'static, f32> = Shape::sphere(UP, 0.9);
const CUBE: Shape<'static, f32> = Shape::axis_box(Vec3::new(-0.6, 0.1, -0.6), Vec3::new(0.6, 1.5, 0.6));
const WATER: Medium<f32> = Medium::new(materials::WATER);
const GLASS: Medium<f32> = Medium::new(materials::CROWN_GLASS);
const TINT: Rgb<f32> = Rgb::new(0.2, 0.4, 0.9);
const GOLD: Material<f32> = Material::conductor(materials::GOLD.index, materials::GOLD.extinction);
const SOAP: Film<f32> = Film::new(materials::SOAP_FILM, 400.0);
const DRAINING: Thickness<f32> = Thickness::Gradient { from: 0.0, to: 900.0, origin: ORIGIN, axis: UP };
const SPREADING: Thickness<f32> = Thickness::Radial { from: 900.0, to: 50.0, center: ORIGIN, radius: 2.0 };
const CORNERS: [Vec3<f32>; 3] = [Vec3::new(-1.0, 0.1, 0.0), Vec3::new(1.0, 0.1, 0.0), Vec3::new(0.0, 1.9, 0.0)];
const TRIANGLES: [Triangle<f32>; 1] = [Triangle { vertices: CORNERS }];
const PACKED: PackedSpheres<f32, 1, 1> = PackedSpheres::new(&[Sphere { center: UP, radius: 0.9 }]);
const FLAT: Level<f32> = Level::Height { origin: ORIGIN, up: UP };
const ROUND: Level<f32> = Level::Radius { center: Vec3::new(0.0, -9.0, 0.0), radius: 9.0 };
const EXPONENTIAL: Law<'static, f32> = Law::Exponential { far: 1.0, excess: 0.1, scale: 0.4 };
const LINEAR: Law<'static, f32> = Law::Polynomial { constant: 0.2, linear: -0.1, quadratic: 0.0 };
const TABLE: Law<'static, f32> = Law::Table { spacing: 0.5, values: &[0.1, 0.06, 0.03, 0.01, 0.0] };
const CONTROLLED: Steps<f32> = Steps::Controlled { tolerance: 1e-3 };
const AIR: Profile<'static, f32> =
    Profile { level: FLAT, from: 0.0, to: 2.0, law: EXPONENTIAL, method: Method::Steps(CONTROLLED) };
const LAYERS: Method<f32> = Method::Layers { thickness: 0.25 };
const FIXED: Method<f32> = Method::Steps(Steps::Fixed { length: 0.25 });
static SPECTRUM: [Band; 38] = bands();
const BOXES: HierarchyBuf<1, 2> = HierarchyBuf::of(&SPHERE);

const fn ball(material: Material<f32>) -> [Object<'static, f32>; 2] {
    [FLOOR, Object::new(BALL, material)]
}

const fn body(shape: Shape<'static, f32>) -> [Object<'static, f32>; 2] {
    [FLOOR, Object::new(shape, BODY)]
}

const fn soap(film: Film<f32>) -> [Object<'static, f32>; 2] {
    ball(Material::dielectric(1.0).with_film(film))
}

const fn shining(lobe: Lobe, exponent: Exponent<f32>) -> [Object<'static, f32>; 2] {
    ball(Material { highlight: Some(Highlight { color: Rgb::grey(0.5), lobe, exponent }), ..BODY })
}

const fn constant() -> Interface<f32> {
    Interface::Constant { reflected: Rgb::grey(0.2), transmitted: Rgb::grey(0.8), medium: GLASS }
}

macro_rules! scenes {
    ($($name:ident = $objects:expr $(, $field:ident: $value:expr)*;)*) => {
        $(pub const $name: Scene<'static, f32> = {
            const OBJECTS: [Object<'static, f32>; 2] = $objects;
            const PLAIN: Scene<'static, f32> = Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&[SUN]);
            Scene { $($field: $value,)* ..PLAIN }
        };)*
    };
}

scenes! {
    EMPTY = [FLOOR, FLOOR];
    SPHERE = ball(BODY);
    TWO_BOXES = [Object::new(CUBE, BODY); 2];
    SPHERES = body(Shape::Spheres(PACKED.view()));
    DISC = body(Shape::disc(UP, Vec3::new(0.0, 0.0, 1.0), 0.9));
    BOX = body(CUBE);
    TRIANGLE = body(Shape::Triangle(TRIANGLES[0]));
    TRIANGLES_ = body(Shape::Triangles(&TRIANGLES));
    SMOOTH = body(Shape::SmoothTriangle(SmoothTriangle { vertices: CORNERS, normals: [UP, CORNERS[1], CORNERS[2]] }));
    CONE = body(Shape::cone(ORIGIN, 0.9, Vec3::new(0.0, 1.8, 0.0), 0.2).capped());
    ONE_SIDED = [FLOOR, Object::new(BALL, BODY).one_sided()];
    SHADOWLESS = [FLOOR, Object::new(BALL, BODY).without_shadow()];
    DARK = [Object::new(Shape::plane(ORIGIN, UP), Material::mirror(Rgb::grey(0.5))); 2];
    LIT = [Object::new(Shape::plane(ORIGIN, UP), Material::mirror(Rgb::grey(0.5))), FLOOR];
    CHECKER = ball(Material::patterned(Pattern::Checker { even: TINT, odd: Rgb::WHITE, u: UP, v: CORNERS[1] }));
    GRADIENT = ball(Material::patterned(Pattern::Gradient { from: TINT, to: Rgb::WHITE, origin: ORIGIN, axis: UP }));
    BLINN = shining(Lobe::Blinn, Exponent::Integer(60));
    BLINN_REAL = shining(Lobe::Blinn, Exponent::Real(60.5));
    PHONG = shining(Lobe::Phong, Exponent::Integer(60));
    POINT = ball(BODY), lights: &[LAMP];
    FALLOFF = ball(BODY), lights: &[LAMP.with_falloff(Falloff { constant: 1.0, linear: 0.0, quadratic: 0.1 })];
    BALL_LIGHT = ball(BODY), lights: &[SUN, Light { emitter: Emitter::Sphere { center: CORNERS[2], radius: 0.3 }, ..SUN }];
    PANEL_LIGHT = ball(BODY), lights: &[SUN, Light {
        emitter: Emitter::Parallelogram { corner: CORNERS[2], edge_u: CORNERS[0], edge_v: CORNERS[1] }, ..SUN
    }];
    TWO_LIGHTS = ball(BODY), lights: &[SUN, LAMP];
    FADING = ball(BODY), background: Background::Gradient { below: Rgb::WHITE, above: TINT, up: UP };
    ZENITH = ball(BODY), background: Background::Sky { horizon: TINT, up: UP };
    OFFSET = ball(BODY), offset: Offset::Fixed(1e-3);
    IN_BOXES = body(BALL), hierarchy: Some(BOXES.view());
    LENSED = ball(BODY), camera: CAMERA.with_lens(LENS);
    DISPLAY = ball(BODY), tone: Tone::Display { gain: 0.9, lift: 0.05 };
    MIRROR = ball(Material::mirror(Rgb::grey(0.8)));
    METAL = ball(Material::metal(Rgb::grey(0.8)));
    CONDUCTOR = ball(GOLD);
    COAT = ball(BODY.with_coat(1.5));
    CONSTANT = ball(Material { interface: constant(), ..GOLD });
    EXACT = ball(Material::transparent(GLASS));
    SCHLICK = ball(Material::transparent(GLASS)), fresnel: Fresnel::Schlick;
    SEA = ball(BODY), medium: WATER.with_attenuation(TINT);
    TINTED_GLASS = ball(Material::transparent(GLASS.with_attenuation(TINT)));
    TINTED_SHADOW = [FLOOR, Object::new(BALL, Material::transparent(GLASS.with_attenuation(TINT))).with_tinted_shadow()];
    NESTED = ball(Material::transparent(GLASS.with_priority(1)));
    FLINT = ball(Material::transparent(Medium::dispersive(materials::dispersive::FLINT_GLASS.channels())));
    FILM_WAVELENGTHS = soap(SOAP.with_spectrum(Spectrum::Wavelengths));
    FILM_BANDS = soap(SOAP.with_spectrum(Spectrum::Bands(&SPECTRUM)));
    FILM_TABLE = soap(SOAP);
    FILM_GRADIENT = soap(SOAP.with_thickness(DRAINING));
    FILM_RADIAL = soap(SOAP.with_thickness(SPREADING));
    OXIDE = ball(GOLD.with_film(SOAP));
    ANNULUS = body(Shape::annulus(UP, Vec3::new(0.0, 0.0, 1.0), 0.4, 0.9));
    RINGS = ball(Material::patterned(Pattern::Rings { even: TINT, odd: Rgb::WHITE, center: UP, width: 0.2 }));
    STARS = ball(BODY), background: Background::Stars { sky: TINT, brightness: 2.0, cells: 30, radius: 0.3 };
    HEIGHT = ball(BODY), medium: Medium::graded(0), profiles: &[AIR];
    HEIGHT_BY_LAYERS = ball(BODY), medium: Medium::graded(1), profiles: &[AIR, Profile { method: LAYERS, ..AIR }];
    HEIGHT_IN_FIXED_STEPS = ball(BODY), medium: Medium::graded(0), profiles: &[Profile { method: FIXED, ..AIR }];
    HEIGHT_IN_BOTH_STEPS = ball(BODY), medium: Medium::graded(1), profiles: &[AIR, Profile { method: FIXED, ..AIR }];
    HEIGHT_AND_RADIUS = ball(BODY), medium: Medium::graded(1), profiles: &[AIR, Profile { level: ROUND, ..AIR }];
    RADIUS = ball(BODY), medium: Medium::graded(0), profiles: &[Profile { level: ROUND, ..AIR }];
    POLYNOMIAL = ball(BODY), medium: Medium::graded(0), profiles: &[Profile { law: LINEAR, ..AIR }];
    FISH_EYE = ball(BODY), medium: Medium::graded(1),
        profiles: &[AIR, Profile { law: Law::FishEye { index: 1.2, radius: 5.0 }, ..AIR }];
    TABULATED = ball(BODY), medium: Medium::graded(1), profiles: &[AIR, Profile { law: TABLE, ..AIR }];
    BENT_SHADOWS = ball(BODY), medium: Medium::graded(0), profiles: &[AIR], shadow_rays: ShadowRays::Bent;
    BLACK_HOLE = ball(BODY),
        black_hole: Some(BlackHole { center: Vec3::new(0.8, 1.6, 0.5), mass: 0.05, steps: CONTROLLED });
    BALANCED = ball(Material { balance: None, ..BODY }.with_interface(Interface::Mirror { reflected: Rgb::WHITE }));
    BALANCE = ball(BODY.with_interface(Interface::Mirror { reflected: Rgb::WHITE }).with_balance(0.3, 0.9));
}

/// Calls a macro with all pairs: the scene with an effect, the one without it, and a function of the library that is in
/// the binary of the first and not of the second, or `""` where the effect has none of its own.
macro_rules! pairs {
    ($callback:ident) => {
        $callback! {
            SPHERE, EMPTY, "sphere::intersect";
            BOX, TWO_BOXES, "plane::intersect";
            SPHERES, EMPTY, "spheres::intersect";
            DISC, EMPTY, "intersect_disc";
            BOX, EMPTY, "axis_box::intersect";
            TRIANGLE, EMPTY, "triangle::intersect";
            TRIANGLES_, EMPTY, "triangle::intersect";
            SMOOTH, EMPTY, "triangle::shading";
            CONE, EMPTY, "cone::intersect";
            ONE_SIDED, SPHERE, "";
            SHADOWLESS, SPHERE, "";
            LIT, DARK, "is_lit";
            CHECKER, SPHERE, "";
            GRADIENT, SPHERE, "";
            BLINN, SPHERE, "powi";
            PHONG, SPHERE, "powi";
            BLINN_REAL, SPHERE, "binary_logarithm";
            TWO_LIGHTS, POINT, "";
            TWO_LIGHTS, SPHERE, "";
            FALLOFF, POINT, "";
            BALL_LIGHT, SPHERE, "concentric";
            PANEL_LIGHT, SPHERE, "";
            FADING, SPHERE, "";
            ZENITH, SPHERE, "";
            OFFSET, SPHERE, "";
            IN_BOXES, SPHERE, "Line::meet";
            LENSED, SPHERE, "aperture_point";
            DISPLAY, SPHERE, "";
            MIRROR, SPHERE, "mirror";
            METAL, SPHERE, "mirror";
            CONDUCTOR, SPHERE, "fresnel_conductor";
            COAT, SPHERE, "coat";
            CONSTANT, SPHERE, "transmitted_cosine";
            EXACT, SPHERE, "fresnel_dielectric";
            SCHLICK, SPHERE, "schlick_dielectric";
            SEA, SPHERE, "transmittance";
            TINTED_GLASS, EXACT, "transmittance";
            TINTED_SHADOW, TINTED_GLASS, "next_tinted_surface";
            NESTED, EXACT, "around";
            FLINT, EXACT, "disperse";
            FILM_WAVELENGTHS, SPHERE, "by_wavelengths";
            FILM_BANDS, SPHERE, "by_bands";
            FILM_TABLE, SPHERE, "by_table";
            FILM_GRADIENT, FILM_TABLE, "";
            FILM_RADIAL, FILM_TABLE, "";
            OXIDE, SPHERE, "reflectance_of_film";
            BALANCE, BALANCED, "";
            ANNULUS, EMPTY, "intersect_annulus";
            RINGS, SPHERE, "";
            STARS, SPHERE, "stars::stars";
            HEIGHT, SPHERE, "graded";
            HEIGHT_AND_RADIUS, HEIGHT, "level::ball";
            HEIGHT_AND_RADIUS, RADIUS, "";
            HEIGHT, POLYNOMIAL, "decay";
            POLYNOMIAL, HEIGHT, "";
            FISH_EYE, HEIGHT, "";
            TABULATED, HEIGHT, "table::at";
            HEIGHT_BY_LAYERS, HEIGHT, "layers";
            HEIGHT_IN_BOTH_STEPS, HEIGHT, "verlet";
            HEIGHT, HEIGHT_IN_FIXED_STEPS, "nystrom";
            BENT_SHADOWS, HEIGHT, "towards";
            BLACK_HOLE, SPHERE, "orbit";
        }
    };
}
pub(crate) use pairs;
