//! The largest number of bounces that a budget can name.

use whit::trace::MOST_BOUNCES;
use whit::{
    Background, Budget, Camera, Effects, Frame, Material, Object, Ray, Rgb, Scene, Settings, Shape, Stats, Tracer, Vec3,
};

/// A ray to and fro between two perfect mirrors ends after that number, however large, and a frame refuses what
/// is more than can be counted.
#[test]
fn the_largest_depth_is_a_bound() {
    let up = Vec3::new(0.0_f32, 1.0, 0.0);
    let mirror = Material::mirror(Rgb::WHITE);
    let objects = [Object::new(Shape::plane(-up, up), mirror), Object::new(Shape::plane(up, -up), mirror)];
    let camera = Camera::look_at(Vec3::ZERO, up, Vec3::new(1.0, 0.0, 0.0), 40.0);
    let scene = Scene::new(camera, Background::Solid(Rgb::WHITE)).with_objects(&objects);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 2>::try_new(&scene).unwrap();
    for depth in [0, 1, 2, 200, 254, 255] {
        let budget = Budget { rays_per_pixel: 1000, ..Budget::with_depth(depth) };
        let mut stats = Stats::default();
        let light = tracer.trace(Ray { origin: Vec3::ZERO, direction: up }, &budget, &mut stats);
        let bounces = u64::from(depth.min(MOST_BOUNCES));
        assert_eq!((stats.rays(), stats.cut_by_depth), (bounces + 1, 1), "depth {depth}: {stats:?}");
        assert_eq!(light, Rgb::WHITE);
    }
    let asked = Settings::new(1, 1).with_depth(255);
    let deepest = Tracer::<f32, { Effects::ALL.bits() }, 255>::try_new(&scene).unwrap();
    assert!(Frame::new(&deepest, asked.clone()).is_err());
    assert!(Frame::new(&deepest, asked.with_depth(MOST_BOUNCES)).is_ok());
}
