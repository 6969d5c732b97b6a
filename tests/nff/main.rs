//! The reader of Neutral File Format: what it makes of files, and what it says about broken ones.
#![cfg(feature = "nff")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

mod errors;
mod polygons;
mod robustness;

use polygons::cyclic;
use whit::scene::nff::{EFFECTS, NffError, Summary, read, read_bytes};
use whit::scene::{Body, Exponent, Extent, Highlight, Lobe, Shadow, Sides, SmoothTriangle};
use whit::{Background, Camera, Interface, Light, Material, Medium, Object, Pattern, Rgb, SceneBuf, Shape, Tone, Vec3};

type Big = SceneBuf<f32, 640, 16>;

const FILES: [(&str, &str); 10] = [
    ("balls_s1", include_str!("../data/nff/balls_s1.nff")),
    ("balls_s2", include_str!("../data/nff/balls_s2.nff")),
    ("gears_s1", include_str!("../data/nff/gears_s1.nff")),
    ("mount_s4", include_str!("../data/nff/mount_s4.nff")),
    ("rings_s1", include_str!("../data/nff/rings_s1.nff")),
    ("teapot_s1", include_str!("../data/nff/teapot_s1.nff")),
    ("tetra_s3", include_str!("../data/nff/tetra_s3.nff")),
    ("tree_s2", include_str!("../data/nff/tree_s2.nff")),
    ("every_entity", EVERY_ENTITY),
    ("keyhole", include_str!("../data/nff/keyhole.nff")),
];
const EVERY_ENTITY: &str = include_str!("../data/nff/every_entity.nff");

/// A view and a surface: 8 lines.
const HEAD: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 32 32\nf 1 1 1 1 0 1 0 0\n";

#[test]
fn effects_are_those_that_files_call_for() {
    let mut called = whit::Effects::NONE;
    for (name, text) in FILES {
        let mut scene = other::<640, 16>();
        read(text, &mut scene).unwrap();
        let effects = scene.as_scene().effects();
        assert!(effects.without(EFFECTS).is_empty(), "{name}: {effects}");
        called = called.with(effects);
    }
    assert_eq!(EFFECTS.without(called), whit::Effects::NONE);
}

/// A scene that no file of these tests describes.
fn other<const OBJECTS: usize, const LIGHTS: usize>() -> SceneBuf<f32, OBJECTS, LIGHTS> {
    let camera = Camera::look_at(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO, Vec3::new(0.0, 0.0, 1.0), 17.0);
    let mut scene = SceneBuf::new(camera, Background::Solid(Rgb::grey(0.25)));
    scene.medium = Medium::new(1.25);
    scene.tone = Tone::Display { gain: 3.0, lift: 0.5 };
    scene.add_object(Object::new(Shape::sphere(Vec3::ZERO, 7.0), Material::dielectric(1.5))).unwrap();
    scene.add_light(Light::point(Vec3::ZERO, Rgb::grey(7.0))).unwrap();
    scene
}

/// Reads; checks what holds for every outcome.
fn try_read<const OBJECTS: usize, const LIGHTS: usize>(
    text: &str,
    scene: &mut SceneBuf<f32, OBJECTS, LIGHTS>,
) -> Result<Summary, NffError> {
    let before = scene.clone();
    let result = read(text, scene);
    match &result {
        Ok(summary) => {
            scene.as_scene().validate().expect("what is read is valid");
            assert_eq!(
                (summary.objects, summary.lights),
                (scene.as_scene().objects.len(), scene.as_scene().lights.len())
            );
        }
        Err(error) => {
            assert_eq!(scene.as_scene(), before.as_scene(), "an error leaves the scene as it was");
            assert!((1..=text.lines().count().max(1)).contains(&error.line), "{error}");
        }
    }
    result
}

fn read_big(text: &str) -> (Summary, Big) {
    let mut scene: Big = other();
    let summary = try_read(text, &mut scene).unwrap_or_else(|error| panic!("{error}"));
    (summary, scene)
}

/// A small deterministic generator (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % n
    }

    fn unit(&mut self) -> f32 {
        self.below(1 << 24) as f32 / (1 << 24) as f32
    }
}

fn count(scene: &Big, fits: impl Fn(&Shape<'_, f32>) -> bool) -> usize {
    scene.as_scene().objects.iter().filter(|object| fits(&object.shape)).count()
}

/// A scan that knows nothing of the format but the first words and the number after `p` and `pp`. At the mouth of
/// its spout the teapot has four patches without area: three vertices on a line.
#[test]
fn files_have_the_objects_that_a_naive_scan_finds() {
    for (name, text) in FILES {
        let first_words = || text.lines().filter_map(|line| line.split_whitespace().next());
        let number_of = |word: &str| first_words().filter(|first| *first == word).count();
        let triangles_of = |prefix: &str| -> usize {
            text.lines().filter_map(|line| line.strip_prefix(prefix)).map(|n| n.parse::<usize>().unwrap() - 2).sum()
        };
        let flat = if name == "teapot_s1" { 4 } else { 0 };
        let (summary, scene) = read_big(text);
        assert_eq!(count(&scene, |shape| matches!(shape, Shape::Sphere(_))), number_of("s"), "{name}");
        assert_eq!(count(&scene, |shape| matches!(shape, Shape::Cone(_))), number_of("c"), "{name}");
        assert_eq!(count(&scene, |shape| matches!(shape, Shape::Triangle(_))), triangles_of("p "), "{name}");
        assert_eq!(
            count(&scene, |shape| matches!(shape, Shape::SmoothTriangle(_))),
            triangles_of("pp ") - flat,
            "{name}"
        );
        assert_eq!(summary.lights, number_of("l"), "{name}");
    }
}

#[test]
fn every_entity_becomes_what_the_documentation_says() {
    let (summary, scene) = read_big(EVERY_ENTITY);
    let scene = scene.as_scene();
    assert_eq!((summary.size.width, summary.size.height), (7, 5));
    let (from, up) = (Vec3::new(0.0, -5.0, 1.0), Vec3::new(0.0, 0.0, 2.0));
    let camera = Camera::with_half_height(from, Vec3::ZERO, up, 1.0);
    assert_eq!(scene.camera, Camera { extent: Extent::PixelCentres, ..camera });
    assert_eq!(scene.background, Background::Solid(Rgb::new(0.1, 0.2, 0.3)));
    assert_eq!((scene.medium, scene.tone), (Medium::VACUUM, Tone::Linear));

    let grey = Rgb::grey(1.0 / 3.0_f32.sqrt());
    let colors = [grey, Rgb::new(1.0, 0.5, 0.0), grey];
    let places = [Vec3::new(4.0, -3.0, 5.0), Vec3::new(-4.0, -3.0, 5.0), Vec3::new(0.0, 0.0, 9.0)];
    assert_eq!(scene.lights, [0, 1, 2].map(|i| Light::point(places[i], colors[i])));

    let body = |color, diffuse| Some(Body { color: Pattern::Solid(color), emission: 0.0, ambient: 0.0, diffuse });
    let highlight = |exponent| Some(Highlight { color: Rgb::grey(0.25), lobe: Lobe::Blinn, exponent });
    let [floor_1, floor_2, ball, cone, cylinder, patch] = scene.objects else { panic!("{:?}", scene.objects) };
    let floor = Material {
        body: body(Rgb::new(0.8, 0.6, 0.4), 0.5),
        highlight: None,
        interface: Interface::Opaque,
        balance: None,
    };
    for object in [floor_1, floor_2] {
        assert_eq!((object.material, object.sides, object.shadow), (floor, Sides::Outside, Shadow::Full));
    }
    let interface =
        Interface::Constant { reflected: Rgb::grey(0.25), transmitted: Rgb::grey(0.75), medium: Medium::new(1.5) };
    let glass = Material { body: None, highlight: highlight(Exponent::Integer(12)), interface, balance: None };
    assert_eq!(*ball, Object::new(Shape::sphere(Vec3::new(0.0, 0.0, 1.0), -0.5), glass));
    let interface = Interface::Mirror { reflected: Rgb::grey(0.25) };
    let shiny =
        Material { body: body(Rgb::WHITE, 0.5), highlight: highlight(Exponent::Real(3.5)), interface, balance: None };
    let top = Vec3::new(0.0, 0.0, 2.0);
    assert_eq!(*cone, Object::new(Shape::cone(Vec3::ZERO, 1.0, top, 0.0), shiny).one_sided());
    assert_eq!(*cylinder, Object::new(Shape::cylinder(Vec3::ZERO, top, -1.0), shiny).one_sided());

    let Shape::SmoothTriangle(SmoothTriangle { vertices, normals }) = patch.shape else { panic!("{patch:?}") };
    assert_eq!(cyclic(vertices), cyclic([Vec3::ZERO, Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)]));
    for (vertex, normal) in vertices.into_iter().zip(normals) {
        assert_eq!(normal, vertex + Vec3::new(0.0, 0.0, 1.0));
    }
}

#[test]
fn line_ends_comments_and_blanks_change_nothing() {
    let (summary, scene) = read_big(EVERY_ENTITY);
    let noisy = EVERY_ENTITY.replace('\n', " # s 1 2\r\n\r\n\t \r\n").replace(' ', " \t ");
    for text in [EVERY_ENTITY.replace('\n', "\r\n"), noisy, EVERY_ENTITY.trim_end().to_string()] {
        let (same_summary, same_scene) = read_big(&text);
        assert_eq!((same_summary, same_scene.as_scene()), (summary, scene.as_scene()));
    }
    let mut from_bytes: Big = other();
    read_bytes(EVERY_ENTITY.as_bytes(), &mut from_bytes).unwrap();
    assert_eq!(from_bytes.as_scene(), scene.as_scene());
}

#[test]
fn what_is_not_said_is_black_and_empty() {
    let (summary, scene) = read_big(HEAD);
    assert_eq!((summary.objects, summary.lights), (0, 0));
    assert_eq!(scene.as_scene().background, Background::Solid(Rgb::BLACK));
}

#[test]
fn shine_is_an_integer_exponent_where_it_can_be() {
    for (shine, exponent) in [
        ("0", Exponent::Integer(0)),
        ("1e6", Exponent::Integer(1_000_000)),
        ("1000001", Exponent::Real(1_000_001.0)),
        ("0.5", Exponent::Real(0.5)),
    ] {
        let (_, scene) = read_big(&format!("{HEAD}f 1 1 1 1 1 {shine} 0 0\ns 0 0 0 1\n"));
        assert_eq!(scene.as_scene().objects[0].material.highlight.unwrap().exponent, exponent);
    }
}
