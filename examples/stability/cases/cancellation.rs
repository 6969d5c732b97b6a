//! A small sphere far away.

use whit::{Ray, Rgb, Shape, Vec3};

use crate::leaving::with_tracer;
use crate::naive::quadratic;
use crate::page::Page;
use crate::picture::{differing, picture};
use crate::seen::Eye;

const DISTANCE: f32 = 6000.0;
const EYE: Eye = Eye {
    position: Vec3::new(0.8 * DISTANCE, 0.36 * DISTANCE, 0.48 * DISTANCE),
    target: Vec3::ZERO,
    half_height: 1.3 / DISTANCE,
};

const TEXT: &str = "
## Cancellation: a small sphere far away

A sphere of radius 1, seen from 6,000 away through a telescope, and its first root. In b² − 4ac both terms are 36 million
times the square of the radius.
";

pub fn write(page: &mut Page) -> Result<(), String> {
    let shade = |x: f32, y: f32, t: Option<f32>| {
        // From near to far, over the two radii between the front and the back of the sphere.
        let depth = t.map(|t| ((t - (DISTANCE - 1.0)) * 0.5).clamp(0.0, 1.0));
        let _ = (x, y);
        depth.map_or(Rgb::grey(0.02), |depth| Rgb::new(1.0, 0.9, 0.7) * (1.0 - 0.9 * depth))
    };
    let naive = picture(|x, y| {
        let Ray { origin, direction } = EYE.ray(x, y);
        shade(x, y, quadratic::sphere(origin, direction, Vec3::ZERO, 1.0).map(|[near, _]| near))
    });
    let ours = with_tracer(&[Shape::sphere(Vec3::ZERO, 1.0)], |tracer| {
        picture(|x, y| shade(x, y, tracer.intersect(&EYE.ray(x, y)).map(|hit| hit.distance)))
    });
    page.text(TEXT);
    let caption =
        format!("Depth of a sphere 6,000 radii away: b² − 4ac, and whit; {} pixels differ.", differing(&naive, &ours));
    page.pictures("far", &caption, &[&naive, &ours])?;
    page.text(
        "whit takes the discriminant as r² less the square of the distance between the centre and the ray, worked out across \
         the ray, and one root from the product of the two (Haines, Günther and Akenine-Möller, Ray Tracing Gems, 2019). Of \
         1,800 rays with exactly known roots (far, tiny, grazing, huge and just-left spheres) the textbook form misjudges \
         79, whit none, and its roots stay within 2u of the distance, across the surface (`tests/hard_cases_spheres/cancellation.rs`).",
    );
    Ok(())
}
