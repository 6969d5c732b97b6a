//! A triangle without area closes the seam between a triangle and two that share its edge in halves, on all sides.

use whit::scene::Triangle;
use whit::{Background, Camera, Effects, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// A fold along an edge that starts behind the eye and ends in front of it. The sharp side of the fold is to the left.
#[test]
fn an_edge_that_passes_the_eye_is_closed() {
    let (p, q) = (Vec3::new(-1.1, -0.3, -3.0), Vec3::new(-0.9, 0.5, 4.0));
    let (r, s) = (Vec3::new(9.0, -9.0, 0.3), Vec3::new(9.0, 9.0, 0.1));
    let middle = (p + q) * 0.5;
    let triangles = [[p, middle, r], [middle, q, r], [q, p, s], [p, q, middle]].map(|vertices| Triangle { vertices });
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let objects = [Object::new(Shape::Triangles(&triangles), Material::matte(Rgb::WHITE))];
    let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
    let passes = (0..1_000_000).filter(|&i| {
        let origin = Vec3::new(0.01 * (i % 10) as f32, 0.013 * (i / 10 % 10) as f32, 0.017 * (i / 100 % 10) as f32);
        let target = p + (q - p) * (0.1 + 0.0008 * (i / 1000) as f32);
        tracer.intersect(&Ray { origin, direction: (target - origin).normalized() }).is_none()
    });
    let passes = passes.count();
    assert!(passes == 0, "{passes} of 1,000,000 rays pass");
}
