//! Light over a warm ground, n = 1 + excess/(1 + ratio·e^(−y/scale)), that comes down, turns and goes up again.

use whit::Vec3;
use whit::scene::{Law, Level, Method, Profile};

/// 0.0789/300: air of 300 K.
const EXCESS: f64 = 0.000_263;
/// 30 K of 300.
const RATIO: f64 = 0.1;
const SCALE: f64 = 0.02;
/// Above this height the index varies by less than 1e-17.
pub const TOP: f64 = 0.6;

/// That air.
pub fn air(method: Method<f64>) -> Profile<'static, f64> {
    let level = Level::Height { origin: Vec3::ZERO, up: Vec3::new(0.0, 1.0, 0.0) };
    Profile { level, from: 0.0, to: TOP, law: Law::Thermal { excess: EXCESS, ratio: RATIO, scale: SCALE }, method }
}

/// At which height, and how far away, light turns that comes from a height at an angle below the horizontal, in radians.
/// `None` where it meets the ground.
pub fn turning(eye: f64, angle: f64) -> Option<(f64, f64)> {
    let above = |y: f64| EXCESS / (1.0 + RATIO * (-y / SCALE).exp());
    // What n − 1 is where the light is level: n·cos θ stays the same.
    let at_turn = above(eye) - (1.0 + above(eye)) * 2.0 * (angle / 2.0).sin().powi(2);
    let height = -SCALE * ((EXCESS / at_turn - 1.0) / RATIO).ln();
    (height > 0.0).then(|| (height, distance(eye, height, at_turn)))
}

/// ∫ p/√(n² − p²) dy from the turning height to the eye, p being the index where the light turns; with y = turn + s², by
/// Simpson's rule.
fn distance(eye: f64, turn: f64, at_turn: f64) -> f64 {
    const PARTS: u32 = 20_000;
    let warmth = RATIO * (-turn / SCALE).exp();
    let integrand = |s: f64| {
        let fall = -(-s * s / SCALE).exp_m1(); // 1 − e^(−s²/scale)
        let warmth_here = warmth * (1.0 - fall);
        let rise = EXCESS * warmth * fall / ((1.0 + warmth) * (1.0 + warmth_here));
        let square = rise * (2.0 + 2.0 * at_turn + rise); // n² − p²
        let per_square = if s > 0.0 { square / (s * s) } else { first_slope(warmth, at_turn) };
        2.0 * (1.0 + at_turn) / per_square.sqrt()
    };
    let width = (eye - turn).sqrt() / f64::from(PARTS);
    let weight = |i: u32| if i == 0 || i == PARTS { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    (0..=PARTS).map(|i| weight(i) * integrand(width * f64::from(i))).sum::<f64>() * width / 3.0
}

/// d(n²)/dy where the light turns.
fn first_slope(warmth: f64, at_turn: f64) -> f64 {
    2.0 * (1.0 + at_turn) * EXCESS * warmth / (SCALE * (1.0 + warmth).powi(2))
}
