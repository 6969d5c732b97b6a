//! The shapes of the reference tracer against what it means to be inside of a solid.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

mod reference;

use reference::shapes::{Meeting, Primitive, Ray};
use reference::vector::Vector;
use reference::world::World;
use whit::scene::{Background, Camera, Material, Object, Scene, Shape, SmoothTriangle};
use whit::{Rgb, Vec3};

/// Whether a point is inside.
type Inside = fn(Vector) -> bool;

fn v(x: f64, y: f64, z: f64) -> Vector {
    Vector::new(x, y, z)
}

fn solids() -> [(Shape<'static, f32>, Inside); 5] {
    [
        (Shape::sphere(Vec3::new(0.5, 0.25, 0.0), 0.75), |p| (p - v(0.5, 0.25, 0.0)).length() < 0.75),
        (Shape::sphere(Vec3::ZERO, -1.0), |p| p.length() < 1.0),
        (Shape::axis_box(Vec3::new(-0.5, -1.0, 0.25), Vec3::new(1.0, 0.5, 0.75)), |p| {
            p.x > -0.5 && p.x < 1.0 && p.y > -1.0 && p.y < 0.5 && p.z > 0.25 && p.z < 0.75
        }),
        // At the height z the radius is 1 − z/2.
        (Shape::cone(Vec3::ZERO, 1.0, Vec3::new(0.0, 0.0, 1.0), 0.5).capped(), |p| {
            p.z > 0.0 && p.z < 1.0 && p.x.hypot(p.y) < 1.0 - 0.5 * p.z
        }),
        (Shape::cone(Vec3::new(0.0, 1.0, 0.0), 0.0, Vec3::ZERO, 1.0).capped(), |p| {
            p.y > 0.0 && p.y < 1.0 && p.x.hypot(p.z) < 1.0 - p.y
        }),
    ]
}

/// G. L. Steele, D. Lea and C. H. Flood, Fast Splittable Pseudorandom Number Generators, 2014.
struct SplitMix(u64);

impl SplitMix {
    /// From −1 to 1.
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector {
        v(self.number(), self.number(), self.number())
    }
}

fn meetings(shape: Shape<'_, f32>, ray: &Ray) -> Vec<Meeting> {
    let mut all = Vec::new();
    for primitive in Primitive::all(&Object::new(shape, Material::mirror(Rgb::WHITE))) {
        primitive.meet(ray, None, &mut |meeting| all.push(meeting));
    }
    all.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    all
}

#[test]
fn a_line_meets_a_convex_solid_twice_on_its_surface() {
    let mut random = SplitMix(1);
    for (shape, inside) in solids() {
        let turned = matches!(shape, Shape::Sphere(s) if s.radius < 0.0);
        let mut met = 0;
        for _ in 0..20_000 {
            let ray = Ray::new(random.vector() * 2.0, random.vector());
            let all = meetings(shape, &ray);
            let middle = match all[..] {
                [] => {
                    let on_line = (-4000..4000).map(|i| ray.at(f64::from(i) * 1e-3));
                    assert!(met % 100 != 0 || !on_line.into_iter().any(inside), "{shape:?} {ray:?}");
                    continue;
                }
                [first, second] => ray.at(0.5 * (first.distance + second.distance)),
                _ => panic!("{} meetings of {shape:?} {ray:?}", all.len()),
            };
            met += 1;
            assert!(inside(middle) || all[1].distance - all[0].distance < 1e-9);
            for (meeting, entering) in all.iter().zip([true, false]) {
                let point = ray.at(meeting.distance);
                let outward = if turned { -meeting.outward } else { meeting.outward };
                assert!((outward.length() - 1.0).abs() < 1e-12);
                assert!(inside(point - outward * 1e-9) && !inside(point + outward * 1e-9), "{shape:?} {meeting:?}");
                assert_eq!(outward.dot(ray.direction) < 0.0, entering);
            }
        }
        assert!(met > 1000, "{met} meetings of {shape:?}");
    }
}

#[test]
fn a_ray_that_leaves_a_surface_meets_only_the_other_side() {
    let mut random = SplitMix(2);
    let camera = Camera::look_at(Vec3::ZERO, Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 1.0, 0.0), 40.0);
    for (shape, _) in solids() {
        let objects = [Object::new(shape, Material::mirror(Rgb::WHITE))];
        let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
        let world = World::new(&scene);
        for scale in [1.0, 100.0, 10_000.0] {
            for _ in 0..10_000 {
                let start = random.vector() * scale;
                let Some(hit) = world.nearest(&Ray::new(start, random.vector() - start)) else { continue };
                let turned = if hit.outside { hit.geometric } else { -hit.geometric };
                let outward = if matches!(shape, Shape::Sphere(s) if s.radius < 0.0) { -turned } else { turned };
                let direction = random.vector().normalized();
                let onward = world.nearest(&hit.leave(direction));
                assert_eq!(onward.is_some(), direction.dot(outward) < 0.0, "{shape:?} {hit:?} {direction:?}");
                if let Some(onward) = onward {
                    let expected = meetings(shape, &Ray::new(hit.point, direction))[1].distance;
                    // The shorter the chord, the more it feels the rounding of its origin.
                    let tolerance = 1e-13 * scale / expected.min(1.0);
                    assert!((onward.distance - expected).abs() < tolerance, "{expected} {onward:?}");
                }
            }
        }
    }
}

#[test]
fn spheres_cylinders_and_cones_are_met_at_their_closed_forms() {
    let ray = Ray::new(v(-5.0, 0.6, 0.0), v(1.0, 0.0, 0.0));
    let up = Vec3::new(0.0, 1.0, 0.0);
    let along_z = |z| Vec3::new(0.0, 0.0, z);
    // The cone of radius 2·(1 − y) about the y axis: 0.8 at y = 0.6, its normal (1, 2, 0)/√5 at z = 0.
    let slant = v(-1.0, 2.0, 0.0).normalized();
    let cases = [
        (Shape::sphere(Vec3::ZERO, 1.0), [4.2, 5.8], v(-0.8, 0.6, 0.0)),
        (Shape::sphere(Vec3::ZERO, -1.0), [4.2, 5.8], v(0.8, -0.6, 0.0)),
        (Shape::cylinder(along_z(-1.0), along_z(1.0), 1.0), [4.2, 5.8], v(-0.8, 0.6, 0.0)),
        (Shape::cylinder(along_z(-1.0), along_z(1.0), -1.0), [4.2, 5.8], v(0.8, -0.6, 0.0)),
        (Shape::cone(Vec3::ZERO, 2.0, up, 0.0), [4.2, 5.8], slant),
    ];
    for (shape, distances, normal) in cases {
        let all = meetings(shape, &ray);
        assert_eq!(all.len(), 2);
        for (meeting, distance) in all.iter().zip(distances) {
            assert!((meeting.distance - distance).abs() < 1e-12, "{shape:?} {meeting:?}");
        }
        assert!((all[0].outward - normal).length() < 1e-12, "{shape:?} {:?}", all[0]);
    }
    let open = Shape::cylinder(along_z(-1.0), along_z(1.0), 1.0);
    let through = Ray::new(v(0.5, 0.0, 5.0), v(0.0, 0.0, -1.0));
    assert!(meetings(open, &through).is_empty());
    assert_eq!(meetings(open.capped(), &through).len(), 2);
}

#[test]
fn triangles_that_share_edges_leave_no_gap() {
    let mut random = SplitMix(3);
    let corner = |x, y| Vec3::new(x, y, 0.0);
    let middle = corner(0.3, 0.1);
    let ring = [corner(-1.0, -1.1), corner(1.2, -0.9), corner(0.9, 1.3), corner(-1.1, 0.8)];
    let fan = |i: usize| Shape::triangle(middle, ring[i], ring[(i + 1) % 4]);
    for end in ring {
        for _ in 0..2000 {
            let t = 0.5 * (random.number() + 1.0);
            let on_edge = Vector::from(middle) * (1.0 - t) + Vector::from(end) * t;
            let origin = random.vector() + v(0.0, 0.0, 3.0);
            let ray = Ray::new(origin, on_edge - origin);
            let all: Vec<_> = (0..4).flat_map(|k| meetings(fan(k), &ray)).collect();
            assert!(!all.is_empty());
            assert!(all.iter().all(|m| (m.outward - v(0.0, 0.0, 1.0)).length() < 1e-12));
        }
    }
}

#[test]
fn the_edges_and_corners_of_a_triangle_belong_to_it() {
    let shape = Shape::triangle(Vec3::ZERO, Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
    for (x, y) in [(0.5, 0.5), (0.5, 0.0), (0.0, 0.5), (0.0, 0.0), (1.0, 0.0), (0.0, 1.0)] {
        let near = |x, y| meetings(shape, &Ray::new(v(x, y, 1.0), v(0.0, 0.0, -1.0))).len();
        assert_eq!(near(x, y), 1);
        assert_eq!(near(x + (x - 0.3) * 1e-9, y + (y - 0.3) * 1e-9), 0);
    }
}

#[test]
fn a_smooth_triangle_mixes_unit_normals_by_area() {
    let vertices = [Vec3::ZERO, Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 4.0, 0.0)];
    let normals = [Vec3::new(0.0, 0.0, 7.0), Vec3::new(0.5, 0.0, 0.0), Vec3::new(0.0, 3.0, 0.0)];
    let shape = Shape::SmoothTriangle(SmoothTriangle { vertices, normals });
    // At (1, 2, 0) the corners have the shares 1/4, 1/4 and 1/2.
    let all = meetings(shape, &Ray::new(v(1.0, 2.0, 5.0), v(0.0, 0.0, -1.0)));
    assert!((all[0].smooth - v(1.0, 2.0, 1.0).normalized()).length() < 1e-15);
    assert_eq!((all[0].outward, all[0].distance), (v(0.0, 0.0, 1.0), 5.0));
}
