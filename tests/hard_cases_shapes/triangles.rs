//! No ray gets through an edge or a corner that triangles share.
//!
//! The rays are aimed, in `f32`, at corners and at points of edges of closed meshes, and then turned by a few of the
//! smallest steps there are: from inside, every one must meet the mesh; from outside, every one that is aimed at a
//! place with no face seen from the side must meet it from outside.

use std::sync::atomic::{AtomicUsize, Ordering};

use whit::scene::Triangle;
use whit::{Intersection, Ray, Shape, Vec3};

use crate::exact::{ROUNDOFF, dot, exact, length, minus, nudged, plus, rounded, times, unit};
use crate::meshes::{Mesh, Seam};
use crate::naive::moller_trumbore;
use crate::random::Random;
use crate::{Shapes, assert_faultless, faults};

/// A mesh and its seams.
struct Target {
    name: &'static str,
    mesh: Mesh,
    is_convex: bool,
    triangles: Vec<Triangle<f32>>,
    seams: Vec<Seam>,
}

impl Target {
    fn new(name: &'static str, mesh: Mesh) -> Self {
        Self { name, triangles: mesh.triangles(), seams: mesh.seams(), is_convex: true, mesh }
    }

    /// A ray from a place towards a corner or a point of an edge; the faces around that.
    fn aim(&self, origin: Vec3<f32>, random: &mut Random) -> (Ray<f32>, &Seam) {
        let seam = &self.seams[random.below(self.seams.len())];
        let [a, b] = seam.ends.map(|i| self.mesh.vertices[i]);
        // The ends of an edge are seams of their own.
        let target = a + (b - a) * (0.001 + 0.998 * random.unit()) as f32;
        let mut direction = (target - origin).normalized();
        for component in [&mut direction.x, &mut direction.y, &mut direction.z] {
            *component = nudged(*component, random.below(5) as i32 - 2);
        }
        let direction = if random.below(2) == 0 { direction } else { (target - origin).normalized() };
        (Ray { origin, direction }, seam)
    }

    fn ray_from_inside(&self, random: &mut Random) -> Ray<f32> {
        let origin = self.mesh.inside(0.9, random);
        self.aim(origin, random).0
    }

    /// A ray from outside to a seam of which no face is seen from the side.
    fn ray_from_outside(&self, random: &mut Random) -> Option<Ray<f32>> {
        let away = times(random.direction(), self.mesh.radius() * (1.5 + random.decades(2.0)));
        let (ray, seam) = self.aim(rounded(plus(self.mesh.center, away)), random);
        let is_facing = |&face: &usize| {
            let normal = self.mesh.normal(face);
            dot(normal, exact(ray.direction)) < -1e-3 * length(normal)
        };
        let depth = self.depth(&ray);
        (seam.faces.iter().all(is_facing) && depth.is_none_or(|depth| depth > 0.0)).then_some(ray)
    }

    /// How far a ray goes through a convex mesh whose faces are moved inwards by what rounding does to the corners as
    /// the ray's origin sees them.
    fn depth(&self, ray: &Ray<f32>) -> Option<f64> {
        if !self.is_convex {
            return None;
        }
        let (origin, direction) = (exact(ray.origin), exact(ray.direction));
        let error = 8.0 * ROUNDOFF * (length(origin) + length(self.mesh.center) + self.mesh.radius());
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for face in 0..self.mesh.faces.len() {
            let normal = unit(self.mesh.normal(face));
            let corner = exact(self.mesh.vertices[self.mesh.faces[face][0]]);
            let (height, speed) = (dot(minus(origin, corner), normal) + error, dot(direction, normal));
            match speed {
                _ if speed < 0.0 => enter = enter.max(-height / speed),
                _ if speed > 0.0 => leave = leave.min(-height / speed),
                _ if height > 0.0 => return Some(0.0),
                _ => {}
            }
        }
        Some(leave - enter)
    }

    fn is_met_naively(&self, ray: &Ray<f32>) -> bool {
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        self.triangles.iter().any(|triangle| {
            let vertices = triangle.vertices.map(array);
            moller_trumbore::intersect(array(ray.origin), array(ray.direction), vertices).is_some_and(|t| t > 0.0)
        })
    }
}

/// Meshes of 4 to 20 triangles.
fn small() -> Vec<Target> {
    let far = [30_000.0, -7000.0, 11_000.0];
    let at = [0.3, -0.7, 1.1];
    vec![
        Target::new("tetrahedron", Mesh::tetrahedron()),
        Target::new("octahedron", Mesh::octahedron()),
        Target::new("cube", Mesh::cube()),
        Target::new("icosahedron", Mesh::icosahedron()),
        Target::new("icosahedron beside the origin", Mesh::icosahedron().placed([1.0; 3], at)),
        Target::new("cube far from the origin", Mesh::cube().placed([1.0, 2.0, 0.7], far)),
        Target::new("icosahedron far from the origin", Mesh::icosahedron().placed([1.0; 3], far)),
        Target::new("tiny tetrahedron", Mesh::tetrahedron().placed([1e-8; 3], times(at, 1e-8))),
        Target::new("huge octahedron", Mesh::octahedron().placed([1e9; 3], times(at, 1e9))),
        Target::new("slivers of a thousandth", Mesh::icosahedron().placed([1.0, 1e-3, 1.0], at)),
        Target::new("needles of a hundredth", Mesh::octahedron().placed([1e-2, 1.0, 1e-2], [0.0; 3])),
        Target::new("flat tetrahedron", Mesh::tetrahedron().placed([1.0, 0.5, 1e-4], times(at, 1e-2))),
    ]
}

/// Meshes of hundreds of triangles.
fn large() -> Vec<Target> {
    let mut random = Random::new(10, 0);
    let mut target = |name, part| {
        let mesh = Mesh::jittered_ball(2, part, &mut random);
        Target { is_convex: false, ..Target::new(name, mesh) }
    };
    let (bumpy, spiky) = (target("bumpy ball", 0.1), target("spiky ball", 0.5));
    vec![
        bumpy,
        spiky,
        Target::new("320 triangles", Mesh::ball_of_triangles(2)),
        Target::new("1280 triangles", Mesh::ball_of_triangles(3)),
        Target::new("far from the origin", Mesh::ball_of_triangles(2).placed([1.0; 3], [-2000.0, 900.0, 8000.0])),
    ]
}

/// What is wrong about rays from inside and from outside of a mesh.
fn leaks(target: &Target, random: &mut Random, rays: usize, traced: &AtomicUsize) -> Vec<String> {
    Shapes::one(Shape::Triangles(&target.triangles)).with(|intersect| {
        let mut leaks = Vec::new();
        for i in 0..rays {
            let inside = i % 2 == 0;
            let ray = if inside { Some(target.ray_from_inside(random)) } else { target.ray_from_outside(random) };
            let Some(ray) = ray else { continue };
            traced.fetch_add(1, Ordering::Relaxed);
            let hit = intersect(&ray);
            // Where a mesh is not convex, a ray may first meet an edge of it that it sees from the side.
            if !hit.is_some_and(|hit| hit.from_outside != inside || !target.is_convex) {
                let place = if inside { "inside" } else { "outside" };
                leaks.push(format!("{} from {place}: {ray:?} {hit:?}", target.name));
            }
        }
        leaks
    })
}

#[test]
fn small_meshes_are_watertight() {
    let (targets, traced) = (small(), AtomicUsize::new(0));
    assert_faultless(1800, |round| {
        let target = &targets[round as usize % targets.len()];
        leaks(target, &mut Random::new(11, round), 1000, &traced)
    });
    println!("{traced:?} rays to seams of small meshes");
}

#[test]
fn large_meshes_are_watertight() {
    let (targets, traced) = (large(), AtomicUsize::new(0));
    assert_faultless(100, |round| {
        let target = &targets[round as usize % targets.len()];
        leaks(target, &mut Random::new(12, round), 500, &traced)
    });
    println!("{traced:?} rays to seams of large meshes");
}

/// Some rays from inside of meshes of size 1 get out by the published test, and nothing of small ones is met at all.
#[test]
fn the_published_test_leaks() {
    for (name, mesh, rays) in [
        ("cube", Mesh::cube(), 10_000),
        ("icosahedron", Mesh::icosahedron(), 10_000),
        ("320 triangles", Mesh::ball_of_triangles(2), 1000),
        ("tiny tetrahedron", Mesh::tetrahedron().placed([1e-4; 3], [0.0; 3]), 1000),
    ] {
        let (target, traced) = (Target::new(name, mesh), AtomicUsize::new(0));
        let (_, total) = faults(10, |round| {
            let mut random = Random::new(13, round);
            traced.fetch_add(rays, Ordering::Relaxed);
            let rays = (0..rays).map(|_| target.ray_from_inside(&mut random));
            rays.filter(|ray| !target.is_met_naively(ray)).map(|_| String::new()).collect()
        });
        println!("naive: {total} of {traced:?} rays get out of the {name}");
        assert!(total > 0, "{name}");
    }
}

/// Across the diagonal of an open quad, whatever its plane.
#[test]
fn diagonals_of_quads_are_closed() {
    assert_faultless(1000, |round| {
        let mut random = Random::new(14, round);
        let (u, v) = (random.direction(), random.direction());
        let size = random.decades(8.0);
        let corner = rounded(times(random.in_cube(), size * random.decades(3.0)));
        let corner_of = |a: f64, b: f64| rounded(plus(exact(corner), plus(times(u, a * size), times(v, b * size))));
        let (b, c, d) = (corner_of(1.0, 0.0), corner_of(1.0, 1.0), corner_of(0.0, 1.0));
        let quad = [Triangle { vertices: [corner, b, c] }, Triangle { vertices: [corner, c, d] }];
        Shapes::one(Shape::Triangles(&quad)).with(|intersect| {
            let ray = |_| {
                let place = 0.01 + 0.98 * random.unit() as f32;
                let target = corner + (c - corner) * place;
                let origin = target + rounded(times(random.direction(), size * (1.0 + random.decades(2.0))));
                let mut direction = (target - origin).normalized();
                direction.x = nudged(direction.x, random.below(3) as i32 - 1);
                Ray { origin, direction }
            };
            // Where the quad is seen from the side, or has shrunk to a point, it may be passed by.
            let normals = quad.map(|triangle| {
                let [a, b, c] = triangle.vertices.map(exact);
                crate::exact::cross(minus(b, a), minus(c, a))
            });
            let is_seen = |ray: &Ray<f32>| {
                let slant = normals.map(|normal| dot(normal, exact(ray.direction)) / (size * size));
                let margin = 1e-3 + 40.0 * ROUNDOFF * (length(exact(ray.origin)) + length(exact(corner))) / size;
                slant.iter().all(|slant| *slant > margin) || slant.iter().all(|slant| *slant < -margin)
            };
            let rays: Vec<_> = (0..300).map(ray).filter(is_seen).collect();
            let passes = |ray: &Ray<f32>| intersect(ray).is_none();
            rays.iter().filter(|ray| passes(ray)).map(|ray| format!("{quad:?} {ray:?}")).collect()
        })
    });
}

/// All rays that are equally good at choosing an axis: along axes and diagonals, with zeros of both signs, exactly
/// through corners and edges.
#[test]
fn exact_hits_of_seams_are_hits() {
    let cube = Mesh::cube().triangles();
    Shapes::one(Shape::Triangles(&cube)).with(|intersect| {
        let steps = [-1.0, -0.5, -0.0, 0.0, 0.5, 1.0];
        for x in steps {
            for y in steps {
                for z in steps {
                    let direction = Vec3::new(x, y, z);
                    if direction == Vec3::ZERO {
                        continue;
                    }
                    let [far, origin] = [direction * 8.0, Vec3::ZERO];
                    for direction in [direction, direction.normalized()] {
                        let out: Intersection<f32> = intersect(&Ray { origin, direction }).unwrap();
                        assert!(!out.from_outside, "{direction:?}");
                        let back = Ray { origin: far, direction: -direction };
                        assert!(intersect(&back).is_some(), "{direction:?}");
                    }
                }
            }
        }
    });
}
