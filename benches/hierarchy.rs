//! Nanoseconds a ray through the sphere-flake, by its list and by a hierarchy of boxes; and the building of the boxes.
//!
//!     cargo bench --bench hierarchy
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use whit::scene::{Hierarchy, Leaf, Node, Sphere};
use whit::{Effects, Object, Ray, Scene, Shape, Tracer, Vec3, scenes};

/// Spheres of flakes of one generation to five.
const COUNTS: [usize; 5] = [1, 10, 91, 820, 7381];
const LARGEST: usize = 7381;
/// Rays in each direction of a square.
const SIDE: u32 = 64;
/// Farther than all spheres.
const FAR: f32 = 1000.0;

const LIST: Effects = scenes::FLAKE.effects().without(Effects::SPHERES).with(Effects::SPHERE);
const BOXES: Effects = LIST.with(Effects::HIERARCHY);

fn all(criterion: &mut Criterion) {
    let spheres: [Sphere<f32>; LARGEST] = scenes::flake_spheres();
    let [floor, balls] = scenes::FLAKE.objects else { return };
    let rays = rays();
    for count in COUNTS {
        let balls = spheres.iter().take(count).map(|sphere| Object { shape: Shape::Sphere(*sphere), ..*balls });
        let objects: Vec<_> = [*floor].into_iter().chain(balls).collect();
        let scene = scenes::FLAKE.with_objects(&objects);
        let parts = scene.parts();
        let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts]);
        let mut group = criterion.benchmark_group(format!("flake of {count}"));
        group.throughput(Throughput::Elements(count as u64));
        group.bench_function("building", |bencher| {
            bencher.iter(|| Hierarchy::build(black_box(&scene), &mut nodes, &mut leaves).is_ok());
        });
        group.throughput(Throughput::Elements(rays.len() as u64));
        search::<{ LIST.bits() }>(&mut group, "list", &scene, &rays);
        let Ok(hierarchy) = Hierarchy::build(&scene, &mut nodes, &mut leaves) else { return };
        search::<{ BOXES.bits() }>(&mut group, "hierarchy", &scene.with_hierarchy(hierarchy), &rays);
        group.finish();
    }
}

/// Looks for the nearest surface, and for any that casts a shadow.
fn search<const EFFECTS: u64>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    scene: &Scene<'_, f32>,
    rays: &[Ray<f32>],
) {
    let Ok(tracer) = Tracer::<f32, EFFECTS, 1>::try_new(scene) else { return };
    group.bench_function(BenchmarkId::new("nearest", name), |bencher| {
        bencher.iter(|| rays.iter().filter_map(|ray| tracer.intersect(ray)).count());
    });
    group.bench_function(BenchmarkId::new("shadow", name), |bencher| {
        bencher.iter(|| rays.iter().filter(|ray| tracer.is_occluded(ray, FAR)).count());
    });
}

/// From the scene's eye, around the direction in which it looks.
fn rays() -> Vec<Ray<f32>> {
    let origin = scenes::FLAKE.camera.eye;
    let forward = (scenes::FLAKE.camera.target - origin).normalized();
    let right = forward.cross(Vec3::new(0.0, 0.0, 1.0)).normalized();
    let up = right.cross(forward);
    let at = |i: u32| (i as f32 + 0.5) / SIDE as f32 - 0.5;
    let ray = |(x, y)| Ray { origin, direction: (forward + right * at(x) + up * at(y)).normalized() };
    (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))).map(ray).collect()
}

criterion_group!(benches, all);
criterion_main!(benches);
