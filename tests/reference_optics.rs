//! The reference tracer's reflectances without a film, against tables, closed forms and POV-Ray.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod povray_scene;
mod reference;

use reference::compare::{Difference, share_over};
use reference::complex::Complex;
use reference::fresnel::{conductor, dielectric};
use reference::optics::{Branches, branches};
use reference::shapes::Ray;
use reference::vector::{Color, Vector};
use reference::world::World;
use reference::{Branch, Counts, Samples, Settings, Termination, render};
use whit::scene::{Background, Camera, Fresnel, Light, Material, Medium, Object, Scene, Shape};
use whit::{Rgb, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
const BLACK: Background<f32> = Background::Solid(Rgb::BLACK);

/// The rows of a table after its head.
fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    table.lines().skip(1).map(|line| line.split(',').collect())
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// A ray through (0, 1, 0), or from below through (0, −1, 0), to the origin.
fn to_origin(degrees: f64, height: f64) -> Ray {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    Ray::new(Vector::new(-sine, cosine * height, 0.0), Vector::new(sine, -cosine * height, 0.0))
}

/// The branches where a ray meets the plane y = 0.
fn on_plane(material: Material<f32>, medium: f32, fresnel: Fresnel, ray: &Ray) -> Branches {
    let plane = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
    let scene = Scene::new(CAMERA, BLACK).with_objects(&plane).with_medium(Medium::new(medium));
    let world = World::new(&scene);
    let hit = world.nearest(ray).unwrap();
    branches(&hit, ray.direction, &world.border(ray, &hit).unwrap(), fresnel, None)
}

fn weight(branches: &Branches) -> [f64; 3] {
    branches.reflected.unwrap().0.0
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?} within {tolerance:e}");
}

#[test]
fn povray_c_glass() {
    let povray = povray_scene::c_glass_picture();
    agrees_with_povray(&povray_scene::C_GLASS, &povray);
    // The test sees the difference between the equations and the approximation.
    let (approximate, _) = picture_like(&povray, &povray_scene::C_GLASS.with_fresnel(Fresnel::Schlick));
    assert!(share_over(1e-4, &povray.pixels, &approximate) > 0.05);
}

#[test]
fn povray_d_beer_fade() {
    agrees_with_povray(&povray_scene::D_BEER_FADE, &povray_scene::d_beer_fade_picture());
}

fn agrees_with_povray(scene: &Scene<'_, f32>, povray: &povray_scene::Picture) {
    let (picture, counts) = picture_like(povray, scene);
    println!("{}; {counts:?}", Difference::between(&povray.pixels, &picture));
    assert!(share_over(1e-4, &povray.pixels, &picture) <= 0.001);
}

fn picture_like(povray: &povray_scene::Picture, scene: &Scene<'_, f32>) -> (Vec<[f64; 3]>, Counts) {
    let settings = Settings::new(povray.width, povray.height, povray_scene::DEPTH);
    render(scene, &Settings { termination: Termination::Black, ..settings }, &Samples::CENTRE)
}

#[test]
fn dielectrics_reflect_as_in_the_table() {
    let from_bits = |text: &str| f64::from(f32::from_bits(u32::from_str_radix(text, 16).unwrap()));
    let (mut seen, mut total) = (0, 0);
    for row in rows(include_str!("data/oracles/fresnel.csv")) {
        let (n, cosine, expected) = (from_bits(row[0]), from_bits(row[2]), number(row[6]));
        let found = dielectric(Fresnel::Exact, 1.0, n, cosine);
        assert!((found - expected).abs() <= 1e-14, "{row:?}: {found}");
        (seen, total) = (seen + 1, total + usize::from(row[7] == "TIR"));
        assert!(row[7] != "TIR" || found == 1.0, "{row:?}: {found}");
    }
    assert!(seen == 325 && total > 20, "{seen} {total}");
}

#[test]
fn conductors_reflect_as_in_the_table() {
    let mut seen = 0;
    for row in rows(include_str!("data/oracles/conductor.csv")) {
        let [n, k, degrees, expected] = [2, 3, 4, 7].map(|column| number(row[column]));
        let found = conductor(Complex::new(n, k), degrees.to_radians().cos());
        assert!((found - expected).abs() < 1e-14, "{row:?}: {found}");
        seen += 1;
    }
    assert_eq!(seen, 83);
}

#[test]
fn both_directions_of_a_surface_divide_light_alike() {
    for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
        for (outside, inside) in [(1.0, 1.5), (1.25, 1.0), (1.0, 2.4)] {
            for degrees in [0.0, 20.0, 45.0, 52.0, 80.0] {
                let glass = Material::dielectric(inside);
                let enter = on_plane(glass, outside, fresnel, &to_origin(degrees, 1.0));
                let Some(sent) = enter.transmitted.first() else {
                    assert_eq!((weight(&enter), enter.total_internal), ([1.0; 3], true));
                    continue;
                };
                assert_eq!(sent.weight + enter.reflected.unwrap().0, Color::WHITE);
                let within = sent.direction.x.asin().to_degrees();
                let leave = on_plane(glass, outside, fresnel, &to_origin(within, -1.0));
                close(weight(&enter), weight(&leave), 1e-13);
            }
        }
    }
}

#[test]
fn half_of_the_light_is_lost_to_polarisation_at_brewsters_angle() {
    // Light of one polarisation is not reflected at tan θ = n, and of the other one ((n² − 1)/(n² + 1))².
    let n = f64::from(1.7_f32);
    let branches = on_plane(Material::dielectric(1.7), 1.0, Fresnel::Exact, &to_origin(n.atan().to_degrees(), 1.0));
    close(weight(&branches), [0.5 * ((n * n - 1.0) / (n * n + 1.0)).powi(2); 3], 1e-14);
}

#[test]
fn a_conductor_is_seen_relative_to_what_is_around_it() {
    let (index, extinction) = (Rgb::new(0.25, 0.5, 1.5), Rgb::new(3.5, 2.5, 0.0));
    let metal = Material::conductor(index, extinction);
    for medium in [1.0, 1.5] {
        // At normal incidence ((η − n)² + k²)/((η + n)² + k²).
        let closed = |eta: f64, k: f64| {
            let n = f64::from(medium);
            ((eta - n).powi(2) + k * k) / ((eta + n).powi(2) + k * k)
        };
        for height in [1.0, -1.0] {
            let branches = on_plane(metal, medium, Fresnel::Exact, &to_origin(0.0, height));
            close(weight(&branches), [closed(0.25, 3.5), closed(0.5, 2.5), closed(1.5, 0.0)], 1e-14);
            assert!(branches.transmitted.is_empty() && !branches.total_internal);
        }
        // Without extinction it is a dielectric.
        let blue = weight(&on_plane(metal, medium, Fresnel::Exact, &to_origin(70.0, 1.0)))[2];
        let glass = on_plane(Material::dielectric(1.5), medium, Fresnel::Exact, &to_origin(70.0, 1.0));
        assert!((blue - weight(&glass)[0]).abs() < 1e-14);
    }
}

/// The light that a ray finds.
fn trace(scene: &Scene<'_, f32>, depth: u32, ray: &Ray) -> [f64; 3] {
    let settings = Settings { termination: Termination::Color([0.5; 3]), ..Settings::new(1, 1, depth) };
    Branch::eye(&World::new(scene), &settings, &|_| [0.5; 2]).trace(ray, &mut Counts::default()).0
}

#[test]
fn a_coat_takes_light_from_the_body_but_not_from_the_highlight() {
    let body = Material::matte(Rgb::new(0.5, 0.25, 1.0)).with_shares(0.25, 0.125, 0.5);
    let lights = [Light::directional(UP, Rgb::WHITE)];
    for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
        for (medium, degrees, height) in [(1.0, 0.0_f64, 1.0), (1.0, 60.0, 1.0), (1.25, 50.0, -1.0), (1.75, 75.0, 1.0)]
        {
            let material = body.with_highlight(Rgb::WHITE, 2).with_coat(1.5);
            let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
            let scene = Scene::new(CAMERA, BLACK).with_objects(&objects).with_lights(&lights);
            let scene = scene.with_medium(Medium::new(medium)).with_fresnel(fresnel);
            let cosine = degrees.to_radians().cos();
            let r = dielectric(fresnel, medium.into(), 1.5, cosine);
            assert_eq!(r == 1.0, medium == 1.75);
            // From below there is no light but what the body emits.
            let (lit, shining) = if height > 0.0 { (0.625, 0.5 * (1.0 + cosine)) } else { (0.0, 0.0) };
            let expected = [0.5, 0.25, 1.0].map(|color| color * (0.25 + lit) * (1.0 - r) + shining + 0.5 * r);
            close(trace(&scene, 0, &to_origin(degrees, height)), expected, 1e-14);
        }
    }
}

#[test]
fn the_balance_weighs_own_light_against_branches() {
    let material = Material::matte(Rgb::WHITE)
        .with_shares(1.0, 0.0, 1.0)
        .with_highlight(Rgb::WHITE, 1)
        .with_interface(whit::Interface::Mirror { reflected: Rgb::new(1.0, 0.5, 0.0) });
    let lights = [Light::directional(UP, Rgb::WHITE)];
    for (balance, own, sent) in [(None, 1.0, 1.0), (Some((0.25, 0.5)), 0.375, 0.125), (Some((0.5, 2.0)), 1.0, 1.0)] {
        let material = balance.map_or(material, |(ratio, brightness)| material.with_balance(ratio, brightness));
        let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
        let scene = Scene::new(CAMERA, BLACK).with_objects(&objects).with_lights(&lights);
        let expected = [1.0, 0.5, 0.0].map(|reflected| own * (1.0 + 1.0 + 1.0) + sent * reflected * 0.5);
        close(trace(&scene, 0, &to_origin(0.0, 1.0)), expected, 1e-14);
        // What goes through counts as what is reflected.
        let glass = Material { interface: Material::dielectric(1.5).interface, ..material };
        let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), glass)];
        close(trace(&scene.with_objects(&objects), 0, &to_origin(0.0, 1.0)), [own * 3.0 + sent * 0.5; 3], 1e-14);
    }
}
