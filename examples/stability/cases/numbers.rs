//! Numbers at the ends of their ranges.

use crate::leaving::unit_vector;
use crate::naive::{attenuation, highlight};
use crate::page::Page;
use whit::optics::transmittance;
use whit::{Rgb, Vec3};

pub fn write(page: &mut Page) -> Result<(), String> {
    let mut random = fastrand::Rng::with_seed(17);
    let array = |v: Vec3<f32>| [v.x, v.y, v.z];
    let mut rows = vec![["exponent", "largest (N·H)ˢ", "whit"].map(str::to_owned).to_vec()];
    let normals: Vec<_> = (0..100_000).map(|_| array(unit_vector(&mut random))).collect();
    for exponent in [1e3_f32, 1e5, 1e7, 1e9] {
        let worst = normals.iter().map(|&n| highlight::highlight(n, n, exponent)).fold(0.0, f32::max);
        rows.push(vec![format!("{exponent:e}"), format!("{worst:.4e}"), "1".to_owned()]);
    }
    let steps = attenuation::transmittance(30.0, 10.0, 100);
    let exact = transmittance(Rgb::grey(30.0_f32), 10.0).r;
    page.text(
        "
## Numbers at the edge

A cosine of two unit vectors may round to a little more than 1, and a high exponent makes a lot of that:
",
    );
    page.table(&rows);
    page.text(&format!(
        "whit holds cosines at 1. What a medium leaves of light underflows to 0 and never grows: of constant 30 over distance \
         10 it leaves {exact}; a hundred Euler steps make {steps:.1e} of it. 0⁰ is 1 and belongs to a highlight of exponent 0. \
         Lights, colours and factors up to 1e12 each may multiply to more than `f32` holds: such light is the largest number, what \
         nothing of it gets through is black, and no pixel is infinite or not a number (`tests/hard_cases_optics/numbers.rs`, \
         `tests/extremes.rs`)."
    ));
    Ok(())
}
