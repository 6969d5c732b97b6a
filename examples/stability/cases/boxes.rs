//! Rays in the planes of a box's faces.

use whit::{Ray, Rgb, Shape, Vec3};

use crate::leaving::with_tracer;
use crate::naive::slab;
use crate::page::Page;
use crate::picture::{differing, picture};

const COLORS: [Rgb<f32>; 3] = [Rgb::new(0.85, 0.6, 0.2), Rgb::new(0.2, 0.5, 0.4), Rgb::new(0.6, 0.25, 0.3)];
/// Pixels of a unit.
const SCALE: f32 = 15.0;

/// Panels in a row whose faces touch, each a little behind the one before; the last ones have no thickness.
fn panels() -> Vec<(Vec3<f32>, Vec3<f32>)> {
    (0..14)
        .map(|i| {
            let (x, z) = (i as f32 + 1.0, i as f32 * -0.5);
            let depth = if i < 9 { 1.0 } else { 0.0 };
            (Vec3::new(x, 1.0 + 0.5 * (i % 3) as f32, z - depth), Vec3::new(x + 1.0, 9.0, z))
        })
        .collect()
}

/// A parallel view along z in which every 15th column of pixels runs in the plane of a face, with x = +0 or −0 in its
/// direction.
fn ray(x: f32, y: f32) -> Ray<f32> {
    let (x, y) = (x.floor() / SCALE, (180.0 - y.floor()) / SCALE);
    let zero = if (y as i32) % 2 == 0 { 0.0 } else { -0.0 };
    Ray { origin: Vec3::new(x, y, 10.0), direction: Vec3::new(zero, zero, -1.0) }
}

fn color(nearest: Option<usize>) -> Rgb<f32> {
    let panel = nearest.and_then(|i| COLORS.get(i % COLORS.len()));
    panel.copied().unwrap_or(Rgb::new(0.02, 0.02, 0.03))
}

pub fn write(page: &mut Page) -> Result<(), String> {
    let panels = panels();
    let naive = picture(|x, y| {
        let Ray { origin: o, direction: d } = ray(x, y);
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        let entries = panels
            .iter()
            .enumerate()
            .filter_map(|(i, (min, max))| Some((slab::intersect(array(o), array(d), array(*min), array(*max))?, i)));
        color(entries.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i))
    });
    let shapes: Vec<_> = panels.iter().map(|&(min, max)| Shape::axis_box(min, max)).collect();
    let ours = with_tracer(&shapes, |tracer| picture(|x, y| color(tracer.intersect(&ray(x, y)).map(|hit| hit.object))));
    page.text(
        "
## Boxes: 0·∞

Panels side by side, in a parallel view whose columns of pixels run in the planes of their faces; the five on the right have no
thickness. Along a slab the slab test multiplies 0 by ∞, and a comparison with what is not a number is false. Which
branch that takes depends on the sign of a zero in the direction.
",
    );
    let caption = format!("Panels: a slab test without care, and whit; {} pixels differ.", differing(&naive, &ours));
    page.pictures("panels", &caption, &[&naive, &ours])?;
    page.text(
        "whit asks first whether the ray runs along the slab, and whether inside (`src/intersect/axis_box.rs`). A box has its \
         faces: what runs in one meets the box, +0 and −0 give the same answer, and a box of no thickness is a sheet. Of two \
         faces at the same place the first object in the list is seen.",
    );
    Ok(())
}
