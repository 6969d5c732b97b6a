//! Spheres from a millimetre to a planet, near and far, against `f64`.

use whit::{Intersection, Ray, Shape, Vec3};

use crate::cancellation::MOST_ROUNDINGS;
use crate::leaving::{unit_vector, with_tracer};
use crate::naive::quadratic;

const ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

/// A number between two others, evenly spread over the orders of magnitude.
fn magnitude(random: &mut fastrand::Rng, low: f32, high: f32) -> f32 {
    low * (high / low).powf(random.f32())
}

struct Case {
    ray: Ray<f32>,
    center: Vec3<f32>,
    radius: f32,
}

impl Case {
    /// A sphere, a ray that is aimed at some point of it, and all of it moved away from the origin by up to `away` radii.
    fn random(random: &mut fastrand::Rng, away: f32) -> Self {
        let radius = magnitude(random, 1e-3, 1e6);
        let distance = magnitude(random, 1e-2, 1e6);
        let center = unit_vector(random) * (radius * away * random.f32());
        let outwards = unit_vector(random);
        let origin = center + outwards * (radius + distance);
        let mut target = unit_vector(random);
        if target.dot(outwards) < 0.0 {
            target = -target;
        }
        let direction = (center + target * radius - origin).normalized();
        Self { ray: Ray { origin, direction }, center, radius }
    }

    /// The distance of the line from the centre, and of its nearest place from the origin, along and across.
    fn line(&self) -> (f64, f64) {
        let (o, d, c) = self.numbers();
        let f = o - c;
        let along = -f.dot(d) / d.dot(d);
        ((f + d * along).length(), along)
    }

    fn numbers(&self) -> (Vec3<f64>, Vec3<f64>, Vec3<f64>) {
        (self.ray.origin.map(f64::from), self.ray.direction.map(f64::from), self.center.map(f64::from))
    }

    /// How far from the sphere the contact is, in roundings of the distance from the centre.
    fn roundings(&self, t: f32) -> f64 {
        let (o, d, c) = self.numbers();
        let off = (o + d * f64::from(t) - c).length() - f64::from(self.radius);
        off.abs() / (ROUNDOFF * (o - c).length())
    }

    /// Whether the ray meets the sphere; `None` where that changes within the bound on the radius.
    fn is_met(&self) -> Option<bool> {
        let (o, _, c) = self.numbers();
        let (across, along) = self.line();
        let (height, off) = ((o - c).length() - f64::from(self.radius), across - f64::from(self.radius));
        let bound = MOST_ROUNDINGS * ROUNDOFF * (o - c).length();
        let is_clear = off.abs() > bound && height.abs() > bound;
        is_clear.then_some(height < 0.0 || (off < 0.0 && along > 0.0))
    }
}

/// Whether the origins on both sides of a hit are really on both sides, by `f64` with the numbers as they are.
fn is_between_its_origins(case: &Case, hit: &Intersection<f32>) -> bool {
    let height = |direction| {
        let origin = hit.leave(direction).origin.map(f64::from);
        (origin - case.center.map(f64::from)).length() - f64::from(case.radius)
    };
    height(hit.normal) > 0.0 && height(-hit.normal) < 0.0
}

/// Hits and misses as they are, each contact on a sphere whose radius differs by at most the bound, and the origins of
/// the next rays on their sides.
#[test]
fn contacts_are_on_the_sphere() {
    let mut random = fastrand::Rng::with_seed(1);
    for away in [0.0, 1.0, 1e3, 1e5] {
        let (mut hits, mut worst, mut textbook) = (0, 0.0_f64, 0.0_f64);
        for _ in 0..100_000 {
            let case = Case::random(&mut random, away);
            let (ray, center, radius) = (&case.ray, case.center, case.radius);
            let hit = with_tracer(&[Shape::sphere(center, radius)], |tracer| tracer.intersect(ray));
            if let Some(is_met) = case.is_met() {
                assert_eq!(hit.is_some(), is_met, "{ray:?} {center:?} {radius}");
            }
            if let Some([near, _]) = quadratic::sphere(ray.origin, ray.direction, center, radius) {
                textbook = textbook.max(case.roundings(near));
            }
            let Some(hit) = hit else { continue };
            hits += 1;
            worst = worst.max(case.roundings(hit.distance));
            assert!(is_between_its_origins(&case, &hit), "{ray:?} {center:?} {radius} {hit:?}");
            let size = hit.point.abs();
            let largest = size.x.max(size.y).max(size.z);
            assert!(hit.offset.length() <= 40.0 * ROUNDOFF as f32 * largest, "{hit:?} of radius {radius}");
        }
        println!("{away:e} radii away: {hits} hits, within {worst:.2} roundings; textbook {textbook:.2e}");
        assert!(hits > 20_000 && worst <= MOST_ROUNDINGS, "{away}: {worst}");
        assert!(textbook > 1e3);
    }
}

/// The eye a little above a ground as large as a planet: the distance to it, although a rounding of the planet's radius
/// is about half a metre.
#[test]
fn the_ground_of_a_planet_is_flat() {
    for radius in [1e4_f32, 1e5, 6.371e6, 1e8] {
        let center = Vec3::new(0.0, -radius, 0.0);
        let mut random = fastrand::Rng::with_seed(3);
        let (mut worst, mut textbook) = (0.0_f64, 0.0_f64);
        for _ in 0..20_000 {
            let origin = Vec3::new(random.f32() * 3.0, magnitude(&mut random, 0.01, 1e-4 * radius), random.f32() * 3.0);
            let sideways = unit_vector(&mut random);
            let slope = magnitude(&mut random, 0.05, 1.0);
            let direction = Vec3::new(sideways.x, -slope, sideways.z).normalized();
            let hit =
                with_tracer(&[Shape::sphere(center, radius)], |tracer| tracer.intersect(&Ray { origin, direction }))
                    .unwrap();
            let exact = height_root(origin, direction, radius);
            worst = worst.max((f64::from(hit.distance) / exact - 1.0).abs());
            let [near, _] = quadratic::sphere(origin, direction, center, radius).unwrap_or([0.0; 2]);
            textbook = textbook.max((f64::from(near) / exact - 1.0).abs());
            // Across the ground, the origins of the next rays are as near as the coordinates allow.
            let size = hit.point.abs();
            assert!(hit.offset.length() <= 40.0 * ROUNDOFF as f32 * size.x.max(size.y).max(size.z).max(1e-7 * radius));
        }
        println!("radius {radius:e}: within {worst:.1e} of the distance; textbook {textbook:.1e}");
        assert!(worst < 2e-5, "radius {radius}: {worst}");
        assert!(textbook > 1e-2, "radius {radius}: {textbook}");
    }
}

/// The first root, with the ground's height worked out so that nothing cancels in `f64`.
fn height_root(origin: Vec3<f32>, direction: Vec3<f32>, radius: f32) -> f64 {
    let (o, d, r) = (origin.map(f64::from), direction.map(f64::from), f64::from(radius));
    let c = o.dot(o) + 2.0 * r * o.y;
    let b = -(o.dot(d) + r * d.y);
    c / (b + (b * b - d.dot(d) * c).sqrt())
}
