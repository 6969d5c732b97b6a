//! Rays that leave a surface do not meet it again: the test of pbrt-v4 ("Reintersect"), with shapes over 16 decades of
//! size and place, rays in all directions and nearly along the surface.
//!
//! A flat shape must not be met at all. A solid must not be met by a ray that goes away from it; one that goes into it
//! must meet it from within, if it is closed. And each ray must start on the side that it goes to. Left out are rays so
//! nearly along the surface that the rounding of their direction decides on which side they go.

use std::fmt::Debug;

use whit::scene::{PackedSpheres, SmoothTriangle, Sphere, Triangle};
use whit::{Intersection, Ray, Shape, Vec3};

use crate::exact::{ROUNDOFF, Vector, dot, exact, length, plus, ray_to, rounded, times, unit};
use crate::meshes::Mesh;
use crate::random::Random;
use crate::solids::{depth, is_near_rim, size};
use crate::{Fault, Shapes, assert_faultless};

const SHAPES: u64 = 1000;
const RAYS_TO_EACH: usize = 10;
const RAYS_FROM_EACH: usize = 100;

/// Nearer than this part of its size to an edge of a solid, a ray may be taken for one on the other side of it.
const NEAR_EDGE: f64 = 64.0 * ROUNDOFF;

/// A ray that goes away, along a cone's side, comes this near to its tip far from where it started. Such a ray is
/// nearly parallel to the side, which costs the distance to the tip many digits.
const GRAZING: f64 = 1e-4;

#[derive(Clone, Copy, PartialEq)]
pub enum Form {
    /// What has two sides and no inside.
    Flat,
    /// What is closed.
    Solid,
    /// What has an inside, and no ends.
    Tube,
}

/// A ray to a place, from anywhere or from any distance.
fn look(random: &mut Random, target: Vector) -> Ray<f32> {
    let origin = match random.below(2) {
        0 => random.point_of_decades(8.0),
        _ => rounded(plus(target, times(random.direction(), (1e-6 + length(target)) * random.decades(4.0)))),
    };
    ray_to(origin, target)
}

/// A direction from a surface: any, or nearly along it to either side.
fn away(random: &mut Random, normal: Vec3<f32>) -> Vec3<f32> {
    let (any, normal) = (random.direction(), exact(normal));
    if random.below(2) == 0 {
        return rounded(any);
    }
    let along = plus(any, times(normal, -dot(any, normal)));
    let tilt = random.signed_decades(3.0) * 1e-4;
    rounded(unit(plus(unit(along), times(normal, tilt))))
}

/// Any direction, or along an axis.
pub fn across(random: &mut Random) -> Vector {
    match random.below(4) {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, -1.0, 0.0],
        _ => random.direction(),
    }
}

/// A shape, with what is expected of it.
struct Expected<'a> {
    shape: Shape<'a, f32>,
    form: Form,
    /// Whether its normals point inwards.
    is_inverted: bool,
}

impl Expected<'_> {
    fn depth_at(&self, place: Vector) -> f64 {
        depth(&self.shape, place)
    }

    /// What is wrong about a ray that left where `hit` is and what it then meets.
    fn judge(
        &self,
        hit: &Intersection<f32>,
        ray: &Ray<f32>,
        again: Option<&Intersection<f32>>,
    ) -> Option<&'static str> {
        let is_flat = self.form == Form::Flat;
        let goes_away = (ray.direction.dot(hit.normal) > 0.0) != self.is_inverted;
        let (depth, size) = (self.depth_at(exact(ray.origin)), length(exact(ray.origin)) + size(&self.shape));
        let doubt = 1e-14 * (size + depth.abs());
        if goes_away && depth > doubt || is_flat && !goes_away && depth < -doubt {
            return Some("starts on the wrong side");
        }
        if dot(exact(hit.normal), exact(ray.direction)).abs() < 4.0 * ROUNDOFF {
            return None;
        }
        let grazes = |again: &Intersection<f32>| {
            let place = plus(exact(ray.origin), times(exact(ray.direction), again.distance.into()));
            let is_elsewhere = again.distance > 1e3 * hit.offset.length();
            !is_flat && is_elsewhere && self.depth_at(place).abs() < GRAZING * size
        };
        match again {
            Some(again) if goes_away && grazes(again) => None,
            Some(_) if is_flat || goes_away => Some("meets it again"),
            _ if is_flat || goes_away || depth <= NEAR_EDGE * size => None,
            _ if is_near_rim(&self.shape, ray, NEAR_EDGE * size) => None,
            Some(again) if again.from_outside != self.is_inverted => Some("meets it from the wrong side"),
            None if self.form == Form::Solid => Some("gets out of it"),
            _ => None,
        }
    }

    /// Faults of rays that leave the shape where random rays to a place meet it.
    fn faults(&self, random: &mut Random, target: Vector) -> Vec<Fault> {
        Shapes::one(self.shape).with(|intersect| {
            let mut faults = Vec::new();
            for _ in 0..RAYS_TO_EACH {
                let first = look(random, target);
                let Some(hit) = intersect(&first) else { continue };
                for _ in 0..RAYS_FROM_EACH {
                    let ray = hit.leave(away(random, hit.normal));
                    let again = intersect(&ray);
                    if let Some(fault) = self.judge(&hit, &ray, again.as_ref()) {
                        faults.push(format!("{fault}: {:?}\n {first:?}\n {hit:?}\n {ray:?}\n {again:?}", self.shape));
                    }
                }
            }
            faults
        })
    }
}

/// Traces a million rays from random shapes: the primitives, and a place to look at.
pub fn assert_never_met_again<S: Debug>(
    (case, form, is_inverted): (u64, Form, bool),
    make: impl Fn(&mut Random) -> (S, Vector) + Sync,
    shape: impl for<'s> Fn(&'s S) -> Shape<'s, f32> + Sync,
) {
    assert_faultless(SHAPES, |round| {
        let mut random = Random::new(case, round);
        let (made, target) = make(&mut random);
        Expected { shape: shape(&made), form, is_inverted }.faults(&mut random, target)
    });
}

fn sphere(random: &mut Random, sign: f32) -> (Sphere<f32>, Vector) {
    let radius = random.decades(8.0);
    // No smaller than the steps of its centre's coordinates.
    let center = rounded(times(random.in_cube(), (radius * random.decades(5.0)).min(1e11)));
    let target = plus(exact(center), times(random.direction(), radius));
    (Sphere { center, radius: sign * radius as f32 }, target)
}

#[test]
fn spheres() {
    assert_never_met_again((20, Form::Solid, false), |random| sphere(random, 1.0), |s| Shape::Sphere(*s));
}

#[test]
fn inverted_spheres() {
    assert_never_met_again((21, Form::Solid, true), |random| sphere(random, -1.0), |s| Shape::Sphere(*s));
}

#[test]
fn packed_spheres() {
    let make = |random: &mut Random| {
        let (sphere, target) = sphere(random, 1.0);
        (PackedSpheres::<f32, 1, 1>::new(&[sphere]), target)
    };
    assert_never_met_again((22, Form::Solid, false), make, |packed| Shape::Spheres(packed.view()));
}

#[test]
fn boxes() {
    let make = |random: &mut Random| {
        let (low, mut place) = (exact(random.point_of_decades(8.0)), [0.0; 3]);
        let sides: Vector = std::array::from_fn(|_| random.decades(8.0));
        for i in 0..3 {
            place[i] = low[i] + random.unit() * sides[i];
        }
        let face = random.below(6);
        place[face / 2] = low[face / 2] + sides[face / 2] * (face % 2) as f64;
        (Shape::axis_box(rounded(low), rounded(plus(low, sides))), place)
    };
    assert_never_met_again((25, Form::Solid, false), make, |shape| *shape);
}

/// Corners of independent decades, or a triangle of one size somewhere; none that is thinner than some roundings of its
/// length, which is a line to `f32`.
fn triangle(random: &mut Random) -> ([Vec3<f32>; 3], Vector) {
    loop {
        let (vertices, target) = any_triangle(random);
        if thinness(&vertices) > 16.0 * ROUNDOFF {
            return (vertices, target);
        }
    }
}

/// The height over the longest edge as a share of it.
fn thinness(vertices: &[Vec3<f32>; 3]) -> f64 {
    let [a, b, c] = vertices.map(|v| v.map(f64::from));
    let longest = [b - a, c - b, a - c].map(Vec3::length_squared).into_iter().fold(0.0, f64::max);
    (b - a).cross(c - a).length() / longest
}

fn any_triangle(random: &mut Random) -> ([Vec3<f32>; 3], Vector) {
    let vertices: [Vec3<f32>; 3] = match random.below(2) {
        0 => std::array::from_fn(|_| random.point_of_decades(8.0)),
        _ => {
            let (center, size) = (exact(random.point_of_decades(8.0)), random.decades(8.0));
            std::array::from_fn(|_| rounded(plus(center, times(random.in_cube(), size))))
        }
    };
    (vertices, inside(&vertices, random))
}

fn inside(vertices: &[Vec3<f32>; 3], random: &mut Random) -> Vector {
    let weights = random.weights();
    (0..3).fold([0.0; 3], |sum, i| plus(sum, times(exact(vertices[i]), weights[i])))
}

#[test]
fn triangles() {
    assert_never_met_again((26, Form::Flat, false), triangle, |&[a, b, c]| Shape::triangle(a, b, c));
}

#[test]
fn smooth_triangles() {
    assert_never_met_again((27, Form::Flat, false), triangle, |&vertices| {
        let normal = rounded(crate::solids::normal(&vertices));
        let normal = if normal.length() > 1e-6 { normal.normalized() } else { Vec3::new(0.0, 0.0, 1.0) };
        Shape::SmoothTriangle(SmoothTriangle { vertices, normals: [normal; 3] })
    });
}

/// Two triangles of one plane: leaving one, a ray does not meet the other.
#[test]
fn quads() {
    let make = |random: &mut Random| {
        let size = random.decades(8.0);
        let corner = rounded(times(random.in_cube(), size * random.decades(3.0)));
        let (u, v) = (rounded(times(random.direction(), size)), rounded(times(random.direction(), size)));
        let [a, b, c, d] = [corner, corner + u, corner + u + v, corner + v];
        let quad = [Triangle { vertices: [a, b, c] }, Triangle { vertices: [a, c, d] }];
        let target = inside(&quad[random.below(2)].vertices, random);
        (quad, target)
    };
    assert_never_met_again((28, Form::Flat, false), make, |quad| Shape::Triangles(quad));
}

#[test]
fn convex_meshes() {
    let make = |random: &mut Random| {
        let size = random.decades(8.0);
        let sides = std::array::from_fn(|_| size * random.decades(0.3));
        let center = times(random.in_cube(), size * random.decades(2.0));
        let triangles = Mesh::icosahedron().placed(sides, center).triangles();
        let target = inside(&triangles[random.below(20)].vertices, random);
        (triangles, target)
    };
    assert_never_met_again((29, Form::Solid, false), make, |triangles| Shape::Triangles(triangles));
}
