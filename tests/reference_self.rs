//! The reference tracer against closed forms and against POV-Ray.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod povray_scene;
mod reference;

use reference::compare::{Difference, share_over};
use reference::optics::branches;
use reference::shapes::Ray;
use reference::vector::Vector;
use reference::world::World;
use reference::{Branch, Counts, Samples, Settings, Termination, render};
use whit::scene::{
    Aperture, Background, Camera, Emitter, Extent, Falloff, Fresnel, Interface, Lens, Light, Material, Medium, Object,
    Pattern, Scene, Shape, Tone,
};
use whit::{Rgb, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const BLUE: Background<f32> = Background::Solid(Rgb::new(0.2, 0.3, 0.5));
const DAYLIGHT: Background<f32> =
    Background::Gradient { below: Rgb::new(0.3, 0.2, 0.1), above: Rgb::new(0.5, 0.7, 1.0), up: UP };

/// From (0, 0, 5) to the origin, with a field of view of 40°.
fn camera() -> Camera<f32> {
    Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0)
}

fn scene<'a>(background: Background<f32>, objects: &'a [Object<'a, f32>], lights: &'a [Light<f32>]) -> Scene<'a, f32> {
    Scene::new(camera(), background).with_objects(objects).with_lights(lights)
}

/// The light along a ray, and the rays it took.
fn trace(scene: &Scene<'_, f32>, settings: &Settings, ray: &Ray) -> ([f64; 3], Counts) {
    let mut counts = Counts::default();
    let world = &World::new(scene);
    (Branch::eye(world, settings, &|_| [0.5, 0.5]).trace(ray, &mut counts).0, counts)
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?} within {tolerance:e}");
}

fn v(x: f64, y: f64, z: f64) -> Vector {
    Vector::new(x, y, z)
}

#[test]
fn povray_a_direct() {
    let povray = povray_scene::a_direct_picture();
    let settings = Settings::new(povray.width, povray.height, 0);
    let (picture, counts) = render(&povray_scene::A_DIRECT, &settings, &Samples::CENTRE);
    println!("{}; {counts:?}", Difference::between(&povray.pixels, &picture));
    assert!(share_over(2e-5, &povray.pixels, &picture) <= 0.001);
    assert!(Difference::between(&povray.pixels, &picture).max <= 2e-5);
}

#[test]
fn a_slab_displaces_a_ray_by_the_textbook_amount() {
    let (thickness, index) = (1.5, 1.5);
    let glass = [Object::new(
        Shape::axis_box(Vec3::new(-50.0, -1.5, -50.0), Vec3::new(50.0, 0.0, 50.0)),
        Material::dielectric(1.5),
    )];
    let scene = scene(BLUE, &glass, &[]);
    let world = World::new(&scene);
    for degrees in [0.0_f64, 10.0, 45.0, 80.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let enter = Ray::new(v(-3.0 * sine, 3.0 * cosine, 0.0), v(sine, -cosine, 0.0));
        let follow = |ray: &Ray| {
            let hit = world.nearest(ray).unwrap();
            let border = world.border(ray, &hit).unwrap();
            let branches = branches(&hit, ray.direction, &border, Fresnel::Exact, None);
            hit.leave(branches.transmitted[0].direction)
        };
        let inside = follow(&enter);
        let exit = follow(&inside);
        assert!((exit.direction - enter.direction).length() < 1e-14);
        assert!((exit.origin.y + thickness).abs() < 1e-14);
        let refracted = (sine / index).asin();
        let displacement = thickness * (degrees.to_radians() - refracted).sin() / refracted.cos();
        let measured = (exit.origin - enter.origin).cross(enter.direction).length();
        assert!((measured - displacement).abs() < 1e-14, "{measured} {displacement}");
        assert!(world.nearest(&exit).is_none());
    }
}

#[test]
fn lossless_glass_in_a_uniform_background_is_invisible() {
    let shapes = [
        Shape::sphere(Vec3::ZERO, 1.0),
        Shape::sphere(Vec3::ZERO, -1.0),
        Shape::axis_box(Vec3::splat(-0.7), Vec3::new(0.7, 0.9, 0.8)),
        Shape::cone(Vec3::new(-0.7, -0.5, 0.0), 0.8, Vec3::new(0.9, 0.7, 0.3), 0.2).capped(),
    ];
    let constant =
        Interface::Constant { reflected: Rgb::grey(0.25), transmitted: Rgb::grey(0.75), medium: Medium::new(1.5) };
    for shape in shapes {
        for interface in [Material::dielectric(1.5).interface, Material::dielectric(0.7).interface, constant] {
            let glass = [Object::new(shape, Material::dielectric(1.0).with_interface(interface))];
            let scene = scene(Background::Solid(Rgb::WHITE), &glass, &[]);
            for depth in 0..=7 {
                let (picture, counts) = render(&scene, &Settings::new(24, 24, depth), &Samples::CENTRE);
                let difference = Difference::between(&picture, &[[1.0; 3]; 24 * 24]);
                assert!(difference.max < 1e-9, "{shape:?} {interface:?} depth {depth}: {difference}");
                assert_eq!(counts.reflected > 0, depth > 0);
            }
        }
    }
}

#[test]
fn total_internal_reflection_takes_both_shares() {
    let (reflected, transmitted) = (Rgb::new(0.125, 0.25, 0.5), Rgb::new(0.25, 0.5, 0.125));
    let interface = Interface::Constant { reflected, transmitted, medium: Medium::new(1.5) };
    let water = [Object::new(Shape::plane(Vec3::ZERO, UP), Material { interface, ..Material::dielectric(1.0) })];
    let scene = scene(DAYLIGHT, &water, &[]);
    let critical = (1.0_f64 / 1.5).asin();
    for (angle, total) in [(critical - 1e-6, false), (critical + 1e-6, true)] {
        let ray = Ray::new(v(0.0, -1.0, 0.0), v(angle.sin(), angle.cos(), 0.0));
        let (light, counts) = trace(&scene, &Settings::new(1, 1, 1), &ray);
        assert_eq!((counts.total_internal, counts.transmitted), if total { (1, 0) } else { (0, 1) });
        if total {
            let t = 0.5 * (1.0 - angle.cos());
            let below = [0.3_f32, 0.2, 0.1].map(f64::from);
            let above = [0.5_f32, 0.7, 1.0].map(f64::from);
            let expected = [0, 1, 2].map(|i| [0.375, 0.75, 0.625][i] * (below[i] * (1.0 - t) + above[i] * t));
            close(light, expected, 1e-12);
        }
    }
}

#[test]
fn depth_and_cutoff_end_the_path_between_two_mirrors() {
    let mirror = Material::mirror(Rgb::new(0.5, 0.25, 0.5));
    let mirrors = [
        Object::new(Shape::disc(Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 0.0, 3.0), 1.0), mirror),
        Object::new(Shape::disc(Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, 0.2), 1.0), mirror),
    ];
    let scene = scene(BLUE, &mirrors, &[]);
    let ray = Ray::new(v(0.0, 0.0, 0.0), v(0.0, 0.0, -1.0));
    for depth in 0..6 {
        let settings = Settings { termination: Termination::Color([1.0, 2.0, 0.0]), ..Settings::new(1, 1, depth) };
        let (light, counts) = trace(&scene, &settings, &ray);
        let bounces = depth as i32 + 1;
        close(light, [0.5_f64.powi(bounces), 2.0 * 0.25_f64.powi(bounces), 0.0], 0.0);
        assert_eq!(counts.reflected, u64::from(depth));
    }
    // The red throughputs 0.5, 0.25 and 0.125 are traced, 0.0625 is not.
    let settings = Settings { cutoff: 0.1, termination: Termination::Color([1.0; 3]), ..Settings::new(1, 1, 64) };
    let (light, counts) = trace(&scene, &settings, &ray);
    close(light, [0.0625, 0.00390625, 0.0625], 0.0);
    assert_eq!(counts.reflected, 3);
}

#[test]
fn a_small_sphere_far_away_is_lit_by_lamberts_law() {
    let (center, radius) = (Vec3::new(0.0, 0.0, -1000.0), 1e-3);
    let objects = [
        Object::new(Shape::sphere(center, radius), Material::matte(Rgb::WHITE)),
        Object::new(Shape::sphere(Vec3::new(0.0, -1e6, 0.0), 999_999.0), Material::matte(Rgb::WHITE)),
    ];
    let lights = [Light::directional(Vec3::new(0.0, 3.0, 4.0), Rgb::WHITE)];
    let scene = scene(BLUE, &objects, &lights);
    for i in -9..=9 {
        let y = f64::from(i) / 10.0 * f64::from(radius);
        let ray = Ray::new(v(0.0, y, 5.0), v(0.0, 0.0, -1.0));
        let (sine, cosine) = (y / f64::from(radius), (1.0 - (y / f64::from(radius)).powi(2)).sqrt());
        let lambert = (0.6 * sine + 0.8 * cosine).max(0.0);
        close(trace(&scene, &Settings::new(1, 1, 0), &ray).0, [lambert; 3], 1e-8);
    }
}

#[test]
fn the_penumbra_of_an_area_light_is_the_share_that_is_seen() {
    // The square light of side 2 at height 2 is hidden, from the origin, where x > 0.4.
    let white = Material::matte(Rgb::WHITE).with_shares(0.0, 1.0, 0.0);
    let objects = [
        Object::new(Shape::plane(Vec3::ZERO, UP), white),
        Object::new(Shape::axis_box(Vec3::new(0.2, 0.875, -9.0), Vec3::new(9.0, 1.0, 9.0)), white),
    ];
    let emitter = Emitter::Parallelogram {
        corner: Vec3::new(-1.0, 2.0, -1.0),
        edge_u: Vec3::new(2.0, 0.0, 0.0),
        edge_v: Vec3::new(0.0, 0.0, 2.0),
    };
    let falloff = Falloff { constant: 2.0, linear: 0.0, quadratic: 0.0 };
    let lights = [Light { emitter, color: Rgb::WHITE, falloff: Some(falloff) }];
    let camera = Camera { half_height: 1e-6, ..Camera::look_at(Vec3::new(0.0, 1.0, 5.0), Vec3::ZERO, UP, 1.0) };
    let scene = Scene { camera, ..scene(BLUE, &objects, &lights) };
    let numbers = |_, _, sample: u32, dimension| match dimension {
        2 => [(f64::from(sample % 100) + 0.5) / 100.0, (f64::from(sample / 100) + 0.5) / 10.0],
        _ => [0.5, 0.5],
    };
    let samples = Samples { count: 1000, numbers: &numbers };
    let (picture, counts) = render(&scene, &Settings::new(1, 1, 0), &samples);
    close(picture[0], [0.35; 3], 1e-12);
    assert_eq!((counts.eye, counts.shadow), (1000, 1000));
}

#[test]
fn a_lens_is_sharp_in_its_plane_of_focus() {
    let checker = Pattern::Checker {
        even: Rgb::WHITE,
        odd: Rgb::BLACK,
        u: Vec3::new(2.0, 0.0, 0.0),
        v: Vec3::new(0.0, 2.0, 0.0),
    };
    let wall = |z| {
        let material = Material::patterned(checker).with_shares(1.0, 0.0, 0.0);
        [Object::new(Shape::plane(Vec3::new(0.0, 0.0, z), Vec3::new(0.0, 0.0, 1.0)), material)]
    };
    let numbers = |x: u32, _, sample: u32, dimension| match dimension {
        1 => [f64::from(sample % 4) / 4.0, f64::from((sample + x) / 4 % 4) / 4.0],
        _ => [0.5, 0.5],
    };
    let samples = Samples { count: 16, numbers: &numbers };
    for aperture in [Aperture::Disc { radius: 0.5 }, Aperture::Square { side: 0.5 }] {
        let camera = camera().with_lens(Lens { aperture, focus: 5.0 });
        let settings = Settings::new(30, 20, 0);
        let picture = |objects: &[Object<'_, f32>], camera| {
            render(&Scene::new(camera, BLUE).with_objects(objects), &settings, &samples).0
        };
        let pinhole = Camera { lens: None, ..camera };
        assert_eq!(picture(&wall(0.0), camera), picture(&wall(0.0), pinhole));
        assert_ne!(picture(&wall(-2.0), camera), picture(&wall(-2.0), pinhole));
    }
}

#[test]
fn the_picture_is_spanned_by_edges_or_centres() {
    let lifted = Tone::Display { gain: 2.0, lift: -0.5 };
    let sky = Background::Gradient { below: Rgb::BLACK, above: Rgb::WHITE, up: UP };
    for (extent, expected) in [(Extent::PixelEdges, 2.0_f64 / 3.0), (Extent::PixelCentres, 1.0)] {
        let camera = Camera { half_height: 1.0, extent, ..camera() };
        let scene = Scene { camera, tone: lifted, ..scene(sky, &[], &[]) };
        let (picture, _) = render(&scene, &Settings::new(1, 3, 0), &Samples::CENTRE);
        let y = expected / (1.0 + expected * expected).sqrt();
        close(picture[0], [2.0 * 0.5 * (1.0 + y) - 0.5; 3], 1e-15);
        close(picture[1], [0.5; 3], 1e-15);
    }
}
