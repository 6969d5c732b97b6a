//! Rays that leave a surface.

use std::hint::black_box;
use std::time::Instant;

use image::RgbImage;
use whit::{Ray, Rgb, Shape, Vec3};

use crate::leaving::{Failures, failures, unit_vector, with_tracer};
use crate::naive::origin::Origin;
use crate::page::Page;
use crate::picture::picture;
use crate::seen::{Eye, Seen, checker, light};

const SCALES: [f32; 5] = [1e-6, 1e-3, 1.0, 1e3, 1e6];
const RAYS: u32 = 100_000;

const TEXT: &str = "
## Self-intersection: where the next ray starts

The point of a hit is off by some rounding errors, so a ray that starts there may meet its own surface again: acne. The
lecture names two remedies, a fixed distance along the new ray (or a smallest t) and a fixed distance along the normal. Both
need a length that fits the scene: where it is too small there is acne, where it is too large the ray starts beyond the
next surface and light leaks in. whit moves the origin along the normal by a bound on the rounding error of that very
point (Pharr, Jakob and Humphreys, \"Physically Based Rendering\", 4th edition, 6.8).

A ball on the ground, at three sizes:
";

const TABLE: &str = "
For each size of the scene: rays that leave a sphere and meet it again (a fifth of them grazing), rays that enter a slab of
relative thickness 1e-4 and miss its other face, and rays that leave a sphere towards a neighbour 32 roundings of its radius
away and start inside of that or beyond; of 100,000 each. The time is that of choosing the origin and tracing the ray in a scene of
one sphere, as a ratio to starting at the point itself, measured in one run.
";

const ANSWER: &str = "
In `tests/hard_cases_spheres`, a million rays of each kind at each of six sizes give 0 failures; so do, in
`tests/hard_cases_shapes`, up to a million for each kind of shape over 16 decades of size. Contact shadows reach the point
where a ball touches the ground to a millionth of its radius. On a sphere an origin lies no farther from the point than 40u
times its largest coordinate.
";

pub fn write(page: &mut Page) -> Result<(), String> {
    page.text(TEXT);
    for (name, scale, caption) in [
        ("leaving-small", 1e-3, "A ball of radius 0.001: a smallest t of 0.001, a normal offset of 0.001, and whit."),
        ("leaving-middle", 1.0, "A ball of radius 1, the same."),
        ("leaving-large", 1e6, "A ball of radius 1,000,000, the same."),
    ] {
        let [a, b, c] = [Origin::AlongRay(1e-3), Origin::AlongNormal(1e-3), Origin::ErrorBound].map(|o| ball(o, scale));
        page.pictures(name, caption, &[&a, &b, &c])?;
    }
    page.text(TABLE);
    let mut rows = vec![
        ["origin", "size", "met again", "missed the other face", "in or beyond the neighbour", "time"]
            .map(str::to_owned)
            .to_vec(),
    ];
    let times = times();
    for (origin, time) in Origin::ALL.into_iter().zip(times) {
        for scale in SCALES {
            let Failures { self_hits, leaks, jumps, .. } = failures(origin, scale, RAYS);
            let counts = [self_hits, leaks, jumps].map(|count| count.to_string());
            let [a, b, c] = counts;
            rows.push(vec![origin.to_string(), format!("{scale:e}"), a, b, c, format!("{time:.2}")]);
        }
    }
    page.table(&rows);
    page.text(ANSWER);
    Ok(())
}

/// A ball on the ground, in a scene of this size.
pub fn ball(origin: Origin, scale: f32) -> RgbImage {
    let eye =
        Eye { position: Vec3::new(1.5, 1.2, 4.0) * scale, target: Vec3::new(0.2, 0.6, 0.0) * scale, half_height: 0.4 };
    let shapes = [Shape::plane(Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0)), Shape::sphere(Vec3::new(0.0, scale, 0.0), scale)];
    with_tracer(&shapes, |tracer| {
        picture(|x, y| {
            let meet = |ray: &Ray<f32>| {
                let hit = tracer.intersect(ray)?;
                let color = if hit.object == 0 { checker(hit.point, scale) } else { Rgb::new(0.2, 0.4, 0.75) };
                let normal = if hit.from_outside { hit.normal } else { -hit.normal };
                Some(Seen { distance: hit.distance, point: hit.point, normal, color })
            };
            let leave = |ray: &Ray<f32>, _: &Seen, direction| match tracer.intersect(ray) {
                Some(hit) => origin.leave(ray, &hit, direction),
                None => *ray,
            };
            light(&eye.ray(x, y), Vec3::new(-0.6, 0.7, 0.3).normalized(), meet, leave)
        })
    })
}

/// Seconds for each way, the least of many runs in turn, as ratios to the first.
fn times() -> Vec<f64> {
    let mut random = fastrand::Rng::with_seed(5);
    let rays: Vec<(Ray<f32>, Vec3<f32>)> = (0..4096)
        .map(|_| {
            let origin = unit_vector(&mut random) * 3.0;
            let direction = (unit_vector(&mut random) * 0.7 - origin).normalized();
            (Ray { origin, direction }, unit_vector(&mut random))
        })
        .collect();
    let mut least = vec![f64::MAX; Origin::ALL.len()];
    with_tracer(&[Shape::sphere(Vec3::ZERO, 1.0)], |tracer| {
        for _ in 0..201 {
            for (origin, least) in Origin::ALL.into_iter().zip(&mut least) {
                let start = Instant::now();
                for (ray, direction) in &rays {
                    if let Some(hit) = tracer.intersect(ray) {
                        black_box(tracer.intersect(&origin.leave(ray, &hit, *direction)));
                    }
                }
                *least = least.min(start.elapsed().as_secs_f64());
            }
        }
    });
    let first = least.first().copied().unwrap_or(1.0);
    least.iter().map(|time| time / first).collect()
}
