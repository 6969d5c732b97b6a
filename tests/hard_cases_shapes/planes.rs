//! Rays along planes and discs, and nearly so.
//!
//! A ray whose direction's scalar product with the normal is zero does not meet the plane, also where it runs in it.

use whit::{Intersection, Ray, Shape, Vec3};

use crate::exact::{ROUNDOFF, Vector, dot, exact, length, minus, nudged, plus, ray_to, rounded, times};
use crate::random::Random;
use crate::{assert_faultless, meet};

#[derive(Clone, Copy, Debug)]
struct Plane {
    point: Vec3<f32>,
    normal: Vec3<f32>,
}

impl Plane {
    fn shape(&self) -> Shape<'static, f32> {
        Shape::plane(self.point, self.normal)
    }

    /// Height of the ray's origin below the plane and its speed upwards, each with a bound on what rounding does to it
    /// in `f32`: 3 roundings of each product of a scalar product and one of each difference. Products that underflow
    /// lose half of the smallest number.
    fn approach(&self, ray: &Ray<f32>) -> [(f64, f64); 2] {
        let normal = exact(self.normal);
        let from = minus(exact(self.point), exact(ray.origin));
        [(from, 4.0), (exact(ray.direction), 3.0)].map(|(v, roundings)| {
            let size: f64 = (0..3).map(|i| (v[i] * normal[i]).abs()).sum();
            (dot(v, normal), roundings * 1.001 * ROUNDOFF * size + 1.5 * f64::from(f32::from_bits(1)))
        })
    }

    /// What is wrong about an answer, if anything is.
    fn judge(&self, ray: &Ray<f32>, hit: Option<&Intersection<f32>>) -> Option<&'static str> {
        let [(height, height_error), (speed, speed_error)] = self.approach(ray);
        let (is_far, is_steep) = (height.abs() > height_error, speed.abs() > speed_error);
        let is_met = height / speed > 0.0;
        let Some(hit) = hit else {
            // Light is followed to 2⁶⁰.
            let too_far = (height.abs() + height_error) / (speed.abs() - speed_error) > 60.0_f64.exp2();
            return (is_met && is_far && is_steep && !too_far).then_some("missed");
        };
        if is_far && is_steep && !is_met {
            return Some("invented");
        }
        if is_steep && hit.from_outside != (speed < 0.0) {
            return Some("on the wrong side");
        }
        let (low, high) = (height.abs() - height_error, height.abs() + height_error);
        let (slow, fast) = ((speed.abs() - speed_error).max(0.0), speed.abs() + speed_error);
        let distance = f64::from(hit.distance);
        let is_near =
            distance >= low / fast * (1.0 - 2.0 * ROUNDOFF) && distance <= high / slow * (1.0 + 2.0 * ROUNDOFF);
        (!is_near).then_some("at the wrong distance")
    }
}

/// Numbers of an answer, without the sign of zeros.
fn numbers(hit: Option<Intersection<f32>>) -> Option<(f32, Vec3<f32>, Vec3<f32>, bool)> {
    hit.map(|hit| (hit.distance, hit.point, hit.normal, hit.from_outside))
}

#[test]
fn zeros_of_both_signs_give_the_same_answer() {
    let places = [-1.0, -0.0, 0.0, 2.0];
    let mut met = 0;
    for height in [0.0, -0.0, 1.0] {
        for normal in [[0.0, 1.0, 0.0], [-0.0, 2.0, -0.0], [0.0, -0.5, 0.0]] {
            let plane = Plane { point: Vec3::new(0.0, height, -0.0), normal: Vec3::from(normal) };
            for place in places {
                let origin = Vec3::new(-0.0, place, 0.0);
                for (y, x) in [(0.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (0.6, -0.8), (-0.6, 0.8)] {
                    let answers = [0.0, -0.0].map(|zero| {
                        let signed = |v: f32| if v == 0.0 { zero } else { v };
                        let direction = Vec3::new(signed(x), signed(y), zero);
                        numbers(meet(plane.shape(), &Ray { origin, direction }))
                    });
                    assert_eq!(answers[0], answers[1], "{plane:?} {origin:?} {x} {y}");
                    let is_met = y != 0.0 && (height - place) / y > 0.0;
                    assert_eq!(answers[0].is_some(), is_met, "{plane:?} {origin:?} {x} {y}");
                    met += u32::from(is_met);
                }
            }
        }
    }
    assert!(met > 30);
}

/// In the plane, above it and below it, at every scale; for a disc as well.
#[test]
fn parallel_rays_meet_nothing() {
    for scale in [1e-12_f32, 1e-3, 1.0, 1e5, 1e12] {
        for height in [0.0, 1.0, -1.0, 0.3] {
            let (point, normal) = (Vec3::new(0.0, height * scale, 0.0), Vec3::new(0.0, scale.max(1e-11), 0.0));
            for level in [height * scale, nudged(height * scale, 1), nudged(height * scale, -1), 0.5 * scale] {
                for direction in [[1.0, 0.0, 0.0], [0.0, -0.0, -1.0], [0.6, -0.0, 0.8]] {
                    let ray = Ray { origin: Vec3::new(-scale, level, 0.0), direction: Vec3::from(direction) };
                    assert!(meet(Shape::plane(point, normal), &ray).is_none(), "{ray:?}");
                    assert!(meet(Shape::disc(point, normal, scale), &ray).is_none(), "{ray:?}");
                }
            }
        }
    }
}

/// A direction in the plane, as nearly as rounding allows, or turned out of it by so little.
fn grazing(random: &mut Random, normal: Vector) -> Vector {
    let across = random.in_cube();
    let along = minus(across, times(normal, dot(across, normal) / dot(normal, normal)));
    let tilt = match random.below(4) {
        0 => 0.0,
        1 => random.signed_decades(1.0) * 1e-7,
        _ => random.signed_decades(20.0) * 1e-21,
    };
    plus(along, times(normal, tilt * length(along) / length(normal)))
}

/// Also nearly along the plane, from points next to it, for planes and normals of any size.
#[test]
fn hits_are_those_of_exact_arithmetic() {
    assert_faultless(4000, |round| {
        let mut random = Random::new(2, round);
        let (place, size) = (random.decades(11.0), random.decades(11.0));
        let axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], random.direction()][random.below(4)];
        let plane = Plane { point: rounded(times(random.in_cube(), place)), normal: rounded(times(axis, size)) };
        let ray = |_| {
            let from = match random.below(3) {
                0 => times(random.in_cube(), place * random.decades(2.0).min(10.0)),
                _ => plus(exact(plane.point), times(grazing(&mut random, axis), place)),
            };
            let direction = match random.below(3) {
                0 => random.direction(),
                _ => grazing(&mut random, exact(plane.normal)),
            };
            let origin = rounded(from);
            let mut ray = ray_to(origin, plus(exact(origin), times(direction, place)));
            for component in [&mut ray.direction.x, &mut ray.direction.y, &mut ray.direction.z] {
                match random.below(20) {
                    0 => *component = (random.signed_decades(4.0) * 1e-41) as f32,
                    1 => *component = nudged(*component, 1),
                    _ => {}
                }
            }
            ray
        };
        let rays: Vec<_> = (0..100).map(ray).collect();
        let judge = |ray: &Ray<f32>| {
            let hit = meet(plane.shape(), ray);
            let verdict = plane.judge(ray, hit.as_ref()).or_else(|| misplaced(&plane, &hit?));
            verdict.map(|verdict| format!("{verdict}: {plane:?} {ray:?} {hit:?} {:?}", plane.approach(ray)))
        };
        rays.iter().filter_map(judge).collect()
    });
}

/// A point that is farther from the plane than its offset, where it is within the range of coordinates.
fn misplaced(plane: &Plane, hit: &Intersection<f32>) -> Option<&'static str> {
    let normal = exact(plane.normal);
    let off = dot(minus(exact(hit.point), exact(plane.point)), normal).abs() / length(normal);
    (off > length(exact(hit.offset)) && hit.distance < 1e13).then_some("off the plane")
}
