//! Surfaces do not shadow themselves.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::{Background, Budget, Camera, Effects, Light, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// Every point on the lit side of a thin cylinder or cone is lit, out to its ends, far from the middle of its axis.
#[test]
fn thin_cylinders_are_lit_to_their_ends() {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    for radius in [0.5, 0.2, 0.1, 0.07, 0.02, 0.002] {
        for (base, apex, tip) in [(0.0, 3.0, radius), (3.0, 0.0, radius), (0.0, 3.0, radius * 0.5)] {
            let shape = Shape::cone(Vec3::new(base, 0.0, 0.0), radius, Vec3::new(apex, 0.0, 0.0), tip);
            let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
            for slant in [0.8, -0.8, 0.0, 5.0] {
                let lights = [Light::directional(Vec3::new(slant, 1.0, 0.5), Rgb::WHITE)];
                let scene = Scene::new(camera, Background::Solid(Rgb::grey(0.5)));
                let scene = scene.with_objects(&objects).with_lights(&lights);
                let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
                let dark = (1..2000).filter(|&i| {
                    let origin = Vec3::new(i as f32 * 0.0015, 2.0, 1.0);
                    let direction = Vec3::new(0.0, -2.0, -1.0).normalized();
                    tracer.trace(Ray { origin, direction }, &Budget::with_depth(0), &mut ()).r < 0.05
                });
                assert_eq!(dark.count(), 0, "radius {radius}, from {base} to {apex}, slant {slant}");
            }
        }
    }
}
