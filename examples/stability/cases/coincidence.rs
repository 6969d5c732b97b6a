//! Two surfaces in one place.

use whit::{Intersection, Rgb, Shape, Vec3};

use crate::leaving::with_tracer;
use crate::page::Page;
use crate::picture::picture;
use crate::seen::Eye;

const EYE: Eye = Eye { position: Vec3::new(1.0, 2.2, 4.0), target: Vec3::ZERO, half_height: 0.45 };
const NORMAL: Vec3<f32> = Vec3::new(0.36, 0.8, 0.48);
const COLORS: [Rgb<f32>; 2] = [Rgb::new(0.85, 0.6, 0.2), Rgb::new(0.2, 0.4, 0.75)];

pub fn write(page: &mut Page) -> Result<(), String> {
    let color = |object: Option<usize>| object.and_then(|i| COLORS.get(i)).copied().unwrap_or(Rgb::grey(0.1));
    // The same plane, given by another point of it and another length of its normal.
    let first = Shape::disc(Vec3::ZERO, NORMAL, 1.2);
    let second = Shape::disc(Vec3::new(0.8, 0.0, -0.6), NORMAL * 0.7, 1.2);
    let naive = with_tracer(&[first], |first| {
        with_tracer(&[second], |second| {
            picture(|x, y| {
                let distance = |hit: Option<Intersection<f32>>| hit.map_or(f32::MAX, |hit| hit.distance);
                let [a, b] = [first, second].map(|tracer| distance(tracer.intersect(&EYE.ray(x, y))));
                color((a.min(b) < f32::MAX).then_some(usize::from(b < a)))
            })
        })
    });
    let ours = with_tracer(&[first, second], |tracer| {
        picture(|x, y| color(tracer.intersect(&EYE.ray(x, y)).map(|hit| hit.object)))
    });
    page.text(
        "
## Coincidence

Two discs in one plane, the yellow one first in the list. Their planes are the same, but given by another point and a normal of
another length. On the left the nearer one by distance is seen, which rounding decides pixel by pixel; on the right whit's answer.
",
    );
    page.pictures("coincidence", "Coplanar discs: the nearer by distance, and whit.", &[&naive, &ours])?;
    page.text(
        "
whit's answer does not depend on the order of work, on rows, steps or workers. It is:

- **Equally near surfaces**: the first object in the list is seen. Surfaces whose distances differ by no more than 32
  roundings are equally near, so rounding never decides.
- **Glass flush with its water**, and other media whose surfaces coincide: both are crossed at once, and the one of higher priority
  ([`Medium::priority`](../src/scene/medium.rs)) counts; each border has the right pair of indices.
- **Touching surfaces**: an origin is moved by a few roundings of the coordinates and sizes at hand (on a sphere by at most 40u
  of the coordinates), so two surfaces farther apart than that are never confused. Nearer to a point of contact than that a ray may start inside of the neighbour.
- **An eye on a surface** is on the side that it looks to.
- **A light on a surface** is not in its shadow, to 2⁻¹³ of the distance. **A light inside an object** is, and a point exactly
  at a light gets none of it.

`tests/hard_cases_optics` (`coincidence.rs`, `coplanar_surfaces.rs`, `coincident_media.rs`, `eyes_and_lights.rs`) holds whit to
these answers.
",
    );
    Ok(())
}
