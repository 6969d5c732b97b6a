//! Triangles that are lines or points, slivers, and triangles that a ray sees from the side.
//!
//! A triangle with two corners in one place is never met. One with three corners on a line is met like the sliver that
//! rounding makes of it, or not at all: that closes a seam where the corner of one triangle lies on the edge of another.

use std::sync::atomic::{AtomicU64, Ordering};

use whit::scene::Triangle;
use whit::{Intersection, Ray, Shape, Vec3};

use crate::exact::{ROUNDOFF, Vector, dot, exact, length, minus, nudged, plus, ray_to, rounded, times, unit};
use crate::meshes::Mesh;
use crate::random::Random;
use crate::{Fault, Shapes, assert_faultless};

/// What is wrong about the numbers of an answer, if anything is.
fn judge(ray: &Ray<f32>, hit: &Intersection<f32>) -> Option<&'static str> {
    let finite = |v: Vec3<f32>| v.x.is_finite() && v.y.is_finite() && v.z.is_finite();
    if !(finite(hit.point) && finite(hit.normal) && finite(hit.offset) && hit.distance.is_finite()) {
        return Some("not finite");
    }
    if hit.distance <= 0.0 {
        return Some("behind the origin");
    }
    let length = length(exact(hit.normal));
    if length != 0.0 && (length - 1.0).abs() > 1e-6 {
        return Some("a normal of another length");
    }
    let leaves = hit.leave(ray.direction);
    (!finite(leaves.origin)).then_some("left from nowhere")
}

/// Rays to places of a triangle, and along its edges.
fn rays(vertices: &[Vec3<f32>; 3], random: &mut Random) -> Vec<Ray<f32>> {
    let size = (0..3).map(|i| length(minus(exact(vertices[i]), exact(vertices[0])))).fold(1e-12, f64::max);
    let ray = |_| {
        let weights = random.weights();
        let target = (0..3).fold([0.0; 3], |sum, i| plus(sum, times(exact(vertices[i]), weights[i])));
        if random.below(4) == 0 {
            // In the plane of the triangle, through it.
            let [a, b] = [vertices[random.below(3)], vertices[random.below(3)]];
            let along = minus(exact(b), exact(a));
            let from = plus(target, times(along, -2.0));
            return ray_to(rounded(from), target);
        }
        let away = times(random.direction(), size * random.decades(2.0));
        let mut ray = ray_to(rounded(plus(target, away)), target);
        ray.direction.y = nudged(ray.direction.y, random.below(3) as i32 - 1);
        ray
    };
    let rays: Vec<_> = (0..100).map(ray).collect();
    rays.into_iter().filter(|ray| ray.direction.x.is_finite()).collect()
}

/// Traces rays to triangles and gives what is wrong, each ray twice.
fn faults_of(vertices: &[Vec3<f32>; 3], random: &mut Random, may_be_met: bool) -> Vec<Fault> {
    let [a, b, c] = *vertices;
    let rays = rays(vertices, random);
    Shapes::one(Shape::triangle(a, b, c)).with(|intersect| {
        let judge = |ray: &Ray<f32>| {
            let (hit, again) = (intersect(ray), intersect(ray));
            let same = format!("{hit:?}") == format!("{again:?}");
            let hit = hit?;
            let fault = if !may_be_met { Some("met") } else { judge(ray, &hit) };
            let fault = if same { fault? } else { "another answer the second time" };
            Some(format!("{fault}: {vertices:?} {ray:?} {hit:?}"))
        };
        rays.iter().filter_map(judge).collect()
    })
}

/// Two corners in one place, or all three.
#[test]
fn triangles_with_coincident_corners_are_never_met() {
    assert_faultless(3000, |round| {
        let mut random = Random::new(60, round);
        let (a, b) = (random.point_of_decades(6.0), random.point_of_decades(6.0));
        let vertices = [[a, a, b], [a, b, a], [b, a, a], [a, a, a]][random.below(4)];
        faults_of(&vertices, &mut random, false)
    });
}

/// Three corners on one line, exactly: what is met has finite numbers, of the normal too, which may be zero.
#[test]
fn triangles_without_area_have_finite_answers() {
    let [rays_in_all, met, without_normal] = [const { AtomicU64::new(0) }; 3];
    assert_faultless(3000, |round| {
        let mut random = Random::new(61, round);
        let mut whole = |most: usize| random.below(2 * most + 1) as f32 - most as f32;
        let (start, step) = (Vec3::new(whole(99), whole(99), whole(99)), Vec3::new(whole(9), whole(9), whole(9)));
        let scale = 2_f32.powi(whole(20) as i32);
        let [i, j] = [whole(20), whole(20)];
        let vertices = [start * scale, (start + step * i) * scale, (start + step * j) * scale];
        let normal = crate::solids::normal(&vertices);
        assert_eq!(normal, [0.0; 3], "the area is zero");
        let [a, b, c] = vertices;
        Shapes::one(Shape::triangle(a, b, c)).with(|intersect| {
            for ray in rays(&vertices, &mut Random::new(66, round)) {
                rays_in_all.fetch_add(1, Ordering::Relaxed);
                let Some(hit) = intersect(&ray) else { continue };
                met.fetch_add(1, Ordering::Relaxed);
                without_normal.fetch_add((hit.normal == Vec3::ZERO).into(), Ordering::Relaxed);
            }
        });
        faults_of(&vertices, &mut random, true)
    });
    println!("{met:?} of {rays_in_all:?} rays to lines meet them, {without_normal:?} without a normal");
}

/// Triangles a thousandth to a ten-millionth as high as they are long.
#[test]
fn slivers_have_finite_answers() {
    assert_faultless(3000, |round| {
        let mut random = Random::new(62, round);
        let aspect = 10_f64.powi(-3 - random.below(5) as i32);
        let (along, size) = (random.direction(), random.decades(8.0));
        let start = times(random.in_cube(), size * random.decades(1.0));
        let aside = times(unit(crate::exact::cross(along, random.direction())), aspect);
        let corner = |along_part: f64, aside_part: f64| {
            let place = plus(times(along, along_part), times(aside, aside_part));
            rounded(plus(start, times(place, size)))
        };
        let tip = if random.below(2) == 0 { 1.0 } else { random.unit() };
        faults_of(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(tip, 1.0)], &mut random, true)
    });
}

/// In coordinate planes, with rays that lie exactly in the plane: through corners, along edges and across.
#[test]
fn rays_in_the_plane_of_a_triangle_meet_nothing() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.25, 1.0]];
    let places = [-1.0, -0.0, 0.0, 0.25, 0.5, 1.0, 2.0];
    let mut rays = 0;
    for axis in 0..3 {
        for height in [0.0, -0.0, 0.3, 1e6] {
            let place = |[x, y]: [f32; 2], height: f32| match axis {
                0 => Vec3::new(height, x, y),
                1 => Vec3::new(x, height, y),
                _ => Vec3::new(x, y, height),
            };
            let [a, b, c] = corners.map(|corner| place(corner, height));
            Shapes::one(Shape::triangle(a, b, c)).with(|intersect| {
                for (x, y) in places.into_iter().flat_map(|x| places.map(|y| (x, y))) {
                    for direction in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8], [-0.8, 0.6], [0.242_535_62, 0.970_142_5]] {
                        for zero in [0.0, -0.0] {
                            let ray = Ray { origin: place([x, y], height), direction: place(direction, zero) };
                            assert!(intersect(&ray).is_none(), "{ray:?}");
                            rays += 1;
                        }
                    }
                }
            });
        }
    }
    assert!(rays > 5000);
}

/// Each face with triangles without area at its edges: corners in one place, and the middle of an edge as a third corner
/// on it, for a neighbour that is cut in two there.
fn with_degenerate_triangles(mesh: &Mesh, is_cut: bool) -> Vec<Triangle<f32>> {
    let mut triangles = Vec::new();
    for &[a, b, c] in &mesh.faces {
        let [p, q, r] = [a, b, c].map(|i| mesh.vertices[i]);
        let middle = (p + q) * 0.5;
        // Of the two faces at an edge, the one that goes up along it is cut.
        if is_cut && a < b {
            triangles.extend([[p, middle, r], [middle, q, r], [p, q, middle], [q, q, p]]);
        } else {
            triangles.extend([[r, q, r], [p, q, r], [p, q, q], [p, p, p]]);
        }
    }
    triangles.into_iter().map(|vertices| Triangle { vertices }).collect()
}

fn meshes() -> [Mesh; 5] {
    [
        Mesh::cube(),
        Mesh::octahedron(),
        Mesh::tetrahedron().placed([0.3; 3], [0.1, -0.7, 0.2]),
        Mesh::icosahedron().placed([1.0; 3], [4.3, -2.0, 0.9]),
        Mesh::cube().placed([1.7, 0.3, 1.1], [30_000.0, 200.0, -7000.0]),
    ]
}

/// A ray from a place towards an edge, often to its middle.
fn towards_edge(mesh: &Mesh, origin: Vec3<f32>, random: &mut Random) -> Ray<f32> {
    let [a, b, _] = mesh.faces[random.below(mesh.faces.len())].map(|i| mesh.vertices[i]);
    let place = [0.5, random.unit() as f32][random.below(2)];
    let mut direction = (a + (b - a) * place - origin).normalized();
    direction.z = nudged(direction.z, random.below(5) as i32 - 2);
    Ray { origin, direction }
}

/// What is wrong about rays to edges, from inside of a mesh or from outside.
fn leaks(mesh: &Mesh, is_cut: bool, random: &mut Random) -> Vec<Fault> {
    let triangles = with_degenerate_triangles(mesh, is_cut);
    let ray = |_| {
        let outside = times(unit(random.direction()), 3.0 * mesh.radius());
        let origin = if is_cut { rounded(plus(mesh.center, outside)) } else { mesh.inside(0.8, random) };
        towards_edge(mesh, origin, random)
    };
    let rays: Vec<_> = (0..1000).map(ray).collect();
    Shapes::one(Shape::Triangles(&triangles)).with(|intersect| {
        let fault = |ray: &Ray<f32>| match intersect(ray) {
            // Past the outline.
            None if is_cut && !is_through(mesh, ray) => None,
            None => Some(format!("{ray:?} passes")),
            Some(hit) => judge(ray, &hit).map(|fault| format!("{fault}: {ray:?} {hit:?}")),
        };
        rays.iter().filter_map(fault).collect()
    })
}

/// Whether a ray goes through a good part of a convex mesh.
fn is_through(mesh: &Mesh, ray: &Ray<f32>) -> bool {
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for (face, corners) in mesh.faces.iter().enumerate() {
        let normal = mesh.normal(face);
        let height = dot(minus(exact(ray.origin), exact(mesh.vertices[corners[0]])), normal);
        let speed = dot(exact(ray.direction), normal);
        let distance = -height / speed;
        if speed < 0.0 {
            enter = enter.max(distance)
        } else {
            leave = leave.min(distance)
        };
    }
    leave - enter > 0.01 * mesh.radius()
}

/// A closed mesh stays closed when triangles without area are added.
#[test]
fn degenerate_triangles_do_no_harm() {
    let meshes = meshes();
    assert_faultless(200, |round| leaks(&meshes[round as usize % 5], false, &mut Random::new(63, round)));
}

/// Where a corner of one triangle lies on the edge of another, exactly or as nearly as it can, a triangle without area
/// closes the seam for rays from outside.
#[test]
fn triangles_without_area_close_seams() {
    let meshes = meshes();
    assert_faultless(200, |round| leaks(&meshes[round as usize % 5], true, &mut Random::new(65, round)));
}

/// The normal of a sliver, by how thin it is: the largest angle between it and the exact one.
#[test]
fn normals_of_slivers() {
    for (aspect, most) in [(1e-1, 1e-5), (1e-2, 1e-4), (1e-3, 1e-3), (1e-4, 1e-2)] {
        let mut worst = 0.0_f64;
        for round in 0..3000 {
            let mut random = Random::new(64, round);
            let along = random.direction();
            let aside = times(unit(crate::exact::cross(along, random.direction())), aspect);
            let corner = |x: f64, y: f64| rounded(plus(times(along, x), times(aside, y)));
            let vertices = [corner(0.0, 0.0), corner(1.0, 0.0), corner(random.unit(), 1.0)];
            let normal = unit(crate::solids::normal(&vertices));
            let center: Vector = times((0..3).fold([0.0; 3], |sum, i| plus(sum, exact(vertices[i]))), 1.0 / 3.0);
            let ray = ray_to(rounded(plus(center, normal)), center);
            let [a, b, c] = vertices;
            let Some(hit) = crate::meet(Shape::triangle(a, b, c), &ray) else { continue };
            let sine = length(crate::exact::cross(exact(hit.normal), normal));
            worst = worst.max(if dot(exact(hit.normal), normal) > 0.0 { sine } else { 2.0 });
        }
        println!("aspect {aspect}: off by {worst:.1e}, {:.1} roundings over the aspect", worst / ROUNDOFF * aspect);
        assert!(worst < most);
    }
}
