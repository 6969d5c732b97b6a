//! Spheres whose discriminant cancels, against exact roots.

use whit::{Ray, Shape, Vec3};

use crate::leaving::with_tracer;
use crate::naive::quadratic;

/// A ray, a sphere and the exact roots of their `f32` numbers.
struct Row {
    kind: &'static str,
    ray: Ray<f32>,
    center: Vec3<f32>,
    radius: f32,
    roots: Option<[f64; 2]>,
}

fn rows() -> impl Iterator<Item = Row> {
    include_str!("../data/oracles/sphere_hard.csv").lines().skip(1).map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let single = |i: usize| f32::from_bits(u32::from_str_radix(fields[i], 16).unwrap());
        let vector = |i| Vec3::new(single(i), single(i + 1), single(i + 2));
        let roots = fields[11].parse().and_then(|near| fields[12].parse().map(|far| [near, far])).ok();
        let ray = Ray { origin: vector(1), direction: vector(4) };
        Row { kind: fields[0], ray, center: vector(7), radius: single(10), roots }
    })
}

/// The first root in front of the origin.
fn first<T: Copy + Default + PartialOrd>(roots: Option<[T; 2]>) -> Option<T> {
    roots?.into_iter().find(|t| *t > T::default())
}

/// How far a contact may be from the exact one, in roundings: of the distance to the sphere's centre across the surface,
/// so many times more along the ray as the ray is inclined to the surface.
pub const MOST_ROUNDINGS: f64 = 8.0;

fn most_error(row: &Row, t: f64) -> f64 {
    let at = |x: Vec3<f32>| x.map(f64::from);
    let (o, d, c) = (at(row.ray.origin), at(row.ray.direction), at(row.center));
    let from_center = o - c;
    let normal = from_center + d * t;
    let inclination = (normal.dot(d) / normal.length()).abs();
    let unit = f64::from(f32::EPSILON) / 2.0;
    // Where the exact discriminant is within its own rounding of zero, both roots count as one.
    MOST_ROUNDINGS * unit * (from_center.length() / inclination + t)
}

/// Each kind: wrong hits, wrong misses and wrong sides of the origin by `find`, and the largest error as a share of the
/// bound.
fn errors(find: impl Fn(&Row) -> Option<f32>) -> Vec<(&'static str, u32, f64)> {
    let mut kinds: Vec<(&'static str, u32, f64)> = Vec::new();
    for row in rows() {
        if kinds.last().is_none_or(|kind| kind.0 != row.kind) {
            kinds.push((row.kind, 0, 0.0));
        }
        let Some(kind) = kinds.last_mut() else { continue };
        match (find(&row).map(f64::from), first(row.roots)) {
            (None, None) => {}
            (Some(t), Some(exact)) => {
                kind.2 = kind.2.max((t - exact).abs() / most_error(&row, exact));
            }
            _ => kind.1 += 1,
        }
    }
    kinds
}

#[test]
fn textbook_roots_are_wrong() {
    let errors = errors(|row| first(quadratic::sphere(row.ray.origin, row.ray.direction, row.center, row.radius)));
    for (kind, wrong, worst) in &errors {
        println!("{kind:10} {wrong:3} wrong, {worst:.2e} of the bound");
    }
    let wrong: u32 = errors.iter().map(|kind| kind.1).sum();
    assert!(wrong > 50, "{wrong}");
}

#[test]
fn roots_are_right() {
    for (kind, wrong, worst) in errors(|row| {
        with_tracer(&[Shape::sphere(row.center, row.radius)], |tracer| Some(tracer.intersect(&row.ray)?.distance))
    }) {
        println!("{kind:10} {wrong} wrong, {worst:.2} of the bound");
        assert_eq!(wrong, 0, "{kind}");
        assert!(worst <= 1.0, "{kind}: {worst} of the bound");
    }
}
