//! Interfaces at their ends: grazing light, equal media, very different media.

use rayon::prelude::*;
use whit::optics::{fresnel_conductor, fresnel_dielectric, refract, schlick_dielectric};
use whit::scene::Medium;
use whit::{Background, Fresnel, Interface, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::exact::fresnel;
use crate::naive::schlick_incident;
use crate::support::{Alone, Random, UP, cross, double, plus, scene, shoot, single, unit};

/// What a ray hardly touches is seen like a mirror, whatever it is made of.
#[test]
fn grazing_light_is_reflected() {
    for cosine in [0.0, 1e-45, 1e-40, f32::MIN_POSITIVE, 1e-30, 1e-20, 1e-15, 1e-12] {
        for (n1, n2) in [(1.0, 1.000_000_1), (1.0, 1.5), (1.333, 1.5), (1.0, 1e3), (1e-3, 1.0), (1e-3, 1e3)] {
            let (polarized, behind) = fresnel_dielectric(n1, n2, cosine).unwrap();
            let [s, p, expected] = fresnel(n1, n2, cosine).unwrap();
            let error = (f64::from(polarized.s) - s).abs().max((f64::from(polarized.p) - p).abs());
            assert!(error < 1e-6, "{n1} {n2} {cosine:e}: {polarized:?} {s} {p}");
            // Where the indices are next to each other, so are the roundings of their ratio.
            assert!((f64::from(behind) - expected).abs() < 1e-6, "{n1} {n2} {cosine:e}: {behind} {expected}");
            assert_eq!(fresnel_dielectric(n2, n1, cosine), None, "{n2} {n1} {cosine:e}");
        }
        for (index, extinction) in [(0.2, 3.0), (1.5, 0.0), (1e-3, 1e3), (1e3, 1e3)] {
            let polarized = fresnel_conductor(index, extinction, cosine);
            assert!((polarized.mean() - 1.0).abs() < 1e-6, "{index} + {extinction}i at {cosine:e}: {polarized:?}");
        }
    }
}

/// Light goes on in the same direction, to the bit, and none of it is reflected.
#[test]
fn equal_media_do_not_bend_light() {
    let mut random = Random::new(64);
    for _ in 0..200_000 {
        let [incident, normal] = [1.0; 2].map(|_: f64| single(random.direction()).normalized());
        let normal = if normal.dot(incident) > 0.0 { -normal } else { normal };
        let (n, cosine) = (10_f64.powf(random.between(-3.0, 3.0)) as f32, (-normal.dot(incident)).min(1.0));
        let (polarized, behind) = fresnel_dielectric(n, n, cosine).unwrap();
        assert_eq!([polarized.s, polarized.p, behind], [0.0, 0.0, cosine]);
        let direction = refract(incident, normal, n / n, cosine, behind);
        assert_eq!(direction, incident);
        // The tracer normalises directions, which may round the last bit of one that is as good already.
        let [a, b] = [direction.normalized(), direction].map(double);
        assert!((0..3).all(|i| (a[i] - b[i]).abs() <= f64::from(f32::EPSILON)));
    }
}

/// Rays that pass through or by a place, from all around.
fn rays(count: u64, seed: u64) -> impl Iterator<Item = Ray<f32>> {
    let mut random = Random::new(seed);
    (0..count).map(move |_| {
        let origin = single(plus([0.0; 3], 3.0, random.direction()));
        let target = single(plus([0.1, 0.2, 0.3], random.between(0.0, 0.71), random.direction()));
        Ray { origin, direction: (target - origin).normalized() }
    })
}

/// A thing of the same index as what is around it has the colours of the background: all bits where they are the same
/// everywhere, and all but the last where they depend on the direction.
#[test]
fn equal_media_are_invisible() {
    let solid = Background::Solid(Rgb::new(0.3, 0.1, 0.7));
    let gradient = Background::Gradient { below: Rgb::new(0.1, 0.2, 0.9), above: Rgb::new(0.7, 0.3, 0.2), up: UP };
    let shapes = [
        Shape::sphere(Vec3::new(0.1, 0.2, 0.3), 0.7),
        Shape::axis_box(Vec3::splat(-0.5), Vec3::splat(0.6)),
        Shape::cone(Vec3::new(-0.2, -0.7, 0.0), 0.8, Vec3::new(0.1, 0.8, 0.2), 0.3).capped(),
    ];
    for index in [1e-3, 0.7, 1.0, 1.333, 1e3] {
        for shape in shapes {
            for (background, tolerance) in [(solid, 0.0), (gradient, f32::EPSILON)] {
                let objects = [Object::new(shape, Material::dielectric(index))];
                let empty = scene(background).with_medium(Medium::new(index));
                let full = empty.with_objects(&objects);
                let [empty, full] = [&empty, &full].map(|scene| Alone::try_new(scene).unwrap());
                let mut met = 0;
                for ray in rays(3000, 65) {
                    let ((found, stats), (expected, _)) = (shoot(&full, ray, 5), shoot(&empty, ray, 5));
                    let error = found.zip(expected, |a, b| (a - b).abs()).max_channel();
                    assert!(error <= tolerance, "{index} {shape:?}: {found:?} {expected:?}");
                    assert_eq!(stats.reflected, 0);
                    met += stats.transmitted;
                }
                assert!(met > 2000, "{met}");
            }
        }
    }
}

/// Between media of any two indices that a scene may have, what is not reflected is transmitted: a ball is invisible in
/// a uniform light. Rays that are cut take the background, so every share counts.
#[test]
fn no_light_is_lost_between_very_different_media() {
    let indices = [1e-3_f32, 1e-2, 0.1, 0.5, 0.9, 1.0, 1.000_000_1, 1.1, 1.5, 3.0, 10.0, 100.0, 1e3];
    let pairs: Vec<_> = indices.iter().flat_map(|&n| indices.map(|m| (n, m))).collect();
    let worst = pairs.par_iter().map(|&(inside, outside)| {
        let objects = [Object::new(Shape::sphere(Vec3::new(0.1, 0.2, 0.3), 0.7), Material::dielectric(inside))];
        let scene = scene(Background::Solid(Rgb::WHITE)).with_objects(&objects).with_medium(Medium::new(outside));
        [Fresnel::Exact, Fresnel::Schlick].into_iter().fold(0.0_f32, |worst, fresnel| {
            let scene = scene.with_fresnel(fresnel);
            let tracer = Alone::try_new(&scene).unwrap();
            rays(400, 66).fold(worst, |worst, ray| {
                let light = shoot(&tracer, ray, 8).0;
                assert!(light.r.is_finite(), "{inside} in {outside}: {light:?}");
                worst.max((light.r - 1.0).abs())
            })
        })
    });
    let worst = worst.reduce(|| 0.0, f32::max);
    println!("{worst:e}");
    assert!(worst <= 2.0 * f32::EPSILON, "{worst:e}");
}

/// Light that passes a ball is turned by 2(θ₁ − θ₂), towards the axis by a denser one. The colour of the background shows
/// the direction. Inside an index n, a rounding of the cosine is n² of them outside.
#[test]
fn light_is_bent_as_snell_says() {
    let gradient = Background::Gradient { below: Rgb::BLACK, above: Rgb::WHITE, up: UP };
    let mut random = Random::new(68);
    for index in [1.000_000_1, 1.000_01, 1.01, 1.333, 1.5, 2.417, 10.0] {
        let medium = Medium::new(index);
        let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
        let ball = Material::dielectric(index).with_interface(clear);
        let objects = [Object::new(Shape::sphere(Vec3::ZERO, 1.0), ball)];
        let scene = scene(gradient).with_objects(&objects);
        let tracer = Alone::try_new(&scene).unwrap();
        let mut worst = 0.0_f64;
        for _ in 0..5000 {
            let along = random.direction();
            let across = unit(cross(along, random.direction()));
            let impact = random.between(0.0, 0.99);
            let origin = single(plus(plus([0.0; 3], impact, across), -2.0, along));
            let (light, stats) = shoot(&tracer, Ray { origin, direction: single(along) }, 3);
            assert_eq!(stats.transmitted, 2);
            let turn = 2.0 * (impact.asin() - (impact / f64::from(index)).asin());
            let out = plus(along.map(|x| x * turn.cos()), -turn.sin(), across);
            worst = worst.max((f64::from(light.r) - (1.0 + out[1]) / 2.0).abs());
        }
        let roundings = worst / (f64::from(f32::EPSILON) * f64::from(index).powi(2));
        println!("{index}: {worst:e}, {roundings:.1} n² roundings");
        assert!(roundings < 30.0, "{index}: {worst:e}");
    }
}

/// What each polarisation reflects and, by the angle behind, transmits, adds up to all of it.
#[test]
fn what_is_not_reflected_is_transmitted() {
    let mut random = Random::new(67);
    let mut worst = 0.0_f64;
    for i in 0..300_000 {
        let n1 = 10_f64.powf(random.between(-3.0, 3.0)) as f32;
        let n2 = 10_f64.powf(random.between(-3.0, 3.0)) as f32;
        let cosine = if i % 2 == 0 { random.unit() } else { 10_f64.powf(random.between(-20.0, 0.0)) } as f32;
        let Some((reflected, behind)) = fresnel_dielectric(n1, n2, cosine) else { continue };
        let [a, b, c1, c2] = [n1, n2, cosine, behind].map(f64::from);
        let through = |sum: f64| 4.0 * a * c1 * b * c2 / (sum * sum);
        let s = f64::from(reflected.s) + through(a * c1 + b * c2) - 1.0;
        let p = f64::from(reflected.p) + through(b * c1 + a * c2) - 1.0;
        worst = worst.max(s.abs()).max(p.abs());
    }
    println!("{worst:e}");
    assert!(worst < 2e-6, "{worst:e}");
}

/// The largest error of an approximation of the reflectance between a vacuum and glass, on both sides.
fn worst_of_schlick(reflectance: impl Fn(f32, f32, f32) -> f32) -> f64 {
    let sides = [(1.0, 1.5), (1.5, 1.0)].into_iter();
    let all = sides.flat_map(|(n1, n2)| (1..=100_000).map(move |i| (n1, n2, i as f32 * 1e-5)));
    all.filter_map(|(n1, n2, c)| Some((f64::from(reflectance(n1, n2, c)), fresnel(n1, n2, c)?)))
        .fold(0.0, |worst, (found, [s, p, _])| worst.max((found - f64::midpoint(s, p)).abs()))
}

/// Leaving glass, the angle of incidence is the wrong one.
#[test]
fn schlick_at_the_angle_of_incidence_is_wrong_inside_glass() {
    let worst = worst_of_schlick(schlick_incident::schlick);
    println!("{worst}");
    assert!(worst > 0.9, "{worst}");
}

#[test]
fn schlick_is_near_fresnel_on_both_sides_of_glass() {
    let worst = worst_of_schlick(|n1, n2, c| schlick_dielectric(n1, n2, c).map_or(1.0, |(r, _)| r));
    println!("{worst}");
    assert!(worst < 0.036, "{worst}");
}
