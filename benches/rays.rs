//! Nanoseconds a ray: eye rays alone, and whole ray trees.
//!
//!     cargo bench --bench rays
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use whit::render::{ForEach, Pixel, Size};
use whit::{Frame, Settings, Stats, Tracer, scenes};

const SIZE: Size = Size::new(96, 96);

/// Renders a picture and hands each pixel to the optimiser's blind spot.
fn render<const EFFECTS: u64>(tracer: &Tracer<'_, f32, EFFECTS, 16>, depth: u8) -> Stats {
    let mut target = ForEach::new(SIZE, |pixel: Pixel| {
        black_box(pixel);
        Ok::<(), core::convert::Infallible>(())
    });
    let settings = Settings::new(SIZE.width, SIZE.height).with_depth(depth);
    let Ok(mut frame) = Frame::observed(tracer, settings, Stats::default()) else { return Stats::default() };
    let _ = frame.render(&mut target);
    *frame.observer()
}

/// Eye rays with their shadow rays, and trees of 5 bounces; the throughput counts every ray.
fn bench<const EFFECTS: u64>(criterion: &mut Criterion, name: &str, tracer: &Tracer<'_, f32, EFFECTS, 16>) {
    let mut group = criterion.benchmark_group(name);
    for (label, depth) in [("primary", 0), ("tree", 5)] {
        group.throughput(Throughput::Elements(render(tracer, depth).rays()));
        group.bench_function(BenchmarkId::from_parameter(label), |bencher| bencher.iter(|| render(tracer, depth)));
    }
    group.finish();
}

fn all(criterion: &mut Criterion) {
    bench(criterion, "showcase", &whit::tracer!(scenes::SHOWCASE, 16));
    bench(criterion, "card", &whit::tracer!(scenes::CARD, 16));
    bench(criterion, "flake", &whit::tracer!(scenes::FLAKE, 16));
}

criterion_group!(benches, all);
criterion_main!(benches);
