//! The reference tracer's thin films, against tables and closed forms.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod reference;

use reference::complex::Complex;
use reference::film::{airy, reflectance, thickness};
use reference::fresnel::{conductor, dielectric};
use reference::shapes::Ray;
use reference::spectrum::{CHANNELS, daylight, interpolate};
use reference::vector::{Color, Vector};
use reference::world::World;
use reference::{Branch, Counts, Settings};
use whit::optics::Band;
use whit::scene::{Background, Camera, Film, Fresnel, Material, Medium, Object, Scene, Shape, Spectrum, Thickness};
use whit::{Rgb, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0);

/// The rows of a table after its head.
fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    table.lines().skip(1).map(|line| line.split(',').collect())
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?} within {tolerance:e}");
}

#[test]
fn films_reflect_as_in_the_table_of_wavelengths() {
    let mut seen = 0;
    for row in rows(include_str!("data/oracles/thinfilm_tmm.csv")) {
        let [n0, film, n, k, degrees, thickness, wavelength] = [1, 2, 3, 4, 5, 6, 7].map(|column| number(row[column]));
        let found = airy(n0, degrees.to_radians().cos(), film, thickness, Complex::new(n, k), wavelength);
        assert!((found - number(row[10])).abs() < 1e-12, "{row:?}: {found}");
        seen += 1;
    }
    assert_eq!(seen, 1008);
}

#[test]
fn films_have_the_colors_of_the_table() {
    let (mut seen, mut worst) = (0, 0.0_f64);
    for row in rows(include_str!("data/oracles/thinfilm_rgb.csv")) {
        let (film, base) = match row[0] {
            "soap air/1.33/air" => (1.33, Complex::ONE),
            "oil air/1.5/water" => (1.5, 1.33.into()),
            "coating air/1.38/glass" => (1.38, 1.52.into()),
            "air/1.5/metal(0.27+2.95i)" => (1.5, Complex::new(0.27, 2.95)),
            other => panic!("{other}"),
        };
        let cosine = number(row[1]).to_radians().cos();
        let film = Film::new(film, number(row[2]) as f32);
        let Color(found) = reflectance(&film, Vector::new(0.0, 0.0, 0.0), 1.0, cosine, [base; 3]);
        let expected = [3, 4, 5].map(|column| number(row[column]).clamp(0.0, 1.0));
        worst = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(worst, f64::max);
        seen += 1;
    }
    println!("off by {worst:.1e}");
    assert!(seen == 840 && worst < 1e-3, "{seen} {worst}");
}

/// λ/4 of index n between n₀ and n_s reflect ((n₀·n_s − n²)/(n₀·n_s + n²))² of light that falls straight on them; λ/2
/// change nothing.
#[test]
fn quarter_and_half_waves() {
    for (outer, film, base) in [(1.0, 1.38, 1.52), (1.0, 1.5_f64.sqrt(), 1.5), (1.33, 2.0, 1.0)] {
        let wave = 550.0 / film;
        let quarter = airy(outer, 1.0, film, 0.25 * wave, base.into(), 550.0);
        let ratio = (outer * base - film * film) / (outer * base + film * film);
        assert!((quarter - ratio * ratio).abs() < 1e-15);
        let half = airy(outer, 1.0, film, 0.5 * wave, base.into(), 550.0);
        assert!((half - dielectric(Fresnel::Exact, outer, base, 1.0)).abs() < 1e-15);
    }
}

#[test]
fn no_film_and_endless_film() {
    for degrees in [0.0_f64, 30.0, 60.0, 85.0] {
        let cosine = degrees.to_radians().cos();
        for film in [0.7, 1.2, 1.5, 2.0] {
            // A film without thickness is not there.
            let bare = dielectric(Fresnel::Exact, 1.2, 1.5, cosine);
            assert!((airy(1.2, cosine, film, 0.0, 1.5.into(), 500.0) - bare).abs() < 1e-14);
            let metal = Complex::new(0.3, 3.0);
            let bare = conductor(metal / 1.2.into(), cosine);
            assert!((airy(1.2, cosine, film, 0.0, metal, 500.0) - bare).abs() < 1e-14);
            // Nor is one of the index of what is behind it, or of what is in front of it over glass.
            let bare = dielectric(Fresnel::Exact, 1.2, film, cosine);
            assert!((airy(1.2, cosine, film, 345.0, film.into(), 500.0) - bare).abs() < 1e-14);
            // Glass behind any film reflects all light that cannot leave it.
            if 1.5 * cosine.mul_add(-cosine, 1.0).sqrt() > 1.0 {
                assert!((airy(1.5, cosine, film, 345.0, 1.0.into(), 500.0) - 1.0).abs() < 1e-13);
            }
        }
    }
    // What cannot propagate in a film reaches the other side through a thin one only.
    let through = |thickness| 1.0 - airy(1.5, 0.5, 1.0, thickness, 1.5.into(), 500.0);
    assert!((through(0.0) - 1.0).abs() < 1e-14 && through(100.0) > 0.05 && through(2000.0) < 1e-9);
}

#[test]
fn colors_of_wavelengths_and_bands() {
    const BANDS: &[Band] = &[
        Band { wavelength: 500.0, weight: Rgb::new(0.5, 0.25, 0.0) },
        Band { wavelength: 700.0, weight: Rgb::new(0.25, 0.5, -9.0) },
        Band { wavelength: 400.0, weight: Rgb::new(0.0, 0.125, 99.0) },
    ];
    let base = [Complex::new(1.0, 3.0), Complex::new(1.5, 2.0), Complex::new(2.5, 1.0)];
    let film = Film::new(1.25, 400.0);
    let color = |spectrum| {
        let film = film.with_spectrum(spectrum);
        reflectance(&film, Vector::new(0.0, 0.0, 0.0), 1.0, 0.75, base).0
    };
    let at = |wavelength, base| airy(1.0, 0.75, 1.25, 400.0, base, wavelength);
    close(color(Spectrum::Wavelengths), [0, 1, 2].map(|i| at(CHANNELS[i], base[i])), 1e-15);
    let t = (500.0 - 464.2) / (549.1 - 464.2);
    let [a, b, c] =
        [at(500.0, base[2] * (1.0 - t).into() + base[1] * t.into()), at(700.0, base[0]), at(400.0, base[2])];
    let red_and_green = [0.5 * a + 0.25 * b, 0.25 * a + 0.5 * b + 0.125 * c];
    assert!(99.0 * c - 9.0 * b > 1.0);
    close(color(Spectrum::Bands(BANDS)), [red_and_green[0], red_and_green[1], 1.0], 1e-14);
    assert_eq!(interpolate(base, 549.1), base[1]);
    // The table is a sum over bands too, of an even white.
    let white = daylight().iter().fold(Color::BLACK, |sum, &(_, weight)| sum + weight);
    close(white.0, [1.0; 3], 1e-13);
}

#[test]
fn thickness_by_place() {
    let point = |x, y, z| Vector::new(x, y, z);
    let gradient = Thickness::Gradient { from: 100.0, to: 500.0, origin: UP, axis: Vec3::new(0.0, 0.25, 0.0) };
    for (y, expected) in [(0.0, 100.0), (1.0, 100.0), (2.0, 200.0), (5.0, 500.0), (9.0, 500.0)] {
        assert_eq!(thickness(&gradient, point(3.0, y, -2.0)), expected);
    }
    let radial = Thickness::Radial { from: 500.0, to: 100.0, center: UP, radius: 2.0 };
    for (x, expected) in [(0.0, 500.0), (-0.5, 400.0), (1.0, 300.0), (2.0, 100.0), (7.0, 100.0)] {
        assert_eq!(thickness(&radial, point(x, 1.0, 0.0)), expected);
    }
}

/// The light that a ray finds, and the rays it took.
fn trace(scene: &Scene<'_, f32>, depth: u32, ray: &Ray) -> ([f64; 3], Counts) {
    let mut counts = Counts::default();
    let world = World::new(scene);
    (Branch::eye(&world, &Settings::new(1, 1, depth), &|_| [0.5; 2]).trace(ray, &mut counts).0, counts)
}

/// What a film does not reflect goes on; on total internal reflection there is no film.
#[test]
fn films_on_surfaces() {
    let above = Vec3::new(0.0, 1.0, 0.0);
    let sky = Background::Gradient { below: Rgb::BLACK, above: Rgb::WHITE, up: above };
    let film = Film::new(1.4, 300.0).with_spectrum(Spectrum::Wavelengths);
    let glass = [Object::new(Shape::plane(Vec3::ZERO, UP), Material::dielectric(1.5).with_film(film))];
    let scene = Scene::new(CAMERA, sky).with_objects(&glass).with_medium(Medium::new(1.25));
    let down = Ray::new(Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, -1.0, 0.0));
    let expected = CHANNELS.map(|wavelength| airy(1.25, 1.0, f64::from(1.4_f32), 300.0, 1.5.into(), wavelength));
    let (light, counts) = trace(&scene, 1, &down);
    close(light, expected, 1e-14);
    assert_eq!((counts.reflected, counts.transmitted), (1, 1));
    // From below the order of the media is the other way round.
    let up = Ray::new(Vector::new(0.0, -1.0, 0.0), Vector::new(0.0, 1.0, 0.0));
    close(trace(&scene, 1, &up).0, expected.map(|reflected| 1.0 - reflected), 1e-14);
    let flat = Ray::new(Vector::new(-2.0, -1.0, 0.0), Vector::new(2.0, 1.0, 0.0));
    let (light, counts) = trace(&scene, 1, &flat);
    close(light, [0.5 * (1.0 - 1.0 / 5.0_f64.sqrt()); 3], 1e-14);
    assert_eq!((counts.reflected, counts.transmitted, counts.total_internal), (1, 0, 1));
    // An oxide on a metal.
    let metal = Material::conductor(Rgb::new(0.5, 1.0, 1.5), Rgb::new(3.0, 2.0, 1.0)).with_film(film);
    let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), metal)];
    let expected = [0, 1, 2].map(|i| {
        let base = Complex::new([0.5, 1.0, 1.5][i], [3.0, 2.0, 1.0][i]);
        airy(1.25, 1.0, f64::from(1.4_f32), 300.0, base, CHANNELS[i])
    });
    let (light, counts) = trace(&scene.with_objects(&objects), 1, &down);
    close(light, expected, 1e-14);
    assert_eq!((counts.reflected, counts.transmitted), (1, 0));
}

#[test]
fn soap_bubbles_neither_make_nor_take_light() {
    for spectrum in [Spectrum::Wavelengths, Spectrum::Table] {
        let thickness = Thickness::Gradient { from: 0.0, to: 900.0, origin: Vec3::ZERO, axis: UP };
        let film = Film::new(1.33, 0.0).with_thickness(thickness).with_spectrum(spectrum);
        let objects = [1.0, 1.5]
            .map(|index| Object::new(Shape::sphere(Vec3::ZERO, 1.0), Material::dielectric(index).with_film(film)));
        for object in objects {
            let scene = Scene::new(CAMERA, Background::Solid(Rgb::WHITE)).with_objects(std::slice::from_ref(&object));
            for x in [-0.9, 0.0, 0.3, 0.75] {
                let ray = Ray::new(Vector::new(x, 0.25, 3.0), Vector::new(0.0, 0.0, -1.0));
                close(trace(&scene, 6, &ray).0, [1.0; 3], 1e-12);
            }
        }
    }
}
