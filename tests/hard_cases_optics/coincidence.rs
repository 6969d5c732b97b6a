//! Surfaces that coincide or touch. What is seen is the same for every ray, whatever its rounding, and however the picture
//! is cut.

use whit::render::{LinearRgb, Progress, Size};
use whit::scene::{PackedSpheres, Sphere, Triangle};
use whit::{Background, Budget, Camera, Frame, Light, Material, Object, Ray, Rgb, Scene, Settings, Shape, Vec3};

use crate::support::{Alone, Nested, Random, UP, plus, shoot, single, unit};

const SIDE: u32 = 48;

const fn v(x: f32, y: f32, z: f32) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

/// A look at the origin, with a light.
fn view<'a>(objects: &'a [Object<'a, f32>], lights: &'a [Light<f32>]) -> Scene<'a, f32> {
    let sky = Background::Gradient { below: Rgb::new(0.6, 0.4, 0.2), above: Rgb::new(0.1, 0.3, 0.9), up: UP };
    let camera = Camera::look_at(v(0.37, 1.9, 3.1), Vec3::ZERO, UP, 40.0);
    Scene::new(camera, sky).with_objects(objects).with_lights(lights)
}

const LIGHTS: [Light<f32>; 2] =
    [Light::point(Vec3::new(2.0, 3.0, 1.0), Rgb::WHITE), Light::point(Vec3::new(-2.0, 2.5, 2.0), Rgb::grey(0.5))];

/// The picture in one go, or cut into rows and steps of so many rays.
fn picture(scene: &Scene<'_, f32>, cut: Option<u32>) -> Vec<Rgb<f32>> {
    let tracer = Nested::try_new(scene).unwrap();
    let mut pixels = vec![Rgb::BLACK; (SIDE * SIDE) as usize];
    let mut target = LinearRgb::new(Size::new(SIDE, SIDE), &mut pixels).unwrap();
    let settings = Settings { budget: Budget::with_depth(4), ..Settings::new(SIDE, SIDE) };
    match cut {
        None => Frame::new(&tracer, settings).unwrap().render(&mut target).unwrap(),
        Some(rays) => {
            for row in (0..SIDE).rev() {
                let mut frame = Frame::new(&tracer, Settings { rows: row..row + 1, ..settings.clone() }).unwrap();
                while frame.step(rays, &mut target).unwrap() == Progress::More {}
            }
        }
    }
    pixels
}

fn shapes() -> Vec<Shape<'static, f32>> {
    const BALLS: PackedSpheres<f32, 1, 1> = PackedSpheres::new(&[Sphere { center: v(0.1, 0.2, 0.3), radius: 0.7 }]);
    const MESH: [Triangle<f32>; 1] = [Triangle { vertices: [v(-1.0, 0.1, 1.0), v(1.2, 0.1, 0.9), v(0.1, 0.9, -1.1)] }];
    static LIST: PackedSpheres<f32, 1, 1> = BALLS;
    static TRIANGLES: [Triangle<f32>; 1] = MESH;
    vec![
        Shape::sphere(v(0.1, 0.2, 0.3), 0.7),
        Shape::Spheres(LIST.view()),
        Shape::plane(v(0.1, -0.2, 0.3), v(0.3, 0.9, 0.1)),
        Shape::disc(v(0.1, 0.2, 0.3), v(0.3, 0.9, 0.1), 0.8),
        Shape::axis_box(v(-0.5, -0.6, -0.7), v(0.6, 0.3, 0.4)),
        Shape::Triangle(MESH[0]),
        Shape::Triangles(&TRIANGLES),
        Shape::cone(v(0.1, -0.5, 0.2), 0.5, v(0.3, 0.5, 0.1), 0.3).capped(),
    ]
}

fn materials() -> [Material<f32>; 4] {
    let red = Material::matte(Rgb::new(0.9, 0.2, 0.1)).with_shares(0.1, 0.1, 0.8);
    [red, Material::mirror(Rgb::new(0.3, 0.9, 0.5)), Material::dielectric(1.5), red.with_coat(1.7)]
}

/// The first of two equal surfaces is seen, in every pixel: the other one changes no bit, in reflections, refraction and
/// shadows neither.
#[test]
fn of_equal_surfaces_the_first_is_seen() {
    for shape in shapes() {
        for first in materials() {
            for second in materials().into_iter().filter(|second| *second != first) {
                let floor = Object::new(Shape::plane(v(0.0, -1.0, 0.0), UP), materials()[0]);
                let both = [floor, Object::new(shape, first), Object::new(shape, second)];
                let pictures = [&both[..], &both[..2]].map(|objects| picture(&view(objects, &LIGHTS), None));
                assert!(pictures[0] == pictures[1], "{shape:?}: {first:?} before {second:?}");
            }
        }
    }
}

/// A list of one ball is the same surface as that ball, and a plane that looks the other way the same as the plane.
#[test]
fn equal_surfaces_may_be_described_in_two_ways() {
    let all = shapes();
    let pairs = [
        [all[0], all[1]],
        [all[0], Shape::sphere(v(0.1, 0.2, 0.3), -0.7)],
        [all[2], Shape::plane(v(0.1, -0.2, 0.3), v(-0.3, -0.9, -0.1))],
        [all[5], all[6]],
    ];
    let [red, mirror, ..] = materials();
    for [a, b] in pairs.into_iter().chain(pairs.map(|[a, b]| [b, a])) {
        let both = [Object::new(a, red), Object::new(b, mirror)];
        let pictures = [&both[..], &both[..1]].map(|objects| picture(&view(objects, &LIGHTS), None));
        assert!(pictures[0] == pictures[1], "{a:?} before {b:?}");
    }
}

/// Balls that are the same, touch, and share a place with a light.
#[test]
fn pictures_have_the_same_bits_however_they_are_cut() {
    let [red, mirror, glass, coat] = materials();
    let block = Shape::axis_box(v(-1.0, -0.5, -1.0), v(0.2, 0.1, 0.5));
    let objects = [
        Object::new(shapes()[0], glass.with_priority(1)),
        Object::new(shapes()[0], glass.with_priority(2)),
        Object::new(Shape::sphere(v(0.1, 0.2, 1.3), 0.3), mirror),
        Object::new(Shape::sphere(v(0.1, 0.2, -0.1), 0.3), red),
        Object::new(block, coat),
        Object::new(block, red),
        Object::new(Shape::plane(v(0.0, 0.1, 0.0), UP), red),
    ];
    let lights = [Light::point(v(0.1, 0.9, 0.3), Rgb::WHITE), Light::point(v(1.0, 0.1, 1.0), Rgb::WHITE)];
    let scene = view(&objects, &lights);
    let whole = picture(&scene, None);
    for rays in [1, 7, 1000] {
        assert!(picture(&scene, Some(rays)) == whole, "in steps of {rays} rays");
    }
}

/// Blocks that share a face, seen along their seam: none of the light from behind comes through, and at the seam itself
/// it is the first block that is seen.
#[test]
fn there_is_no_gap_between_blocks() {
    let mut random = Random::new(80);
    for seam in [0.0, 0.3, 1.0 / 3.0, 1e-3, 100.1] {
        let blocks = [(seam - 1.0, seam), (seam, seam + 1.0)];
        let objects = blocks.map(|(from, to)| {
            Object::new(Shape::axis_box(v(from, -1.0, -1.0), v(to, 1.0, 1.0)), Material::matte(Rgb::WHITE))
        });
        let scene = view(&objects, &[]);
        let tracer = Alone::try_new(&scene).unwrap();
        for _ in 0..50_000 {
            let origin =
                plus([seam.into(), 0.0, 0.0], 1.0, [random.between(-2.0, 2.0), random.between(-0.5, 0.5), 3.0]);
            let target = [f64::from(seam), random.between(-0.9, 0.9), random.between(-0.9, 1.0)];
            let ray = Ray { origin: single(origin), direction: single(unit(plus(target, -1.0, origin))) };
            let hit = tracer.intersect(&ray).expect("a block");
            assert!(hit.from_outside, "through the seam: {ray:?}");
        }
        let straight = Ray { origin: v(seam, 0.2, 3.0), direction: v(0.0, 0.0, -1.0) };
        assert_eq!(tracer.intersect(&straight).map(|hit| hit.object), Some(0));
    }
}

/// Where mirror balls touch, from outside or from inside, pixels are numbers.
#[test]
fn touching_balls_are_met() {
    let mut random = Random::new(81);
    for (place, radius) in [(1.5, 0.5), (0.5, 0.5), (1.0 + 1.0 / 3.0, 1.0 / 3.0), (0.9, 0.1)] {
        let balls = [(Vec3::ZERO, 1.0), (UP * place, radius)];
        let objects = balls.map(|(center, radius)| {
            Object::new(Shape::sphere(center, radius), Material::mirror(Rgb::WHITE).with_highlight(Rgb::WHITE, 9))
        });
        let scene = view(&objects, &LIGHTS);
        let tracer = Alone::try_new(&scene).unwrap();
        for _ in 0..20_000 {
            let origin = plus([0.0; 3], 3.0, random.direction());
            let target = plus([0.0, 1.0, 0.0], 10_f64.powf(random.between(-9.0, -1.0)), random.direction());
            let ray = Ray { origin: single(origin), direction: single(unit(plus(target, -1.0, origin))) };
            let (light, _) = shoot(&tracer, ray, 30);
            assert!(
                (0.0..=10.0).contains(&light.r) && light.g.is_finite() && light.b.is_finite(),
                "{ray:?}: {light:?}"
            );
            // What lies inside is never seen.
            let hit = tracer.intersect(&ray);
            assert!(hit.is_none_or(|hit| hit.object == 0 || place > 1.0 || hit.distance > 1.9), "{ray:?}: {hit:?}");
        }
    }
}
