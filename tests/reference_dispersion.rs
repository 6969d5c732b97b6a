//! The reference tracer's dispersion: every channel goes the way of its own index.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod reference;

use reference::compare::Difference;
use reference::complex::Complex;
use reference::film::airy;
use reference::fresnel::{conductor, dielectric};
use reference::optics::{Branches, branches};
use reference::shapes::Ray;
use reference::spectrum::CHANNELS;
use reference::vector::Vector;
use reference::world::World;
use reference::{Branch, Counts, Samples, Settings, Termination, render};
use whit::scene::{
    Background, Camera, Channel, Film, Fresnel, Interface, Light, Material, Medium, Object, Pattern, Scene, Shape,
    Spectrum,
};
use whit::{Rgb, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);
const DAYLIGHT: Background<f32> =
    Background::Gradient { below: Rgb::new(0.3, 0.2, 0.1), above: Rgb::new(0.5, 0.7, 1.0), up: UP };
/// Stronger than any glass.
const INDICES: [f32; 3] = [1.25, 1.5, 2.0];
const GLASS: Medium<f32> = Medium::dispersive(Rgb::new(INDICES[0], INDICES[1], INDICES[2]));

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?} within {tolerance:e}");
}

/// A ray through (0, 1, 0), or from below through (0, −1, 0), to the origin.
fn to_origin(degrees: f64, height: f64) -> Ray {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    Ray::new(Vector::new(-sine, cosine * height, 0.0), Vector::new(sine, -cosine * height, 0.0))
}

/// The branches where a ray meets the plane y = 0.
fn on_plane(material: Material<f32>, medium: Medium<f32>, channel: Option<Channel>, ray: &Ray) -> Branches {
    let plane = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
    let scene = Scene::new(CAMERA, DAYLIGHT).with_objects(&plane).with_medium(medium);
    let world = World::new(&scene);
    let hit = world.nearest(ray).unwrap();
    branches(&hit, ray.direction, &world.border(ray, &hit).unwrap(), Fresnel::Exact, channel)
}

/// White in one channel.
fn only(i: usize, value: f64) -> [f64; 3] {
    let mut color = [0.0; 3];
    color[i] = value;
    color
}

#[test]
fn each_channel_is_refracted_by_snells_law() {
    let (sine, cosine) = 50_f64.to_radians().sin_cos();
    // Into the glass, and from glass all around into a vacuum, where only red does not stay inside.
    let cases = [
        (Material::transparent(GLASS), Medium::new(1.0), [true; 3]),
        (Material::dielectric(1.0), GLASS, [true, false, false]),
    ];
    for (material, medium, passes) in cases {
        let into_glass = medium == Medium::new(1.0);
        let branches = on_plane(material, medium, None, &to_origin(50.0, 1.0));
        let mut reflected = [1.0; 3];
        let mut transmitted = branches.transmitted.iter();
        for i in 0..3 {
            let n = f64::from(INDICES[i]);
            let (n1, n2) = if into_glass { (1.0, n) } else { (n, 1.0) };
            if passes[i] {
                reflected[i] = dielectric(Fresnel::Exact, n1, n2, cosine);
                let branch = transmitted.next().unwrap();
                assert_eq!(branch.channel, Some(Channel::ALL[i]));
                assert!((n2 * branch.direction.x - n1 * sine).abs() < 1e-15);
                close(branch.weight.0, only(i, 1.0 - reflected[i]), 1e-15);
            } else {
                assert!(n1 * sine > n2);
            }
            // Light of one channel is not divided any further.
            let branches = on_plane(material, medium, Some(Channel::ALL[i]), &to_origin(50.0, 1.0));
            assert_eq!((branches.transmitted.len(), branches.total_internal), (usize::from(passes[i]), !passes[i]));
            let of_channel = branches.reflected.unwrap().0.0[i];
            assert_eq!(of_channel, reflected[i]);
        }
        assert!(transmitted.next().is_none());
        close(branches.reflected.unwrap().0.0, reflected, 1e-15);
        assert!(!branches.total_internal);
    }
    let total = on_plane(Material::dielectric(1.0), GLASS, None, &to_origin(60.0, 1.0));
    assert_eq!((total.reflected.unwrap().0.0, total.transmitted.len(), total.total_internal), ([1.0; 3], 0, true));
}

#[test]
fn constant_shares_are_dispersed_too() {
    let (reflected, transmitted) = (Rgb::new(0.125, 0.25, 0.5), Rgb::new(0.5, 0.375, 0.25));
    let material =
        Material::dielectric(1.0).with_interface(Interface::Constant { reflected, transmitted, medium: GLASS });
    let branches = on_plane(material, Medium::VACUUM, None, &to_origin(50.0, -1.0));
    // Red gets out; green and blue are reflected with both shares.
    close(branches.reflected.unwrap().0.0, [0.125, 0.625, 0.75], 0.0);
    assert_eq!(branches.transmitted.len(), 1);
    close(branches.transmitted[0].weight.0, [0.5, 0.0, 0.0], 0.0);
}

#[test]
fn a_film_on_dispersive_glass() {
    let film = Film::new(1.75, 300.0).with_spectrum(Spectrum::Wavelengths);
    let material = Material::transparent(GLASS).with_film(film);
    let cosine = 0.25_f64;
    let ray = to_origin(cosine.acos().to_degrees(), 1.0);
    let expected = [0, 1, 2].map(|i| airy(1.0, cosine, 1.75, 300.0, f64::from(INDICES[i]).into(), CHANNELS[i]));
    let branches = on_plane(material, Medium::VACUUM, None, &ray);
    close(branches.reflected.unwrap().0.0, expected, 1e-13);
    for (i, reflected) in expected.into_iter().enumerate() {
        close(branches.transmitted[i].weight.0, only(i, 1.0 - reflected), 1e-13);
    }
}

/// Where nothing goes on, light of all channels takes the index of green.
#[test]
fn opaque_surfaces_do_not_divide_light() {
    let cosine = 0.5_f64;
    let ray = to_origin(60.0, 1.0);
    let coat = Material::matte(Rgb::WHITE).with_coat(2.5);
    let metal = Material::conductor(Rgb::grey(0.5), Rgb::grey(3.0));
    let film = Film::new(1.75, 300.0).with_spectrum(Spectrum::Wavelengths);
    for (channel, index) in [(None, 1.5), (Some(Channel::Red), 1.25), (Some(Channel::Blue), 2.0)] {
        let weight = |material| on_plane(material, GLASS, channel, &ray).reflected.unwrap().0.0;
        close(weight(coat), [dielectric(Fresnel::Exact, index, 2.5, cosine); 3], 1e-14);
        let base = Complex::new(0.5, 3.0);
        close(weight(metal), [conductor(base / index.into(), cosine); 3], 1e-14);
        let expected = CHANNELS.map(|wavelength| airy(index, cosine, 1.75, 300.0, base, wavelength));
        close(weight(metal.with_film(film)), expected, 1e-13);
    }
}

#[test]
fn one_ray_for_each_channel_is_counted() {
    let glass = [Object::new(Shape::axis_box(Vec3::splat(-1.0), Vec3::splat(1.0)), Material::transparent(GLASS))];
    let scene = Scene::new(CAMERA, DAYLIGHT).with_objects(&glass);
    let world = World::new(&scene);
    let trace = |depth, ray: &Ray| {
        let mut counts = Counts::default();
        let light = Branch::eye(&world, &Settings::new(1, 1, depth), &|_| [0.5; 2]).trace(ray, &mut counts);
        (light.0, counts)
    };
    let ray = Ray::new(Vector::new(0.0, 0.0, 3.0), Vector::new(0.0, 0.0, -1.0));
    let (_, first) = trace(1, &ray);
    assert_eq!((first.reflected, first.transmitted), (1, 3));
    // In the box each channel is divided in two; outside nothing is met.
    let (_, second) = trace(2, &ray);
    assert_eq!((second.reflected, second.transmitted), (1 + 3, 3 + 3));
    // From within one ray is sent back for all channels, which is divided again on the other side.
    let within = Ray::new(Vector::new(0.0, 0.0, 0.0), Vector::new(0.0, 0.0, -1.0));
    let (_, second) = trace(2, &within);
    assert_eq!((second.reflected, second.transmitted, second.total_internal), (1 + 1, 3 + 3, 0));
    // Once for all channels that are reflected totally together.
    let steeper = Ray::new(Vector::new(0.0, 0.9, 0.0), Vector::new(0.1, 0.1, -0.05));
    assert_eq!(trace(0, &steeper).1.total_internal, 0);
    let flat = Ray::new(Vector::new(0.0, 0.0, 0.0), Vector::new(0.7, 0.71, 0.69));
    let (light, counts) = trace(0, &flat);
    assert_eq!((counts.total_internal, counts.reflected), (1, 0));
    assert!(light.iter().all(|channel| *channel > 0.0));
}

/// The channels of a picture with dispersion are those of three pictures without, one for each index.
#[test]
fn pictures_are_those_of_the_three_indices() {
    let checker = Pattern::Checker {
        even: Rgb::new(0.9, 0.8, 0.7),
        odd: Rgb::new(0.2, 0.1, 0.3),
        u: Vec3::new(1.0, 0.0, 0.0),
        v: Vec3::new(0.0, 0.0, 1.0),
    };
    let floor = Object::new(
        Shape::plane(Vec3::new(0.0, -1.2, 0.0), UP),
        Material::patterned(checker).with_shares(0.25, 0.0, 0.75),
    );
    let film = Film::new(1.4, 350.0).with_spectrum(Spectrum::Wavelengths);
    let scene = |media: [Medium<f32>; 2], picture: &mut dyn FnMut(&Scene<'_, f32>)| {
        let shiny = Material::matte(Rgb::grey(0.5)).with_highlight(Rgb::grey(0.5), 20);
        let objects = [
            floor,
            Object::new(Shape::sphere(Vec3::new(-0.6, 0.0, 0.0), 0.9), Material::transparent(media[0]))
                .without_shadow(),
            Object::new(
                Shape::axis_box(Vec3::new(0.4, -1.0, 0.2), Vec3::new(1.3, 0.3, 1.1)),
                Material::transparent(media[1]).with_priority(3).with_film(film),
            )
            .with_tinted_shadow(),
            Object::new(
                Shape::cone(Vec3::new(-0.2, -0.5, 0.6), 0.5, Vec3::new(0.7, 0.3, 0.7), 0.3).capped(),
                Material::transparent(media[0]).with_priority(2),
            )
            .with_tinted_shadow(),
            Object::new(Shape::sphere(Vec3::new(0.9, -0.4, 0.6), 0.2), shiny.with_coat(1.75)),
        ];
        let lights = [Light::point(Vec3::new(3.0, 5.0, 4.0), Rgb::new(0.9, 0.8, 0.7))];
        picture(&Scene::new(CAMERA, DAYLIGHT).with_objects(&objects).with_lights(&lights));
    };
    let settings = Settings { termination: Termination::Color([0.5; 3]), ..Settings::new(48, 36, 6) };
    let draw = |media| {
        let mut drawn = Vec::new();
        scene(media, &mut |scene| drawn = render(scene, &settings, &Samples::CENTRE).0);
        drawn
    };
    let fading = Rgb::new(0.2, 0.5, 0.9);
    let flint = Rgb::new(1.6, 1.62, 1.65);
    let both = [Medium::dispersive(flint), GLASS].map(|medium| medium.with_attenuation(fading));
    let dispersed = draw(both);
    let mut expected = vec![[0.0; 3]; dispersed.len()];
    for (i, flint) in [flint.r, flint.g, flint.b].into_iter().enumerate() {
        let single = draw([flint, INDICES[i]].map(|index| Medium::new(index).with_attenuation(fading)));
        for (expected, single) in expected.iter_mut().zip(single) {
            expected[i] = single[i];
        }
    }
    let difference = Difference::between(&dispersed, &expected);
    assert!(difference.max < 1e-12, "{difference}");
    let green = draw([flint.g, INDICES[1]].map(|index| Medium::new(index).with_attenuation(fading)));
    assert!(Difference::between(&dispersed, &green).share_over_1_255 > 0.1);
}
