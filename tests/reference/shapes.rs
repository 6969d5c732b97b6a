//! Where a ray meets a primitive.
//!
//! A ray that leaves a surface knows the part of the surface that it starts on. A flat part cannot be met again; on a
//! round part the equation of the meeting loses its constant term, so one root is 0 and the other one is exact.

use whit::scene::{Cone, Object, Shape};

use super::cone;
use super::vector::Vector;

/// A half line.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: Vector,
    /// Of length 1.
    pub direction: Vector,
    /// What it starts on: nothing for an eye ray.
    pub left: Option<Surface>,
    /// Meetings up to this distance are the surface that the ray leaves, met again by rounding.
    pub skip: f64,
}

impl Ray {
    /// A ray from the middle of nowhere.
    pub fn new(origin: Vector, direction: Vector) -> Self {
        Self { origin, direction: direction.normalized(), left: None, skip: 0.0 }
    }

    pub fn at(&self, distance: f64) -> Vector {
        self.origin + self.direction * distance
    }
}

/// A part of a primitive: 0 unless the primitive has edges or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    pub primitive: usize,
    pub part: usize,
}

/// Where a line meets a primitive.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// May be negative.
    pub distance: f64,
    /// Geometric normal of length 1, pointing out.
    pub outward: Vector,
    /// Normal for shading, of length 1, pointing out.
    pub smooth: Vector,
    pub part: usize,
}

impl Meeting {
    pub fn new(distance: f64, outward: Vector, part: usize) -> Self {
        Self { distance, outward, smooth: outward, part }
    }
}

/// What is met as one piece.
#[derive(Clone, Copy, Debug)]
pub enum Primitive {
    Sphere { center: Vector, radius: f64 },
    Plane { point: Vector, normal: Vector },
    Disc { center: Vector, normal: Vector, radius: f64 },
    Annulus { center: Vector, normal: Vector, inner: f64, outer: f64 },
    Box { min: Vector, max: Vector },
    Triangle { vertices: [Vector; 3], normals: Option<[Vector; 3]> },
    Cone(Cone<f32>),
}

impl Primitive {
    /// The primitives of an object, in order.
    pub fn all(object: &Object<'_, f32>) -> Vec<Self> {
        let sphere = |s: &whit::scene::Sphere<f32>| Self::Sphere { center: s.center.into(), radius: s.radius.into() };
        let triangle =
            |t: &whit::scene::Triangle<f32>| Self::Triangle { vertices: t.vertices.map(Vector::from), normals: None };
        match object.shape {
            Shape::Sphere(s) => vec![sphere(&s)],
            Shape::Spheres(list) => list.iter().map(|s| sphere(&s)).collect(),
            Shape::Triangle(t) => vec![triangle(&t)],
            Shape::Triangles(list) => list.iter().map(triangle).collect(),
            Shape::SmoothTriangle(t) => vec![Self::Triangle {
                vertices: t.vertices.map(Vector::from),
                normals: Some(t.normals.map(|n| Vector::from(n).normalized())),
            }],
            Shape::Plane(p) => {
                vec![Self::Plane { point: p.point.into(), normal: Vector::from(p.normal).normalized() }]
            }
            Shape::Disc(d) => vec![Self::Disc {
                center: d.center.into(),
                normal: Vector::from(d.normal).normalized(),
                radius: d.radius.into(),
            }],
            Shape::Annulus(a) => vec![Self::Annulus {
                center: a.center.into(),
                normal: Vector::from(a.normal).normalized(),
                inner: a.inner.into(),
                outer: a.outer.into(),
            }],
            Shape::Box(b) => vec![Self::Box { min: b.min.into(), max: b.max.into() }],
            Shape::Cone(c) => vec![Self::Cone(c)],
        }
    }

    /// Every meeting of the whole line with the primitive. `own` is the part that the ray starts on.
    pub fn meet(&self, ray: &Ray, own: Option<usize>, found: &mut impl FnMut(Meeting)) {
        match self {
            Self::Sphere { center, radius } => sphere(*center, *radius, ray, own, found),
            Self::Plane { point, normal } => {
                if let (Some(distance), None) = (flat(*point, *normal, ray), own) {
                    found(Meeting::new(distance, *normal, 0));
                }
            }
            Self::Disc { center, normal, radius } => disc(*center, *normal, *radius, 0, ray, own, found),
            Self::Annulus { center, normal, inner, outer } => {
                disc(*center, *normal, *outer, 0, ray, own, &mut |meeting| {
                    if (ray.at(meeting.distance) - *center).length() >= *inner {
                        found(meeting);
                    }
                });
            }
            Self::Box { min, max } => axis_box(*min, *max, ray, own, found),
            Self::Triangle { vertices, normals } => {
                if own.is_none() {
                    triangle(vertices, normals, ray, found);
                }
            }
            Self::Cone(shape) => cone::meet(shape, ray, own, found),
        }
    }
}

/// |o + t·d − c|² = r²: with a = (c − o)·d and the vector e from the line to the centre, t = a ± √(r² − e²).
fn sphere(center: Vector, radius: f64, ray: &Ray, own: Option<usize>, found: &mut impl FnMut(Meeting)) {
    let to_center = center - ray.origin;
    let along = to_center.dot(ray.direction);
    let mut at =
        |distance| found(Meeting::new(distance, (ray.at(distance) - center).normalized() * radius.signum(), 0));
    if own.is_some() {
        return at(2.0 * along);
    }
    let across = to_center - ray.direction * along;
    let square = radius * radius - across.dot(across);
    if square >= 0.0 {
        at(along - square.sqrt());
        at(along + square.sqrt());
    }
}

/// (o + t·d − p)·n = 0
fn flat(point: Vector, normal: Vector, ray: &Ray) -> Option<f64> {
    let cosine = ray.direction.dot(normal);
    (cosine != 0.0).then(|| (point - ray.origin).dot(normal) / cosine)
}

/// The part of a plane within a radius.
pub fn disc(
    center: Vector,
    normal: Vector,
    radius: f64,
    part: usize,
    ray: &Ray,
    own: Option<usize>,
    found: &mut impl FnMut(Meeting),
) {
    if own == Some(part) {
        return;
    }
    if let Some(distance) = flat(center, normal, ray) {
        if (ray.at(distance) - center).length() <= radius {
            found(Meeting::new(distance, normal, part));
        }
    }
}

/// The line is inside between the last of the three planes it enters by and the first it leaves by. Part 2·axis is
/// the face at `min`, the next one the face at `max`.
fn axis_box(min: Vector, max: Vector, ray: &Ray, own: Option<usize>, found: &mut impl FnMut(Meeting)) {
    let (mut enter, mut leave) = ((f64::NEG_INFINITY, 0), (f64::INFINITY, 0));
    let (origin, direction) = (ray.origin.axes(), ray.direction.axes());
    for axis in 0..3 {
        let (o, d, low, high) = (origin[axis], direction[axis], min.axes()[axis], max.axes()[axis]);
        let (low, high) = ((low - o, 2 * axis), (high - o, 2 * axis + 1));
        if d == 0.0 {
            if low.0 > 0.0 || high.0 < 0.0 {
                return;
            }
            continue;
        }
        let (first, last) = if d > 0.0 { (low, high) } else { (high, low) };
        if first.0 / d > enter.0 {
            enter = (first.0 / d, first.1);
        }
        if last.0 / d < leave.0 {
            leave = (last.0 / d, last.1);
        }
    }
    if enter.0 > leave.0 {
        return;
    }
    for (distance, part) in [enter, leave] {
        let mut normal = [0.0; 3];
        normal[part / 2] = if part % 2 == 0 { -1.0 } else { 1.0 };
        if own != Some(part) {
            let [x, y, z] = normal;
            found(Meeting::new(distance, Vector::new(x, y, z), part));
        }
    }
}

/// T. Möller and B. Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997. The edges belong to the triangle,
/// with room for rounding, so that a line through the edge between two triangles meets one of them.
fn triangle(vertices: &[Vector; 3], normals: &Option<[Vector; 3]>, ray: &Ray, found: &mut impl FnMut(Meeting)) {
    const ROUNDING: f64 = 1e-12;
    let [a, b, c] = *vertices;
    let (edge_b, edge_c) = (b - a, c - a);
    let p = ray.direction.cross(edge_c);
    let determinant = edge_b.dot(p);
    if determinant == 0.0 {
        return;
    }
    let from_a = ray.origin - a;
    let share_b = from_a.dot(p) / determinant;
    let q = from_a.cross(edge_b);
    let share_c = ray.direction.dot(q) / determinant;
    let share_a = 1.0 - share_b - share_c;
    if share_a < -ROUNDING || share_b < -ROUNDING || share_c < -ROUNDING {
        return;
    }
    let outward = edge_b.cross(edge_c).normalized();
    let mut meeting = Meeting::new(edge_c.dot(q) / determinant, outward, 0);
    if let Some([na, nb, nc]) = *normals {
        let sum = na * share_a + nb * share_b + nc * share_c;
        if sum.length() > 0.0 {
            meeting.smooth = sum.normalized();
        }
    }
    found(meeting);
}
