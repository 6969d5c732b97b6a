//! Points on boxes lie on them.

use whit::{Background, Camera, Effects, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// A thin plate of glass that is seen from far away: where light goes in, it comes out again. A point beside the plate
/// would have it start outside, and meet the plate as if it came from there.
#[test]
fn a_plate_is_left_from_within() {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let (min, max) = (Vec3::new(-0.5, -0.5, 0.1), Vec3::new(0.5, 0.5, 0.101));
    let objects = [Object::new(Shape::axis_box(min, max), Material::dielectric(1.5))];
    let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
    let wrong = [10.0_f32, 1e2, 1e3, 1e4].map(|far| {
        let wrong = (0..10_000).filter(|i| {
            let target = Vec3::new(-0.5, 0.009 * (i % 100) as f32 - 0.45, 0.1 + 1e-5 * (i / 100) as f32);
            let origin = Vec3::new(-0.8 * far, 0.5 * far, 0.2 * far);
            let Some(hit) = tracer.intersect(&Ray { origin, direction: (target - origin).normalized() }) else {
                return false;
            };
            let next = tracer.intersect(&hit.leave(Vec3::new(0.8, -0.6, 0.0)));
            next.is_none_or(|next| next.from_outside)
        });
        (far, wrong.count())
    });
    assert!(wrong.iter().all(|(_, wrong)| *wrong == 0), "of 10,000 rays, by the distance: {wrong:?}");
}
