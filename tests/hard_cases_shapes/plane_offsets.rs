//! Points on planes and discs lie no farther from them than their offset.

use whit::{Background, Camera, Effects, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// From far away onto a floor at height 0 whose normal is not of length 1: rays that leave the floor upwards do not meet
/// it.
#[test]
fn a_floor_seen_from_far_away_is_met_once() {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let mut again = Vec::new();
    for length in [1.0_f32, 1.7, 2.9, 3.4, 3.7, 5.8, 9.3] {
        let normal = Vec3::new(0.0, length, 0.0);
        for shape in [Shape::plane(Vec3::ZERO, normal), Shape::disc(Vec3::ZERO, normal, 1e12)] {
            let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
            let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
            let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
            for i in 0..1000 {
                let origin = Vec3::new(0.0, 10.0, 0.0);
                let direction = Vec3::new(0.01 * i as f32, -10.0, 3.0).normalized();
                let hit = tracer.intersect(&Ray { origin, direction }).unwrap();
                if tracer.intersect(&hit.leave(Vec3::new(0.0, 1.0, 0.0))).is_some() {
                    again.push((length, hit));
                }
            }
        }
    }
    assert!(again.is_empty(), "{} of 14000 rays meet the floor that they leave, as from {:?}", again.len(), again[0]);
}
