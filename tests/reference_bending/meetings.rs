//! Objects that are met along a curve.

use whit::scene::{
    Background, BlackHole, Camera, Law, Level, Material, Medium, Method, Object, Profile, Scene, Shape, Steps,
};
use whit::{Rgb, Vec3};

use super::reference::bent::Arrival;
use super::reference::path::{End, Place, follow};
use super::reference::shapes::Ray;
use super::reference::vector::Vector;
use super::reference::world::World;
use super::reference::{Branch, Counts, Settings};

const STEPS: Steps<f32> = Steps::Controlled { tolerance: 1e-4 };
const FISH_EYE: [Profile<'static, f32>; 1] = [Profile {
    level: Level::Radius { center: Vec3::ZERO, radius: 0.0 },
    from: 0.0,
    to: 50.0,
    law: Law::FishEye { index: 2.0, radius: 1.0 },
    method: Method::Steps(STEPS),
}];
const HOLE: BlackHole<f32> = BlackHole { center: Vec3::new(0.1, -0.2, 0.3), mass: 0.25, steps: STEPS };

fn empty() -> Scene<'static, f32> {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    Scene::new(camera, Background::Solid(Rgb::WHITE))
}

/// Each with a ray, and how long it is followed.
fn scenes() -> [(Scene<'static, f32>, Ray, f64); 2] {
    let fish_eye = empty().with_profiles(&FISH_EYE).with_medium(Medium::graded(0));
    let hole = empty().with_black_hole(HOLE);
    [
        (fish_eye, Ray::new(Vector::new(0.5, 0.1, -0.2), Vector::new(0.2, 0.6, 1.0)), 4.0),
        (hole, Ray::new(Vector::new(-3.0, 0.9, 0.7), Vector::new(1.0, 0.15, 0.0)), 7.0),
    ]
}

fn place(scene: &Scene<'_, f32>, ray: &Ray, length: f64) -> Place {
    match follow(scene, ray.origin, ray.direction, length) {
        End::At(place) => place,
        End::Captured => panic!("captured"),
    }
}

fn rounded(v: Vector) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

/// The length of the path to the first surface and the tangent there.
fn met(scene: Scene<'_, f32>, ray: &Ray, shape: Shape<'_, f32>) -> Option<(f64, Ray, Vector)> {
    let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
    let scene = scene.with_objects(&objects);
    let world = World::new(&scene);
    match world.travel(world.bend(ray).unwrap(), ray) {
        Arrival::Surface { ray, hit, length } => Some((length, ray, hit.point)),
        Arrival::Away { .. } => None,
        Arrival::Captured => panic!("captured"),
    }
}

/// The hit is on the curve, on the surface, and the first one.
#[test]
fn every_shape_is_met_on_the_curve() {
    for (scene, ray, whole) in scenes() {
        for share in [0.05, 0.3, 0.5, 0.8, 1.0] {
            let aimed = place(&scene, &ray, share * whole);
            let (c, d) = (rounded(aimed.point), rounded(aimed.direction));
            let beside = aimed.direction.cross(Vector::new(0.0, 1.0, 0.0)).normalized() * 0.05;
            let small = Vec3::new(0.02, 0.03, 0.01);
            let shapes = [
                Shape::sphere(c, 0.02),
                Shape::plane(c, d),
                Shape::disc(c, d, 0.1),
                Shape::annulus(c + rounded(beside), d, 0.01, 0.1),
                Shape::axis_box(c - small, c + small),
                Shape::triangle(
                    c + Vec3::new(0.1, 0.0, 0.07),
                    c + Vec3::new(-0.1, 0.1, 0.0),
                    c + Vec3::new(-0.1, -0.1, -0.14),
                ),
                Shape::cylinder(c - small, c + small, 0.03).capped(),
            ];
            for shape in shapes {
                let (length, tangent, point) =
                    met(scene, &ray, shape).unwrap_or_else(|| panic!("{shape:?} {share} {aimed:?}"));
                let on_curve = place(&scene, &ray, length);
                assert!((on_curve.point - point).length() < 1e-8, "{shape:?}");
                assert!((on_curve.direction - tangent.direction).length() < 1e-8, "{shape:?}");
                // A plane may be met before.
                let least = if matches!(shape, Shape::Plane(_)) { 0.0 } else { share * whole - 0.1 };
                assert!(length > least && length < share * whole + 0.06, "{shape:?} {length}");
            }
        }
    }
}

/// A sphere that the curve just touches, or just not.
#[test]
fn spheres_are_grazed_to_the_millionth() {
    for (scene, ray, whole) in scenes() {
        for share in [0.2, 0.5, 0.9] {
            let Place { point, direction } = place(&scene, &ray, share * whole);
            for across in [direction.cross(Vector::new(1.0, 0.0, 0.0)), direction.cross(Vector::new(0.3, -1.0, 0.2))] {
                // As the numbers of the scene are rounded, the distance is that of the center they give.
                let center = Vector::from(rounded(point + across.normalized() * 0.1));
                let distance = (0..=200)
                    .map(|i| (place(&scene, &ray, share * whole + 1e-4 * f64::from(i - 100)).point - center).length())
                    .fold(f64::INFINITY, f64::min);
                let shape = |share: f64| Shape::sphere(rounded(center), (distance * share) as f32);
                assert!(met(scene, &ray, shape(1.0 + 1e-6)).is_some());
                assert!(met(scene, &ray, shape(1.0 - 1e-6)).is_none());
            }
        }
    }
}

#[test]
fn an_annulus_has_a_hole() {
    let scene = empty();
    let objects =
        [Object::new(Shape::annulus(Vec3::ZERO, Vec3::new(0.0, 0.0, 1.0), 1.0, 2.0), Material::matte(Rgb::WHITE))];
    let scene = scene.with_objects(&objects);
    for (x, seen) in [(0.0, false), (0.999, false), (1.001, true), (1.999, true), (2.001, false)] {
        let ray = Ray::new(Vector::new(x, 0.0, 5.0), Vector::new(0.0, 0.0, -1.0));
        assert_eq!(World::new(&scene).nearest(&ray).is_some(), seen, "{x}");
    }
}

/// Along the gradient light goes straight; each face reflects by the index next to it. With a share a left by the glass,
/// (1 − r₁)·(1 − r₂)·a/(1 − r₁·r₂·a²) get through.
#[test]
fn the_faces_of_graded_glass_have_its_index() {
    let profiles = [Profile {
        level: Level::Height { origin: Vec3::ZERO, up: Vec3::new(1.0, 0.0, 0.0) },
        from: -1.0,
        to: 1.0,
        // n² from 1.5² to 2².
        law: Law::Polynomial { constant: 2.125, linear: 0.875, quadratic: 0.0 },
        method: Method::Steps(STEPS),
    }];
    let glass = Medium::graded(0).with_attenuation(Rgb::new(0.0, 0.5, 1.5));
    let slab = Shape::axis_box(Vec3::new(-1.0, -9.0, -9.0), Vec3::new(1.0, 9.0, 9.0));
    let objects = [Object::new(slab, Material::transparent(glass))];
    let lamp = Background::Gradient { below: Rgb::BLACK, above: Rgb::WHITE, up: Vec3::new(1.0, 0.0, 0.0) };
    let scene = Scene { background: lamp, ..empty() }.with_profiles(&profiles).with_objects(&objects);
    let ray = Ray::new(Vector::new(-4.0, 0.1, 0.2), Vector::new(1.0, 0.0, 0.0));
    let settings = Settings::new(1, 1, 60);
    let light = Branch::eye(&World::new(&scene), &settings, &|_| [0.5; 2]).trace(&ray, &mut Counts::default()).0;
    let reflectance = |n: f64| ((n - 1.0) / (n + 1.0)).powi(2);
    let (first, second) = (reflectance(1.5), reflectance(2.0));
    for (found, c) in light.into_iter().zip([0.0_f64, 0.5, 1.5]) {
        let a = (-2.0 * c).exp();
        let expected = (1.0 - first) * (1.0 - second) * a / (1.0 - first * second * a * a);
        assert!((found - expected).abs() < 1e-12, "{found} is not {expected}");
    }
}
