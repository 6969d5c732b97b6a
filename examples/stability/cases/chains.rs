//! Many bounces.

use whit::Vec3;
use whit::optics::reflect;

use crate::leaving::unit_vector;
use crate::naive::reflect as textbook;
use crate::page::Page;

const BOUNCES: u32 = 64;
const UNIT: f64 = f32::EPSILON as f64 / 2.0;

fn length(v: Vec3<f32>) -> f64 {
    let v = v.map(f64::from);
    v.dot(v).sqrt()
}

/// How far from 1 the length of a direction is after some bounces at mirrors of all directions, in roundings; the worst of many
/// chains: by the textbook formula, and with the length set right as whit does.
fn drift() -> [f64; 2] {
    let mut random = fastrand::Rng::with_seed(13);
    let mut worst = [0.0_f64; 2];
    for _ in 0..1000 {
        let start = unit_vector(&mut random);
        let (mut naive, mut ours) = (start, start);
        for _ in 0..BOUNCES {
            let normal = unit_vector(&mut random);
            let array = |v: Vec3<f32>| [v.x, v.y, v.z];
            naive = Vec3::from(textbook::reflect(array(naive), array(normal)));
            ours = reflect(ours, normal, -ours.dot(normal)).normalized();
        }
        let off = |v| (length(v) - 1.0).abs() / UNIT;
        worst = [worst[0].max(off(naive)), worst[1].max(off(ours))];
    }
    worst
}

pub fn write(page: &mut Page) -> Result<(), String> {
    let [naive, ours] = drift();
    page.text(&format!(
        "
## Long chains

After {BOUNCES} reflections at mirrors of all directions the length of a direction is off by up to {naive:.0}u in the textbook's
D − 2(D·N)N; distances and cosines are off with it. whit sets each new direction to length 1: {ours:.1}u. Between facing
mirrors at depth 64 the images lie where unfolding the path in `f64` puts them, light inside a ball of glass keeps its angle
over 64 total reflections, and lossless glass in a white furnace is white at depth 64 (`tests/hard_cases_optics/chains.rs`,
`tests/furnace.rs`).
"
    ));
    Ok(())
}
