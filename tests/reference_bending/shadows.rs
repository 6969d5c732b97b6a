//! Bent paths to lights.

use whit::scene::{
    Background, BlackHole, Camera, Law as SceneLaw, Level, Light, Material, Medium, Method, Object, Profile, Scene,
    Shape, Steps,
};
use whit::{Rgb, Vec3};

use super::reference::aim::{Path, Target, aim};
use super::reference::hole::Hole;
use super::reference::law::Law;
use super::reference::path::{Bend, End, Place, go};
use super::reference::shapes::Ray;
use super::reference::vector::Vector;
use super::reference::world::World;
use super::reference::{Branch, Counts, Settings};
use super::{Worst, after, ball, layered, v};

const STEPS: Steps<f32> = Steps::Controlled { tolerance: 1e-4 };

fn length(path: &Path) -> f64 {
    let (last, whole) = path.pieces.split_last().unwrap();
    whole.iter().map(|piece| piece.length()).sum::<f64>() + last.length_to(path.last)
}

#[test]
fn paths_reach_the_light() {
    let hot = layered(-3.0, 2.0, Law::Thermal { excess: 0.4, ratio: 0.6, scale: 0.3 });
    let lens = ball(0.0, 3.0, Law::Exponential { far: 1.0, excess: 0.5, scale: 0.7 });
    let hole = Hole { center: v(0.2, 0.1), mass: 0.05 };
    let mut worst = Worst::default();
    for bend in [Bend::Graded(&hot), Bend::Graded(&lens), Bend::Hole(&hole)] {
        for i in 0..40 {
            let at = |k: f64| 0.5 + 0.5 * (f64::from(i) * k).sin();
            let origin = Vector::new(-1.5 - at(1.7), 0.05 + at(2.3), 0.4 * at(0.7));
            let light = Vector::new(1.0 + at(3.1), 0.1 + 1.5 * at(0.3), 0.3 * at(5.1));
            let Some(path) = aim(bend, origin, Target::Point(light)) else {
                panic!("no path from {origin:?} to {light:?}");
            };
            let end = after(bend, Place { point: origin, direction: path.direction }, length(&path));
            worst.note((end.point - light).length(), 1e-9, (bend, i));
        }
    }
    println!("from points to lights: {:.1e}", worst.0);
}

/// Straight behind a hole too, on the side of it where the straight line is.
#[test]
fn paths_lead_around_a_hole() {
    let hole = Hole { center: Vector::ZERO, mass: 1.0 };
    for y in [0.01, 0.5, 1.5, -2.0, 4.0] {
        let path = aim(Bend::Hole(&hole), v(-20.0, y), Target::Point(v(25.0, 0.0))).unwrap();
        assert_eq!(path.direction.y > 0.0, y > 0.0, "{y}");
        let start = Place { point: v(-20.0, y), direction: path.direction };
        let End::At(end) = go(Bend::Hole(&hole), start, length(&path)) else { panic!("captured") };
        assert!((end.point - v(25.0, 0.0)).length() < 1e-8);
    }
}

/// n·cos θ is the same at the ground as in the sky.
#[test]
fn light_from_the_sky_comes_down_by_the_law_of_snell() {
    let air = layered(0.0, 5.0, Law::Exponential { far: 1.0, excess: 0.3, scale: 0.4 });
    let origin = Vector::new(3.0, 0.0, -1.0);
    for degrees in [3.0_f64, 20.0, 60.0, 90.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let towards = Vector::new(0.6 * cosine, sine, 0.8 * cosine);
        let path = aim(Bend::Graded(&air), origin, Target::Direction(towards)).unwrap();
        let below = cosine * air.index(v(0.0, 5.0)) / air.index(v(0.0, 0.0));
        let expected = Vector::new(0.6 * below, (1.0 - below * below).sqrt(), 0.8 * below);
        assert!((path.direction - expected).length() < 1e-9, "{degrees}");
    }
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?} within {tolerance:e}");
}

/// The light at a point of a white surface.
fn lit(scene: &Scene<'_, f32>, point: Vector, normal: Vector) -> [f64; 3] {
    let ray = Ray::new(point + normal * 1e-3, -normal);
    let world = World::new(scene);
    let settings = Settings::new(1, 1, 0);
    Branch::eye(&world, &settings, &|_| [0.5; 2]).trace(&ray, &mut Counts::default()).0
}

const EYE: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
const BLACK: Background<f32> = Background::Solid(Rgb::BLACK);

/// In the fish-eye, from (−1/2, 0, 0) to (0, 1/2, 0): through the conjugates (2, 0, 0) and (0, −2, 0) as well, on a circle
/// around (3/4, −3/4, 0) with the radius √34/4.
#[test]
fn the_fish_eye_lights_and_hides_by_circles() {
    let profiles = [Profile {
        level: Level::Radius { center: Vec3::ZERO, radius: 0.0 },
        from: 0.0,
        to: 50.0,
        law: SceneLaw::FishEye { index: 2.0, radius: 1.0 },
        method: Method::Steps(STEPS),
    }];
    let (center, radius) = (v(0.75, -0.75), 34.0_f64.sqrt() / 4.0);
    let (from, to) = (v(-0.5, 0.0), v(0.0, 0.5));
    let at = |angle: f64| center + v(angle.cos(), angle.sin()) * radius;
    let middle = at(135.0_f64.to_radians());
    let lights = [Light::point(Vec3::new(0.0, 0.5, 0.0), Rgb::WHITE)];
    let fading = Medium::graded(0).with_attenuation(Rgb::new(0.0, 0.3, 2.0));
    let small = |p: Vector| Shape::sphere(Vec3::new(p.x as f32, p.y as f32, p.z as f32), 0.01);
    let wall = Object::new(
        Shape::plane(Vec3::new(-0.5, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0)),
        Material::matte(Rgb::WHITE).with_shares(0.0, 0.0, 1.0),
    );
    let scene =
        Scene::new(EYE, BLACK).with_profiles(&profiles).with_medium(fading).with_lights(&lights).with_bent_shadows();
    let eye = |objects: &[Object<'_, f32>]| {
        let scene = scene.with_objects(objects);
        lit(&scene, from, v(1.0, 0.0))
    };
    // The chord and the arc from the point to the light.
    let chord = (to - from).length();
    let arc = 2.0 * radius * (0.5 * chord / radius).asin();
    let radial = (from - center) * radius.recip();
    let cosine = radial.y.abs();
    let expected = [0.0, 0.3, 2.0].map(|c: f64| cosine * (-c * (arc + 1e-3)).exp());
    let found = eye(&[wall]);
    close(found, expected, 1e-6);
    let marble = |at| Object::new(small(at), Material::matte(Rgb::WHITE));
    assert_eq!(eye(&[wall, marble(middle)]), [0.0; 3]);
    close(eye(&[wall, marble((from + to) * 0.5)]), found, 1e-12);
    close(eye(&[wall, marble(middle).without_shadow()]), found, 1e-12);
    let behind = to + (to - middle) * 0.3;
    close(eye(&[wall, marble(behind)]), found, 1e-12);
}

/// A wall behind a hole, with a light on the other side of it.
#[test]
fn a_hole_hides_a_light_from_straight_shadow_rays_alone() {
    let hole = BlackHole { center: Vec3::ZERO, mass: 1.0, steps: STEPS };
    let lights = [Light::point(Vec3::new(25.0, 0.0, 0.0), Rgb::WHITE)];
    let wall = [Object::new(
        Shape::plane(Vec3::new(-20.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0)),
        Material::matte(Rgb::WHITE).with_shares(0.0, 0.0, 1.0),
    )];
    let scene = Scene::new(EYE, BLACK).with_black_hole(hole).with_lights(&lights).with_objects(&wall);
    for (y, straight) in [(0.3, false), (1.0, false), (3.5, false), (3.7, true), (8.0, true)] {
        let point = v(-20.0, y);
        assert_eq!(lit(&scene, point, v(1.0, 0.0))[0] > 0.5, straight, "{y}");
        assert!(lit(&scene.with_bent_shadows(), point, v(1.0, 0.0))[0] > 0.5, "{y}");
    }
}
