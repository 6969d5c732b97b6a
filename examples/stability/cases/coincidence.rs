//! Two surfaces in one place.

use whit::{Rgb, Shape, Vec3};

use crate::leaving::with_tracer;
use crate::page::Page;
use crate::picture::picture;
use crate::seen::Eye;

const EYE: Eye = Eye { position: Vec3::new(1.0, 2.2, 4.0), target: Vec3::ZERO, half_height: 0.45 };
const NORMAL: Vec3<f32> = Vec3::new(0.36, 0.8, 0.48);
const COLORS: [Rgb<f32>; 2] = [Rgb::new(0.85, 0.6, 0.2), Rgb::new(0.2, 0.4, 0.75)];

pub fn write(page: &mut Page) -> Result<(), String> {
    let color = |object: Option<usize>| object.and_then(|i| COLORS.get(i)).copied().unwrap_or(Rgb::grey(0.1));
    let draw = |discs: [Shape<'static, f32>; 2]| {
        with_tracer(&discs, |tracer| picture(|x, y| color(tracer.intersect(&EYE.ray(x, y)).map(|hit| hit.object))))
    };
    // The same plane, given by another point of it and another length of its normal.
    let moved = Vec3::new(0.8, 0.0, -0.6);
    let apart = draw([Shape::disc(Vec3::ZERO, NORMAL, 1.2), Shape::disc(moved, NORMAL * 0.7, 1.2)]);
    let same = draw([Shape::disc(Vec3::ZERO, NORMAL, 1.2), Shape::disc(Vec3::ZERO, NORMAL, 0.8)]);
    page.text(
        "
## Coincidence

Two discs in one plane, the yellow one first in the list. On the left the planes are the same in exact numbers but given by different
ones, so rounding decides which is nearer, pixel by pixel; on the right they are given by the same numbers.
",
    );
    page.pictures(
        "coincidence",
        "Coplanar discs: given by different numbers, and by the same ones.",
        &[&apart, &same],
    )?;
    page.text(
        "
whit's answer does not depend on the order of work, on rows, steps or workers. It is:

- **Equally near surfaces**: the first object in the list is seen. Surfaces given by the same numbers are equally near. Others
  that coincide in exact numbers only are as near as rounding makes them, and show it; give them the same numbers or
  let them overlap.
- **Glass flush with its water**: let the water overlap the glass a little and give the glass the higher priority
  ([`Medium::priority`](../src/scene/medium.rs)); then each border has the right pair of indices.
- **Touching surfaces**: an origin is moved by at most 40u of its coordinates, so two surfaces farther apart than that are
  never confused. Nearer to a point of contact than that a ray may start inside of the neighbour.
- **An eye on a surface** is on no side of it: it sees what is in front of it. **A light on a surface or inside an object** is in
  the shadow of that object like any other; a point exactly at a light gets none of it.
",
    );
    Ok(())
}
