//! Ordinary differential equations y′ = f(y), and curves between the ends of their steps.

use std::ops::{Add, Mul, Sub};

/// The end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Step<const N: usize> {
    /// y there, less y at the start.
    pub change: [f64; N],
    /// The difference to the solution of fourth order.
    pub error: [f64; N],
}

/// J. R. Dormand and P. J. Prince, A Family of Embedded Runge-Kutta Formulae, 1980: of fifth order, with seven stages,
/// each the weights of the ones before.
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// One step of length h. `f` gets y less its start.
pub fn step<const N: usize>(f: impl Fn(&[f64; N]) -> [f64; N], h: f64) -> Step<N> {
    let mut slopes = [[0.0; N]; 7];
    let sum = |slopes: &[[f64; N]; 7], weights: &[f64]| -> [f64; N] {
        let mut sum = [0.0; N];
        for (weight, slope) in weights.iter().zip(slopes) {
            for i in 0..N {
                sum[i] += h * weight * slope[i];
            }
        }
        sum
    };
    slopes[0] = f(&[0.0; N]);
    let mut change = [0.0; N];
    for (i, weights) in STAGES.iter().enumerate() {
        change = sum(&slopes, weights);
        slopes[i + 1] = f(&change);
    }
    Step { change, error: sum(&slopes, &ERROR) }
}

/// The factor on the length of a step for the next one, from its error as a share of the one allowed.
pub fn growth(error: f64) -> f64 {
    if error.is_finite() { (0.9 * error.powf(-0.2)).clamp(0.2, 5.0) } else { 0.2 }
}

/// A value and its first two derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Jet<V> {
    pub value: V,
    pub first: V,
    pub second: V,
}

/// The value, at a share of a step of length h, of the polynomial of fifth degree that has these ends, and its first
/// derivative.
pub fn between<V>(start: &Jet<V>, end: &Jet<V>, h: f64, share: f64) -> [V; 2]
where
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<f64, Output = V>,
{
    // Exactly, for pieces of one path to join without gaps.
    if share == 1.0 {
        return [end.value, end.first];
    }
    let (a, b, t) = (start, end, share);
    let rise = b.value - a.value;
    let cubic = rise * 10.0 - a.first * (6.0 * h) - b.first * (4.0 * h) + (b.second - a.second * 3.0) * (0.5 * h * h);
    let quartic =
        a.first * (8.0 * h) + b.first * (7.0 * h) - rise * 15.0 + (a.second * 3.0 - b.second * 2.0) * (0.5 * h * h);
    let quintic = rise * 6.0 - (a.first + b.first) * (3.0 * h) + (b.second - a.second) * (0.5 * h * h);
    let (linear, square) = (a.first * h, a.second * (0.5 * h * h));
    let value = a.value + (linear + (square + (cubic + (quartic + quintic * t) * t) * t) * t) * t;
    let first = linear + (square * 2.0 + (cubic * 3.0 + (quartic * 4.0 + quintic * (5.0 * t)) * t) * t) * t;
    [value, first * (1.0 / h)]
}

/// A root of a function that has both signs between the ends of a stretch, by Newton's method held in it. `f` gives the
/// value and its slope.
pub fn root(f: impl Fn(f64) -> [f64; 2], mut low: f64, mut high: f64, tolerance: f64) -> f64 {
    const MOST: usize = 100;
    let rises = f(high)[0] >= 0.0;
    let mut x = 0.5 * (low + high);
    for _ in 0..MOST {
        let [value, slope] = f(x);
        if value.abs() <= tolerance {
            return x;
        }
        if (value > 0.0) == rises {
            high = x;
        } else {
            low = x;
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if next == x {
            return x;
        }
        x = next;
    }
    x
}
