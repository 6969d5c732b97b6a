//! Rays that leave a surface do not meet it again.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::scene::{Medium, Triangle};
use whit::{
    Background, Budget, Camera, Effects, Interface, Light, Material, Object, Ray, Rgb, Scene, Shape, Stats, Tracer,
    Vec3,
};

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

/// A wall across the x axis.
fn wall(x: f32) -> [Triangle<f32>; 2] {
    let [a, b, c, d] = [(1.0, -1.8), (1.0, 1.8), (3.0, 1.8), (3.0, -1.8)].map(|(y, z)| Vec3::new(x, y, z));
    [Triangle { vertices: [a, c, b] }, Triangle { vertices: [a, d, c] }]
}

/// Rays to many places of that wall, from many places in front of it.
fn rays_to_wall(x: f32) -> impl Iterator<Item = Ray<f32>> {
    (0..10_000).map(move |i| {
        let (u, v) = ((i % 100) as f32 / 100.0, (i / 100) as f32 / 100.0);
        let origin = Vec3::new(x + 0.2 + u, 1.1 + 1.8 * v, 1.7 - 3.3 * u * v);
        let direction = (Vec3::new(x, 1.1 + 1.7 * u, 1.6 - 3.1 * v) - origin).normalized();
        Ray { origin, direction }
    })
}

fn camera() -> Camera<f32> {
    Camera::look_at(Vec3::new(5.0, 2.0, 0.5), Vec3::new(0.0, 2.0, 0.4), Vec3::new(0.0, 1.0, 0.0), 40.0)
}

/// A wall that lets all light through without bending it: one transmitted branch for each ray. In a coordinate plane
/// the wall's points have no rounding error across it, and the ray starts in it.
#[test]
fn a_triangle_is_met_once() {
    for x in [0.0, 1e-6, 0.01, 0.1, 0.3, 1.0, 1e4] {
        let wall = wall(x);
        let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium: Medium::VACUUM };
        let objects = [Object::new(Shape::Triangles(&wall), Material::dielectric(1.0).with_interface(clear))];
        let scene = Scene::new(camera(), Background::Solid(Rgb::BLACK)).with_objects(&objects);
        let tracer = Tracer::<f32, { Effects::ALL.bits() }, 16>::try_new(&scene).unwrap();
        let mut stats = Stats::default();
        for ray in rays_to_wall(x) {
            let _ = tracer.trace(ray, &Budget::with_depth(12), &mut stats);
        }
        assert_eq!((stats.eye, stats.transmitted), (10_000, 10_000), "x = {x}");
    }
}

/// The same wall inside a medium of higher priority is passed, which takes no depth.
#[test]
fn a_passed_border_is_passed_once() {
    let wall = wall(0.0);
    let glass = |priority| Material::dielectric(1.5).with_priority(priority);
    let around = Shape::axis_box(Vec3::splat(-9.0), Vec3::splat(9.0));
    let objects = [Object::new(Shape::Triangles(&wall), glass(1)), Object::new(around, glass(2))];
    let scene = Scene::new(camera(), Background::Solid(Rgb::BLACK)).with_objects(&objects);
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0, 4>::try_new(&scene).unwrap();
    let mut stats = Stats::default();
    for ray in rays_to_wall(0.0) {
        let _ = tracer.trace(ray, &Budget::with_depth(0), &mut stats);
    }
    assert_eq!((stats.passed, stats.cut_by_passing), (10_000, 0));
}

/// However many surfaces stand in a row, a ray passes no more than 255 of them, and what is cut is counted.
#[test]
fn passing_has_an_end() {
    let glass = |priority| Material::transparent(Medium::new(1.5).with_attenuation(Rgb::BLACK).with_priority(priority));
    let around = Object::new(Shape::sphere(Vec3::ZERO, 1000.0), glass(2)).with_tinted_shadow();
    let beads = (0..300).map(|i| {
        let bead = Shape::sphere(Vec3::new(0.0, 0.0, -2.0 * i as f32), 0.5);
        Object::new(bead, glass(1)).with_tinted_shadow()
    });
    let floor = Shape::plane(Vec3::new(0.0, 0.0, -700.0), Vec3::new(0.0, 0.0, 1.0));
    let floor = Object::new(floor, Material::matte(Rgb::WHITE));
    for (beads_in_all, cut) in [(100, 0), (300, 2)] {
        let objects: Vec<_> = [around, floor].into_iter().chain(beads.clone().take(beads_in_all)).collect();
        let lights = [Light::point(Vec3::new(0.0, 0.0, 50.0), Rgb::WHITE)];
        let scene = Scene::new(camera(), Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
        let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0, 4>::try_new(&scene).unwrap();
        let mut stats = Stats::default();
        for (x, from) in [(0.0, 10.0), (2.0, -650.0)] {
            // The first ray passes the beads; the shadow ray of the second does.
            let direction = Vec3::new(-x, 0.0, -700.0 - from).normalized();
            let ray = Ray { origin: Vec3::new(x, 0.0, from), direction };
            let _ = tracer.trace(ray, &Budget::with_depth(0), &mut stats);
        }
        assert_eq!(stats.cut_by_passing, cut, "{stats:?}");
    }
}
