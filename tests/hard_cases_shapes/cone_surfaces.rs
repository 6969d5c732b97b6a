//! Points on cones lie on them, rays that leave cones do not meet them again, and capped ones have no gap at their rims.

use whit::{Background, Camera, Effects, Intersection, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

fn with<R>(shape: Shape<'_, f32>, f: impl FnOnce(&dyn Fn(&Ray<f32>) -> Option<Intersection<f32>>) -> R) -> R {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
    let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&objects);
    f(&|ray| Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap().intersect(ray))
}

/// Normals near the tip of a cone that is seen from above are as steep as its side is.
#[test]
fn tips_have_the_normals_of_the_side() {
    // The length of 1/height times the axis is not 1 for this height.
    let (base, height, radius) = (Vec3::new(0.0, 0.1, 0.0), 3.3_f32, 0.5_f32);
    let shape = Shape::cone(base, radius, base + Vec3::new(0.0, height, 0.0), 0.0);
    let steepness = radius / (radius * radius + height * height).sqrt();
    let mut worst = 0.0_f32;
    for far in [1e2_f32, 1e4, 1e6] {
        for i in 0..100 {
            let target = Vec3::new(1e-5 * (i % 10) as f32, 3.4, 1e-5 * (i / 10) as f32);
            let origin = Vec3::new(target.x, far, target.z);
            let hit = with(shape, |intersect| intersect(&Ray { origin, direction: Vec3::new(0.0, -1.0, 0.0) }));
            worst = hit.map_or(worst, |hit| worst.max((hit.normal.y - steepness).abs()));
        }
    }
    assert!(worst < 1e-3, "a normal is off by {worst}");
}

/// Rays that leave a cone of height 1 for a light do not meet it, however wide it is.
#[test]
fn flat_cones_are_met_once() {
    let again = [3.0_f32, 10.0, 30.0, 100.0].map(|radius| {
        let shape = Shape::cone(Vec3::ZERO, radius, Vec3::new(0.0, 1.0, 0.0), 0.0);
        let again = with(shape, |intersect| {
            let rays = (0..10_000).filter(|i| {
                let (x, z) = (radius * 0.007 * (i % 100) as f32, radius * 0.007 * (i / 100) as f32);
                let target = Vec3::new(x, 1.0 - (x * x + z * z).sqrt() / radius, z);
                let origin = Vec3::new(-radius, 5.0, 0.3 * radius);
                let hit = intersect(&Ray { origin, direction: (target - origin).normalized() });
                let towards_light = Vec3::new(-0.9, 0.4, 0.2).normalized();
                hit.is_some_and(|hit| hit.from_outside && intersect(&hit.leave(towards_light)).is_some())
            });
            rays.count()
        });
        (radius, again)
    });
    assert!(again.iter().all(|(_, again)| *again == 0), "of 10,000 rays, by the radius: {again:?}");
}

/// From within a closed cylinder towards its rims, every ray meets it.
#[test]
fn rims_are_closed() {
    let (base, apex) = (Vec3::new(0.2, -0.3, 0.1), Vec3::new(0.5, 0.9, -0.4));
    let axis = (apex - base).normalized();
    let (u, v) = axis.tangents();
    let out = with(Shape::cone(base, 0.7, apex, 0.6).capped(), |intersect| {
        let rays = (0..1_000_000).filter(|&i| {
            let (sine, cosine) = (i as f32 * 0.61).sin_cos();
            let origin = Vec3::new(0.3 + 0.1 * cosine, 0.3 * sine, 0.0);
            let (sine, cosine) = (i as f32 * 0.001).sin_cos();
            let target = base + (u * cosine + v * sine) * 0.7;
            intersect(&Ray { origin, direction: (target - origin).normalized() }).is_none()
        });
        rays.count()
    });
    assert!(out == 0, "{out} of 1,000,000 rays get out");
}

/// A cone that is turned inwards is met from inside at its tip, where its end has no radius.
#[test]
fn tips_have_no_end() {
    let mut wrong = 0;
    for i in 0..1000 {
        let base = Vec3::new(18_000.0 + i as f32, -1400.0, 300.0);
        let apex = base + Vec3::new(9.0, 0.0, 0.0);
        let shape = Shape::cone(base, -1.0, apex, 0.0).capped();
        let origin = Vec3::new(45_000.0, 10.0, -400.0);
        let hit = with(shape, |intersect| intersect(&Ray { origin, direction: (apex - origin).normalized() }));
        wrong += u32::from(hit.is_some_and(|hit| hit.normal.x.abs() > 0.9));
    }
    assert!(wrong == 0, "{wrong} of 1000 tips are met like an end across the axis");
}
