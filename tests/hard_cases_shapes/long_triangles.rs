//! Long triangles are met near the eye, although their corners are far away on both sides of it.

use whit::scene::Triangle;
use whit::{Background, Camera, Effects, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// How many of 10,000 rays do not meet a road of two triangles, 10 wide, seen from 1.5 above its middle; they point along
/// the road and down onto it.
fn misses(length: f32) -> usize {
    let (half, side) = (length / 2.0, 5.0);
    let [a, b, c, d] = [(-half, -side), (-half, side), (half, side), (half, -side)].map(|(x, z)| Vec3::new(x, 0.0, z));
    let road = [Triangle { vertices: [a, b, c] }, Triangle { vertices: [a, c, d] }];
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let objects = [Object::new(Shape::Triangles(&road), Material::matte(Rgb::WHITE))];
    let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
    let rays = (0..10_000).map(|i| {
        let (slope, sideways) = (0.05 + 0.009 * (i / 100) as f32, 0.001 * (i % 100) as f32);
        Ray { origin: Vec3::new(3.0, 1.5, 0.3), direction: Vec3::new(1.0, -slope, sideways).normalized() }
    });
    rays.filter(|ray| tracer.intersect(ray).is_none()).count()
}

#[test]
fn a_road_is_met_under_the_eye() {
    let misses = [1e2, 1e3, 1e4, 1e5].map(|length| (length, misses(length)));
    assert!(misses.iter().all(|(_, misses)| *misses == 0), "of 10,000 rays by the length of the road: {misses:?}");
}
