//! What the reference tracer does at a surface, against closed forms.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod reference;

use std::f64::consts::FRAC_PI_8;
use std::sync::Mutex;

use reference::camera::concentric;
use reference::light::{arriving, background, frame};
use reference::optics::{Branches, Transmitted, branches};
use reference::shade::{local, pattern};
use reference::shapes::Ray;
use reference::vector::{Color, Vector};
use reference::world::World;
use reference::{Counts, Samples, Settings, trace_pixel};
use whit::scene::{
    Background, Camera, Fresnel, Interface, Light, Material, Medium, Object, Pattern, Scene, Shape, SmoothTriangle,
};
use whit::{Rgb, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
const BLACK: Background<f32> = Background::Solid(Rgb::new(0.0, 0.0, 0.0));

fn v(x: f64, y: f64, z: f64) -> Vector {
    Vector::new(x, y, z)
}

/// The branches where a ray from above (or from below, for a negative height) meets the plane y = 0.
fn on_plane(material: Material<f32>, surroundings: f32, angle: f64, height: f64) -> Branches {
    let plane = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
    let scene = Scene::new(CAMERA, BLACK).with_objects(&plane).with_medium(Medium::new(surroundings));
    let world = World::new(&scene);
    let ray = Ray::new(v(0.0, height, 0.0), v(angle.sin(), -angle.cos() * height.signum(), 0.0));
    let hit = world.nearest(&ray).unwrap();
    branches(&hit, ray.direction, &world.border(&ray, &hit).unwrap(), Fresnel::Schlick, None)
}

#[test]
fn schlick_takes_the_same_share_both_ways() {
    for (surroundings, index) in [(1.0, 1.5), (1.25, 1.0)] {
        for angle in [0.0, 0.3, 0.9] {
            let glass = Material::dielectric(index);
            let from_rare = if surroundings < index { 1.0 } else { -1.0 };
            let enter = on_plane(glass, surroundings, angle, from_rare);
            let Transmitted { weight: share, direction: refracted, .. } = enter.transmitted[0];
            let inside = refracted.x.asin();
            let (n1, n2) = (f64::from(surroundings.min(index)), f64::from(surroundings.max(index)));
            assert!((n1 * angle.sin() - n2 * inside.sin()).abs() < 1e-15);
            let r0 = ((n1 - n2) / (n1 + n2)).powi(2);
            let expected = r0 + (1.0 - r0) * (1.0 - angle.cos()).powi(5);
            assert!((enter.reflected.unwrap().0.0[0] - expected).abs() < 1e-15);
            assert!((share.0[1] - (1.0 - expected)).abs() < 1e-15);
            let leave = on_plane(glass, surroundings, inside, -from_rare);
            assert!((leave.reflected.unwrap().0.0[2] - expected).abs() < 1e-14);
            assert!((leave.transmitted[0].direction.x - angle.sin()).abs() < 1e-14);
        }
    }
}

#[test]
fn a_metal_reflects_more_at_a_grazing_angle() {
    let metal = Material::metal(Rgb::new(0.5, 0.25, 1.0));
    let (weight, direction) = on_plane(metal, 1.0, 60_f64.to_radians(), 1.0).reflected.unwrap();
    let expected = [0.5 + 0.5 / 32.0, 0.25 + 0.75 / 32.0, 1.0];
    assert!(weight.0.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14));
    assert!((direction - v(0.75_f64.sqrt(), 0.5, 0.0)).length() < 1e-14);
}

#[test]
fn branches_keep_to_their_side_of_a_smooth_triangle() {
    let vertices = [Vec3::new(-1.0, 0.0, 1.0), Vec3::new(1.0, 0.0, 1.0), Vec3::new(0.0, 0.0, -1.0)];
    // Leaning so far that a flat ray is reflected into the surface, and a steep one refracted out of it.
    let normals = [Vec3::new(9.0, 1.0, 0.0); 3];
    let shape = Shape::SmoothTriangle(SmoothTriangle { vertices, normals });
    for index in [1.5, 0.7] {
        let objects = [Object::new(shape, Material::dielectric(index))];
        let scene = Scene::new(CAMERA, BLACK).with_objects(&objects);
        let world = World::new(&scene);
        for height in [1.0, -1.0] {
            for degrees in -89..90 {
                let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
                let ray = Ray::new(v(-sine, cosine * height, 0.0), v(sine, -cosine * height, 0.0));
                let hit = world.nearest(&ray).unwrap();
                assert_eq!(hit.geometric, v(0.0, height, 0.0));
                assert!(hit.normal.dot(hit.geometric) > 0.0);
                let border = world.border(&ray, &hit).unwrap();
                let branches = branches(&hit, ray.direction, &border, Fresnel::Exact, None);
                assert!(branches.reflected.unwrap().1.dot(hit.geometric) > 0.0);
                assert!(branches.transmitted.iter().all(|branch| branch.direction.dot(hit.geometric) < 0.0));
                assert_eq!(branches.total_internal, branches.transmitted.is_empty());
            }
        }
    }
}

#[test]
fn one_sided_and_shadowless_objects_let_rays_pass() {
    let white = Material::matte(Rgb::WHITE);
    let floor = Object::new(Shape::plane(Vec3::ZERO, UP), white);
    let ball = Object::new(Shape::sphere(Vec3::new(0.0, 2.0, 0.0), 1.0), white);
    let turned = Object::new(Shape::sphere(Vec3::new(0.0, 2.0, 0.0), -1.0), white);
    let glass = Object { material: Material::dielectric(1.5), ..ball };
    let lights = [Light::point(Vec3::new(0.0, 8.0, 0.0), Rgb::WHITE)];
    let inside = [Light::point(Vec3::new(0.0, 2.0, 0.0), Rgb::WHITE)];
    let beyond = [Light::point(Vec3::new(0.0, 0.5, 0.0), Rgb::WHITE), Light::directional(UP, Rgb::WHITE)];
    let below = [Light::point(Vec3::new(0.0, -1.0, 0.0), Rgb::WHITE)];
    let cases = [
        (ball, &lights[..], 0.0, 1),
        (glass, &lights, 0.0, 1),
        (ball.without_shadow(), &lights, 1.0, 1),
        (ball.one_sided(), &lights, 0.0, 1),
        (ball.one_sided(), &inside, 0.0, 1),
        (turned.one_sided(), &inside, 1.0, 1),
        (turned, &inside, 0.0, 1),
        (ball, &beyond, 1.0, 2),
        (ball, &below, 0.0, 0),
    ];
    for (object, lights, expected, shadow) in cases {
        let objects = [floor, object];
        let scene = Scene::new(CAMERA, BLACK).with_objects(&objects).with_lights(lights);
        let world = World::new(&scene);
        let ray = Ray::new(v(2.0, 2.0, 0.0), v(-1.0, -1.0, 0.0));
        let hit = world.nearest(&ray).unwrap();
        let mut counts = Counts::default();
        let light = local(&world, &hit, ray.direction, Color::WHITE, 0, &|_| [0.5, 0.5], &mut counts);
        assert!((light.max_channel() - expected).abs() < 1e-12, "{object:?} {lights:?} {light:?}");
        assert_eq!(counts, Counts { shadow, ..Counts::default() });
        // From within, the one-sided ball is not there.
        let seen = world.nearest(&Ray::new(v(0.0, 2.0, 0.0), v(1.0, 0.25, 0.0)));
        assert_eq!(seen.is_some(), object != ball.one_sided());
    }
}

#[test]
fn the_points_of_a_spherical_light_are_the_disc_that_is_seen() {
    let center = v(3.0, -1.0, 2.0);
    let light = Light::sphere(Vec3::new(3.0, -1.0, 2.0), 0.5, Rgb::WHITE);
    for point in [v(0.0, 0.0, 0.0), v(3.0, -1.0, 9.0), v(3.0, -1.0, -9.0), v(4.0, 5.0, 6.0)] {
        let w = (center - point).normalized();
        let (t, b) = frame(w);
        assert!((t.cross(b) - w).length() < 1e-14 && (t.length() - 1.0).abs() < 1e-14);
        assert!(t.dot(b).abs() < 1e-14 && t.dot(w).abs() < 1e-14);
        for (numbers, radius) in [([0.5, 0.5], 0.0), ([1.0, 0.5], 0.5), ([0.5, 0.25], 0.25), ([0.0, 0.0], 0.5)] {
            let arriving = arriving(&light, point, 2, &|_| numbers).unwrap();
            let offset = point + arriving.direction * arriving.distance - center;
            assert!((offset.length() - radius).abs() < 1e-14 && offset.dot(w).abs() < 1e-14);
        }
    }
}

#[test]
fn patterns_and_skies_have_their_closed_forms() {
    let (u, v_axis) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
    let checker = Pattern::Checker { even: Rgb::WHITE, odd: Rgb::BLACK, u, v: v_axis };
    for (x, z, even) in [(0.5, 0.5, true), (-0.5, 0.5, false), (-0.5, -0.5, true), (-1.5, -0.5, false)] {
        let expected = if even { Color::WHITE } else { Color::BLACK };
        assert_eq!(pattern(&checker, v(x, 7.3, z)), expected);
    }
    let axis = Vec3::new(0.0, 0.5, 0.0);
    let gradient = Pattern::Gradient { from: Rgb::BLACK, to: Rgb::WHITE, origin: UP, axis };
    for (y, t) in [(0.0, 0.0), (1.0, 0.0), (1.5, 0.25), (3.0, 1.0), (9.0, 1.0)] {
        assert_eq!(pattern(&gradient, v(5.0, y, 5.0)), Color::grey(t));
    }
    let sky = Background::Sky { horizon: Rgb::WHITE, up: UP };
    for (y, expected) in [(0.0, 1.0), (1.0, 0.0), (0.5, 0.0625), (-1.0, 16.0)] {
        assert_eq!(background(&sky, v(0.0, y, 0.0)), Color::grey(expected));
    }
}

#[test]
fn constant_shares_do_not_depend_on_the_angle() {
    let interface =
        Interface::Constant { reflected: Rgb::grey(0.25), transmitted: Rgb::grey(0.5), medium: Medium::new(1.5) };
    let material = Material { interface, ..Material::dielectric(1.0) };
    for angle in [0.0, 0.5, 1.5] {
        let branches = on_plane(material, 1.0, angle, 1.0);
        assert_eq!(branches.reflected.unwrap().0, Color::grey(0.25));
        assert_eq!(branches.transmitted[0].weight, Color::grey(0.5));
    }
    let total = on_plane(material, 1.0, 1.5, -1.0);
    assert_eq!((total.reflected.unwrap().0, total.total_internal), (Color::grey(0.75), true));
}

#[test]
fn the_square_is_mapped_to_the_disc_ring_by_ring() {
    let half = 0.5_f64.sqrt();
    let cases = [
        ([1.0, 0.5], [1.0, 0.0]),
        ([0.5, 1.0], [0.0, 1.0]),
        ([0.25, 0.5], [-0.5, 0.0]),
        ([0.5, 0.25], [0.0, -0.5]),
        ([1.0, 1.0], [half, half]),
        ([0.0, 1.0], [-half, half]),
        ([1.0, 0.75], [FRAC_PI_8.cos(), FRAC_PI_8.sin()]),
        ([0.75, 1.0], [FRAC_PI_8.sin(), FRAC_PI_8.cos()]),
    ];
    for (square, disc) in cases {
        let [x, y] = concentric(square);
        assert!((x - disc[0]).abs() < 1e-15 && (y - disc[1]).abs() < 1e-15, "{square:?} {x} {y}");
    }
}

#[test]
fn a_light_behind_the_flat_triangle_or_the_smooth_one_does_not_count() {
    let vertices = [Vec3::new(-1.0, 0.0, 1.0), Vec3::new(1.0, 0.0, 1.0), Vec3::new(0.0, 0.0, -1.0)];
    let shape = Shape::SmoothTriangle(SmoothTriangle { vertices, normals: [Vec3::new(3.0, 4.0, 0.0); 3] });
    let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
    for (x, y, expected) in [(4.0, 3.0, 0.96), (4.0, -1.0, 0.0), (-3.0, 1.0, 0.0)] {
        let lights = [Light::directional(Vec3::new(x, y, 0.0), Rgb::WHITE)];
        let scene = Scene::new(CAMERA, BLACK).with_objects(&objects).with_lights(&lights);
        let world = World::new(&scene);
        let ray = Ray::new(v(0.0, 1.0, 0.0), v(0.0, -1.0, 0.0));
        let hit = world.nearest(&ray).unwrap();
        let mut counts = Counts::default();
        let light = local(&world, &hit, ray.direction, Color::WHITE, 0, &|_| [0.5, 0.5], &mut counts);
        assert!((light.max_channel() - expected).abs() < 1e-12);
        assert_eq!(counts.shadow, u64::from(expected > 0.0));
    }
}

#[test]
fn every_light_at_every_depth_has_sample_numbers_of_its_own() {
    let mirror = Material::matte(Rgb::WHITE).with_interface(Interface::Mirror { reflected: Rgb::WHITE });
    let objects =
        [Object::new(Shape::plane(Vec3::new(0.0, -1.0, 0.0), UP), mirror), Object::new(Shape::plane(UP, UP), mirror)];
    let lights = [0.25, 0.5].map(|radius| Light::sphere(Vec3::ZERO, radius, Rgb::WHITE));
    let scene = Scene::new(CAMERA, BLACK).with_objects(&objects).with_lights(&lights);
    let (world, asked) = (World::new(&scene), Mutex::new(Vec::new()));
    let numbers = |x, y, sample, dimension| {
        asked.lock().unwrap().push((x, y, sample, dimension));
        [0.5, 0.5]
    };
    let eye = Samples { count: 2, numbers: &numbers };
    // From (0, 0, 5) down to the floor, up to the ceiling, and down again.
    trace_pixel(&world, &Settings::new(9, 9, 2), &eye, [4, 8], &mut Counts::default());
    let expected: Vec<_> =
        (0..2).flat_map(|sample| [0, 2, 3, 4, 5, 6, 7].map(|dimension| (4, 8, sample, dimension))).collect();
    assert_eq!(asked.into_inner().unwrap(), expected);
}

#[test]
fn the_first_of_two_equal_objects_is_seen() {
    let shape = Shape::sphere(Vec3::ZERO, 1.0);
    let objects = [Rgb::WHITE, Rgb::BLACK].map(|color| Object::new(shape, Material::matte(color)));
    let scene = Scene::new(CAMERA, BLACK).with_objects(&objects);
    let hit = World::new(&scene).nearest(&Ray::new(v(0.0, 0.0, 5.0), v(0.0, 0.0, -1.0))).unwrap();
    assert_eq!((hit.surface.primitive, hit.object), (0, &objects[0]));
}
