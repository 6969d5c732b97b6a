//! What the tests share.

use whit::scene::{Method, Profile, Steps};

pub use crate::world::ENOUGH;
use crate::world::{Bend, End, Number, Start, Target, Vector, World};

pub const UP: Vector = [0.0, 1.0, 0.0];

pub fn fixed(length: f64) -> Method<f64> {
    Method::Steps(Steps::Fixed { length })
}

pub fn controlled(tolerance: f64) -> Method<f64> {
    Method::Steps(Steps::Controlled { tolerance })
}

pub fn layers(thickness: f64) -> Method<f64> {
    Method::Layers { thickness }
}

/// In the plane z = 0, at an angle above the x axis, in radians.
pub fn start(x: f64, y: f64, angle: f64) -> Start {
    Start { origin: [x, y, 0.0], direction: [angle.cos(), angle.sin(), 0.0] }
}

/// The plane across the x axis.
pub fn wall(x: f64) -> Target {
    Target::Plane { point: [x, 0.0, 0.0], normal: [-1.0, 0.0, 0.0] }
}

/// A medium with a wall.
pub fn walled(profile: Profile<'_, f64>, x: f64) -> World<'_> {
    World { bend: Bend::Medium(profile), targets: vec![wall(x)] }
}

/// A hole of the mass 1 in the origin, with nothing around it.
pub fn hole(steps: Steps<f64>) -> World<'static> {
    World { bend: Bend::Hole { mass: 1.0, steps }, targets: vec![] }
}

/// Where a path meets a surface, and its direction there.
pub fn landing<T: Number>(world: &World<'_>, start: &Start) -> (Vector, Vector) {
    match world.follow::<T>(start, ENOUGH) {
        End::Surface { point, direction, .. } => (point, direction),
        other => panic!("{other:?}: {start:?} in {world:?}"),
    }
}

pub fn distance(a: Vector, b: Vector) -> f64 {
    [0, 1, 2].map(|i| a[i] - b[i]).iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The rows of a table, as text fields.
pub fn rows(table: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().skip(1).map(|line| line.split(',').collect())
}

pub fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// Root of the mean square.
pub fn mean(errors: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = errors.into_iter().fold((0.0, 0.0), |(sum, count), x| (sum + x * x, count + 1.0));
    (sum / count).sqrt()
}

/// With which power of the step an error goes: the slope of the line through their logarithms.
pub fn order(name: &str, steps: &[f64], error: impl Fn(f64) -> f64) -> f64 {
    let errors: Vec<f64> = steps.iter().map(|&step| error(step)).collect();
    let points: Vec<(f64, f64)> = steps.iter().zip(&errors).map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = points.len() as f64;
    let middle = (points.iter().map(|p| p.0).sum::<f64>() / count, points.iter().map(|p| p.1).sum::<f64>() / count);
    let along: f64 = points.iter().map(|p| (p.0 - middle.0) * (p.1 - middle.1)).sum();
    let order = along / points.iter().map(|p| (p.0 - middle.0).powi(2)).sum::<f64>();
    let list = |numbers: &[f64]| numbers.iter().map(|x| format!("{x:.1e}")).collect::<Vec<_>>().join(" ");
    println!("{name}: order {order:.2} of {} at {}", list(&errors), list(steps));
    order
}

/// A start value, halved so many times.
pub fn halved(first: f64, count: i32) -> Vec<f64> {
    (0..count).map(|i| first * 0.5_f64.powi(i)).collect()
}

/// A start value, divided by 10 so many times.
pub fn tenths(first: f64, count: i32) -> Vec<f64> {
    (0..count).map(|i| first * 0.1_f64.powi(i)).collect()
}

/// Fails where an error is not below a bound, and prints both.
pub fn assert_below(name: &str, error: f64, bound: f64) {
    println!("{name}: {error:.1e} of {bound:.1e}");
    assert!(error <= bound, "{name}: {error:e}, above {bound:e}");
}
