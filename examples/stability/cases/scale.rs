//! A small scene on a planet.

use whit::{Ray, Shape, Vec3};

use crate::leaving::with_tracer;
use crate::naive::quadratic;
use crate::page::Page;
use crate::picture::picture;
use crate::seen::{Eye, Seen, checker, light};

const RADIUS: f32 = 6.371e6;
const GROUND: (Vec3<f32>, f32) = (Vec3::new(0.0, -RADIUS, 0.0), RADIUS);
const BALL: (Vec3<f32>, f32) = (Vec3::new(0.0, 1.0, 0.0), 1.0);
const EYE: Eye = Eye { position: Vec3::new(2.0, 1.7, 6.0), target: Vec3::new(0.0, 0.7, 0.0), half_height: 0.35 };

const TEXT: &str = "
## Scale: a small scene on a planet

A ball of radius 1 stands on a sphere of radius 6,371,000. One rounding of that radius is 0.4 units. On the left the
roots of the textbook, a normal offset of 0.001 and points worked out along the ray: |o − c|² − r² has lost all the digits
that tell how high the eye stands.
";

const ANSWER: &str = "
whit works out |o − c|² − r² in twice the digits where the origin is near the surface, takes the discriminant as b² − c
there, and moves points of a sphere that is larger than their coordinates by their level, in twice the digits too
(`src/intersect/sphere.rs`). Everywhere else a contact lies on a sphere whose radius differs by at most 8u times the
distance from the origin to the centre: spheres of radius 1e-3 to 1e6 at distances of 1e-2 to 1e6, up to 1e5 radii away from
the world's origin, stay within 4.5u of it in `tests/hard_cases_spheres/scale.rs`; the textbook's are off by up to 1e4·u.
";

pub fn write(page: &mut Page) -> Result<(), String> {
    let towards = Vec3::new(0.5, 1.0, 0.4).normalized();
    let naive = picture(|x, y| light(&EYE.ray(x, y), towards, textbook, leave_by_a_fixed_distance));
    let shapes = [GROUND, BALL].map(|(center, radius)| Shape::sphere(center, radius));
    let ours = with_tracer(&shapes, |tracer| {
        picture(|x, y| {
            let meet = |ray: &Ray<f32>| {
                let hit = tracer.intersect(ray)?;
                let normal = if hit.from_outside { hit.normal } else { -hit.normal };
                Some(seen(hit.object, hit.distance, hit.point, normal))
            };
            let leave = |ray: &Ray<f32>, _: &Seen, direction| match tracer.intersect(ray) {
                Some(hit) => hit.leave(direction),
                None => *ray,
            };
            light(&EYE.ray(x, y), towards, meet, leave)
        })
    });
    page.text(TEXT);
    page.pictures("planet", "A ball on a planet of radius 6,371 km: textbook roots, and whit.", &[&naive, &ours])?;
    page.text(ANSWER);
    Ok(())
}

fn seen(object: usize, distance: f32, point: Vec3<f32>, normal: Vec3<f32>) -> Seen {
    let color = if object == 0 { checker(point, 1.0) } else { whit::Rgb::new(0.2, 0.4, 0.75) };
    Seen { distance, point, normal, color }
}

fn textbook(ray: &Ray<f32>) -> Option<Seen> {
    let mut nearest: Option<Seen> = None;
    for (object, (center, radius)) in [GROUND, BALL].into_iter().enumerate() {
        let roots = quadratic::sphere(ray.origin, ray.direction, center, radius);
        let Some(t) = roots.and_then(|roots| roots.into_iter().find(|t| *t > 0.0)) else { continue };
        if nearest.is_none_or(|nearest| t < nearest.distance) {
            let point = ray.at(t);
            nearest = Some(seen(object, t, point, (point - center) * (1.0 / radius)));
        }
    }
    nearest
}

fn leave_by_a_fixed_distance(_: &Ray<f32>, seen: &Seen, direction: Vec3<f32>) -> Ray<f32> {
    Ray { origin: seen.point + seen.normal * 1e-3, direction }
}
