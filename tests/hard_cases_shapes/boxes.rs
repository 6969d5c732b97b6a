//! Rays along faces and edges of boxes, through their corners, and with components that are zero or next to it.
//!
//! The bounds of a box belong to it: a ray in the plane of a face runs inside, one next to it misses. A ray that only
//! touches an edge or a corner meets it, if rounding does not part the distances. A component below 2⁻¹²⁸, whose
//! reciprocal is infinite, counts as zero.

use whit::{Intersection, Ray, Shape, Vec3};

use crate::exact::{ROUNDOFF, exact, nudged, ray_to};
use crate::naive::slab;
use crate::random::Random;
use crate::{Fault, assert_faultless, faults, meet};

/// How far rounding may move a face, in parts of its distance from the ray's origin along its axis: two distances, good
/// to 3 roundings each, are compared.
const TOLERANCE: f64 = 8.0 * ROUNDOFF;

/// 1/d overflows below it.
const SMALLEST: f64 = 1.0 / (1_u128 << 127) as f64 / 2.0;

#[derive(Clone, Copy, Debug)]
struct Bounds {
    min: Vec3<f32>,
    max: Vec3<f32>,
}

impl Bounds {
    fn shape(&self) -> Shape<'static, f32> {
        Shape::axis_box(self.min, self.max)
    }

    /// Whether the ray meets the box with all its faces moved outwards by so many parts of their distances, or inwards,
    /// where there is room. A face at distance 0 is not moved, nor are two that are one.
    fn is_met(&self, ray: &Ray<f32>, growth: f64) -> bool {
        let (o, d, min, max) = (exact(ray.origin), exact(ray.direction), exact(self.min), exact(self.max));
        // A line is a matter of luck.
        if growth < 0.0 && (0..3).filter(|&i| min[i] == max[i] && d[i].abs() >= SMALLEST).count() > 1 {
            return false;
        }
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..3 {
            let growth = if min[i] == max[i] { growth.max(0.0) } else { growth };
            let low = min[i] - growth * (min[i] - o[i]).abs();
            let high = max[i] + growth * (max[i] - o[i]).abs();
            if low > high {
                return false;
            }
            if d[i].abs() < SMALLEST {
                if o[i] < min[i] || o[i] > max[i] {
                    return false;
                }
                continue;
            }
            let (a, b) = ((low - o[i]) / d[i], (high - o[i]) / d[i]);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        enter <= leave && leave > 0.0
    }

    fn meet_naively(&self, ray: &Ray<f32>) -> bool {
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        slab::intersect(array(ray.origin), array(ray.direction), array(self.min), array(self.max)).is_some()
    }

    /// What is wrong about an answer, if anything is.
    fn judge(&self, ray: &Ray<f32>, is_met: bool) -> Option<&'static str> {
        match is_met {
            true if !self.is_met(ray, TOLERANCE) => Some("invented"),
            false if self.is_met(ray, -TOLERANCE) => Some("missed"),
            _ => None,
        }
    }
}

fn array(v: Vec3<f32>) -> [f32; 3] {
    [v.x, v.y, v.z]
}

const UNIT: Bounds = Bounds { min: Vec3::new(0.0, 0.0, 0.0), max: Vec3::new(1.0, 1.0, 1.0) };

/// Directions with zeros, before they are given signs.
const DIRECTIONS: [[f32; 3]; 13] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
    [0.6, 0.8, 0.0],
    [0.0, -0.6, 0.8],
    [-0.8, 0.0, -0.6],
    [0.8, 0.0, -0.6],
    [0.707_106_77, 0.0, 0.707_106_77],
    [-0.707_106_77, 0.707_106_77, 0.0],
    [0.0, 0.707_106_77, -0.707_106_77],
];

/// Origins outside, on faces, edges and corners, and inside.
fn origins() -> impl Iterator<Item = Vec3<f32>> {
    let places = [-1.0, -0.0, 0.0, 0.5, 1.0, 2.0];
    places
        .into_iter()
        .flat_map(move |x| places.into_iter().flat_map(move |y| places.into_iter().map(move |z| Vec3::new(x, y, z))))
}

/// The same direction with each choice of signs for its zeros.
fn signed_zeros(direction: [f32; 3]) -> impl Iterator<Item = Vec3<f32>> {
    (0..8).map(move |signs| {
        let signed = |i: usize| if direction[i] == 0.0 && signs >> i & 1 == 1 { -0.0 } else { direction[i] };
        Vec3::new(signed(0), signed(1), signed(2))
    })
}

/// All numbers of an answer; −0 is equal to 0 among them, and a coordinate below the normal numbers is 0.
fn numbers(hit: Option<Intersection<f32>>) -> Option<[f32; 8]> {
    hit.map(|hit| {
        let Intersection { distance, point, normal, from_outside, .. } = hit;
        let [x, y, z] = array(point).map(|x| if x.abs() < f32::MIN_POSITIVE { 0.0 } else { x });
        let [a, b, c] = array(normal);
        [distance, x, y, z, a, b, c, f32::from(from_outside)]
    })
}

#[test]
fn zeros_of_both_signs_give_the_same_answer() {
    let flat = Bounds { max: Vec3::new(1.0, 0.0, 1.0), ..UNIT };
    let mut naive_differs = 0;
    for bounds in [UNIT, flat] {
        for origin in origins() {
            for direction in DIRECTIONS {
                let rays = || signed_zeros(direction).map(|direction| Ray { origin, direction });
                let answers: Vec<_> = rays().map(|ray| numbers(meet(bounds.shape(), &ray))).collect();
                assert!(answers.iter().all(|answer| *answer == answers[0]), "{origin:?} {direction:?}: {answers:?}");
                let naive: Vec<_> = rays().map(|ray| bounds.meet_naively(&ray)).collect();
                naive_differs += u32::from(naive.iter().any(|answer| *answer != naive[0]));
            }
        }
    }
    println!("naive: the sign of a zero changes {naive_differs} answers");
    assert!(naive_differs > 0);
}

/// Through corners, along edges and in faces, with origins on all of them: no answer is off by any rounding.
#[test]
fn answers_on_a_grid_are_exact() {
    let flat = Bounds { max: Vec3::new(1.0, 0.0, 1.0), ..UNIT };
    let (mut met, mut naive_wrong) = (0, 0);
    for bounds in [UNIT, flat] {
        for origin in origins() {
            for direction in DIRECTIONS {
                let ray = Ray { origin, direction: Vec3::from(direction) };
                let (answer, expected) = (meet(bounds.shape(), &ray).is_some(), bounds.is_met(&ray, 0.0));
                assert_eq!(answer, expected, "{bounds:?} {ray:?}");
                met += u32::from(answer);
                naive_wrong += u32::from(bounds.meet_naively(&ray) != expected);
            }
        }
    }
    println!("met {met}; naive: {naive_wrong} wrong");
    assert!(met > 500 && naive_wrong > 0);
}

/// A ray in the plane of a face runs inside, up to the far edge; one step of `f32` away from it there is nothing.
#[test]
fn a_ray_in_a_face_runs_inside() {
    for face in [0.0_f32, 1.0] {
        let away = |steps: i32| if face == 0.0 { nudged(face, -steps) } else { nudged(face, steps) };
        let along = Vec3::new(0.0, 1.0, 0.0);
        let from_below = |x, z| meet(UNIT.shape(), &Ray { origin: Vec3::new(x, -1.0, z), direction: along });
        for (x, z) in [(face, 0.5), (0.5, face), (face, 0.0), (face, 1.0)] {
            let hit = from_below(x, z).unwrap();
            assert_eq!((hit.distance, hit.from_outside, hit.normal), (1.0, true, -along));
            let inside = meet(UNIT.shape(), &Ray { origin: Vec3::new(x, 0.25, z), direction: along }).unwrap();
            assert_eq!((inside.distance, inside.from_outside, inside.normal), (0.75, false, along));
            let behind = Ray { origin: Vec3::new(x, 1.0, z), direction: along };
            assert!(meet(UNIT.shape(), &behind).is_none());
        }
        assert!(from_below(away(1), 0.5).is_none() && from_below(0.5, away(1)).is_none());
        assert!(from_below(away(-1), 0.5).is_some() && from_below(0.5, away(-1)).is_some());
    }
}

/// A component so small that the ray does not leave the face by it over the whole box gives the answer of zero.
#[test]
fn subnormal_components_count_as_zero() {
    for origin in origins() {
        for direction in DIRECTIONS {
            let plain = numbers(meet(UNIT.shape(), &Ray { origin, direction: Vec3::from(direction) }));
            for tiny in [1e-45, 1e-42, 1e-40, 2.9e-39] {
                for signs in 0..8 {
                    let component = |i: usize| match (direction[i] == 0.0, signs >> i & 1) {
                        (true, 0) => tiny,
                        (true, _) => -tiny,
                        _ => direction[i],
                    };
                    let direction = Vec3::new(component(0), component(1), component(2));
                    let ray = Ray { origin, direction };
                    assert_eq!(numbers(meet(UNIT.shape(), &ray)), plain, "{ray:?}");
                }
            }
        }
    }
}

/// A random box with any of its sides flat.
fn random_box(random: &mut Random) -> Bounds {
    let size = random.decades(12.0);
    let place = if random.below(2) == 0 { random.decades(11.5) } else { size };
    let mut side = || {
        let (low, thickness) = (random.symmetric() * place, random.unit() * size * random.decades(2.0));
        let thickness = if random.below(8) == 0 { 0.0 } else { thickness };
        (low.min(1e11) as f32, (low + thickness).min(1e12) as f32)
    };
    let ((x, a), (y, b), (z, c)) = (side(), side(), side());
    Bounds { min: Vec3::new(x, y, z), max: Vec3::new(a, b, c) }
}

/// An origin on or next to the planes of the faces, between them or away, and a direction towards corners and edges,
/// with zeros and numbers next to zero.
fn random_ray(random: &mut Random, bounds: &Bounds) -> Ray<f32> {
    let (min, max) = (array(bounds.min), array(bounds.max));
    let size = (0..3).map(|i| f64::from(max[i]) - f64::from(min[i])).fold(1e-12, f64::max);
    let mut place = |far: bool| {
        let mut coordinate = |i: usize| match random.below(if far { 5 } else { 3 }) {
            0 => min[i],
            1 => max[i],
            2 => min[i] + (max[i] - min[i]) * random.unit() as f32,
            3 => nudged(min[i], random.below(3) as i32 - 1),
            _ => (f64::from(max[i]) + random.symmetric() * size * random.decades(3.0)).clamp(-1e12, 1e12) as f32,
        };
        Vec3::new(coordinate(0), coordinate(1), coordinate(2))
    };
    let (origin, target) = (place(true), exact(place(false)));
    let mut ray = ray_to(origin, target);
    if !ray.direction.x.is_finite() {
        ray.direction = Vec3::new(0.0, 0.6, -0.8);
    }
    let mut direction = array(ray.direction);
    for component in &mut direction {
        match random.below(12) {
            0 => *component = 0.0,
            1 => *component = -0.0,
            2 => *component = random.signed_decades(3.5) as f32 * 1e-41,
            3 => *component = nudged(*component, random.below(5) as i32 - 2),
            _ => {}
        }
    }
    let length = direction.map(|x| f64::from(x) * f64::from(x)).iter().sum::<f64>().sqrt();
    if length > 1e-6 {
        direction = direction.map(|x| (f64::from(x) / length) as f32)
    } else {
        direction[0] = 1.0
    };
    Ray { origin: ray.origin, direction: Vec3::from(direction) }
}

/// Nothing is missed and nothing is invented, but for what comes as near to an edge as rounding moves it.
#[test]
fn hits_are_those_of_exact_arithmetic() {
    let round = |round| {
        let mut random = Random::new(1, round);
        let bounds = random_box(&mut random);
        let rays: Vec<_> = (0..100).map(|_| random_ray(&mut random, &bounds)).collect();
        (bounds, rays)
    };
    assert_faultless(4000, |number| {
        let (bounds, rays) = round(number);
        let judge = |ray: &Ray<f32>| {
            let hit = meet(bounds.shape(), ray);
            let verdict = bounds.judge(ray, hit.is_some()).or_else(|| misplaced(&bounds, ray, &hit?));
            verdict.map(|verdict| format!("{verdict}: {bounds:?} {ray:?} {hit:?}"))
        };
        rays.iter().filter_map(judge).collect()
    });
    let (_, naive) = faults(4000, |number| {
        let (bounds, rays) = round(number);
        let is_flat = (0..3).any(|i| array(bounds.min)[i] == array(bounds.max)[i]);
        let judge = |ray: &Ray<f32>| bounds.judge(ray, bounds.meet_naively(ray)).map(Fault::from);
        rays.iter().filter(|_| !is_flat).filter_map(judge).collect()
    });
    println!("naive: {naive} wrong for boxes that are not flat");
    assert!(naive > 0);
}

/// A point that is not on the face that its normal tells, or not within the box.
fn misplaced(bounds: &Bounds, ray: &Ray<f32>, hit: &Intersection<f32>) -> Option<&'static str> {
    let (point, normal, origin) = (exact(hit.point), exact(hit.normal), exact(ray.origin));
    let (min, max) = (exact(bounds.min), exact(bounds.max));
    for i in 0..3 {
        let face = if normal[i] < 0.0 { min[i] } else { max[i] };
        if normal[i] != 0.0 && point[i] != face {
            return Some("off its face");
        }
        // 3 roundings of the distance, and 2 more on the way along the ray.
        let room =
            TOLERANCE * (point[i] - origin[i]).abs() + 2.0 * ROUNDOFF * point[i].abs() + f64::from(f32::MIN_POSITIVE);
        if point[i] < min[i] - room || point[i] > max[i] + room {
            return Some("off the box");
        }
    }
    let inwards = (0..3).map(|i| normal[i] * f64::from(array(ray.direction)[i])).sum::<f64>();
    ((inwards < 0.0) != hit.from_outside).then_some("on the wrong side")
}

/// A box without thickness is met from both sides, wherever it lies.
#[test]
fn flat_boxes_are_met_from_both_sides() {
    let mut naive_misses = 0;
    for height in [0.0_f32, 1.0, -0.3, 1e-12, 1e12] {
        let size = height.abs().clamp(1e-12, 1e11);
        let bounds = Bounds { min: Vec3::new(-size, height, -size), max: Vec3::new(size, height, size) };
        for (from, x, z) in [(3.0, 0.4, -0.7), (-3.0, 0.0, 0.3), (3.0, 0.0, 0.0), (-0.5, 0.99, 0.99)] {
            let start = f64::from(height) + from * f64::from(size);
            let origin = Vec3::new(0.1 * size, start as f32, -0.2 * size);
            let ray = ray_to(origin, [x * f64::from(size), f64::from(height), z * f64::from(size)]);
            let hit = meet(bounds.shape(), &ray).unwrap();
            assert!(hit.from_outside && hit.point.y == height && hit.normal.y == from.signum() as f32, "{hit:?}");
            let on = hit.leave(ray.direction);
            assert!(meet(bounds.shape(), &on).is_none(), "{hit:?} {on:?}");
            naive_misses += u32::from(!bounds.meet_naively(&ray));
        }
    }
    println!("naive: {naive_misses} of 20 missed");
    assert!(naive_misses > 0);
}
