//! Light that is turned round goes back to where it came from.

use whit::scene::Steps;

use crate::exact::glass::{exponential, fish_eye, linear, luneburg, parabolic};
use crate::exact::mirage::air;
use crate::support::{assert_below, controlled, distance, fixed, hole, landing, layers, start, walled};
use crate::world::{Bend, Number, Start, Target, World};

/// By how much a path misses its start, in scene units, and its direction there, on the way back from a target.
fn misses<T: Number>(bend: Bend<'_>, target: Target, from: &Start) -> [f64; 2] {
    let (point, direction) = landing::<T>(&World { bend, targets: vec![target] }, from);
    let back = Start { origin: point, direction: direction.map(|x| -x) };
    let gate = Target::Plane { point: from.origin, normal: from.direction };
    let (origin, arriving) = landing::<T>(&World { bend, targets: vec![gate] }, &back);
    [distance(origin, from.origin), distance(arriving, from.direction.map(|x| -x))]
}

/// Bounds of the place and of the direction, and what `f32` adds to them.
#[derive(Clone, Copy)]
struct Bounds([f64; 2], [f64; 2]);

fn check(name: &str, bend: Bend<'_>, target: Target, from: &Start, Bounds(double, more): Bounds) {
    let found = [misses::<f64>(bend, target, from), misses::<f32>(bend, target, from)];
    for (i, what) in ["place", "direction"].into_iter().enumerate() {
        assert_below(&format!("{name}, {what}, f64"), found[0][i], double[i]);
        assert_below(&format!("{name}, {what}, f32"), found[1][i], double[i] + more[i]);
    }
}

fn wall(x: f64) -> Target {
    walled(linear(fixed(1.0)), x).targets[0]
}

#[test]
fn in_glass() {
    // Layers are exact, but for a start on the border of two of them.
    let methods = [
        (controlled(1e-4), Bounds([1e-3, 1e-4], [1e-5; 2])),
        (controlled(1e-6), Bounds([3e-5, 1e-6], [1e-5; 2])),
        (fixed(0.05), Bounds([2e-3, 2e-3], [1e-5; 2])),
        (fixed(0.01), Bounds([1e-4, 1e-4], [1e-5; 2])),
        (layers(0.01), Bounds([1e-12, 3e-2], [1e-5; 2])),
    ];
    for (method, bounds) in methods {
        for (name, profile, x, from) in [
            ("linear", linear(method), 1.5, start(0.0, 0.1, 0.4)),
            ("parabolic", parabolic(method), 2.0, start(0.0, 0.3, 0.4)),
            ("exponential", exponential(method), 0.9, start(0.0, 0.1, 0.5)),
            ("Luneburg", luneburg(method), 0.6, start(-0.4, 0.3, 0.2)),
            ("Luneburg from outside", luneburg(method), 1.5, start(-2.0, 0.4, 0.0)),
            ("fish-eye", fish_eye(method), 0.8, start(-0.4, 0.3, 0.5)),
        ] {
            check(&format!("{name} {method:?}"), Bend::Medium(profile), wall(x), &from, bounds);
        }
    }
}

#[test]
fn in_air() {
    for (method, bounds) in [
        (controlled(1e-6), Bounds([2e-5, 1e-7], [5e-4, 2e-6])),
        (fixed(0.5), Bounds([1e-8, 1e-10], [5e-4, 2e-6])),
        (layers(1e-4), Bounds([1e-12, 1e-12], [5e-4, 2e-6])),
    ] {
        for angle in [1e-3, 3e-3, 5e-3, 6.5e-3] {
            let from = start(0.0, 1.5, -angle);
            check(&format!("{angle} {method:?}"), Bend::Medium(air(method)), wall(800.0), &from, bounds);
        }
    }
}

#[test]
fn around_a_hole() {
    let below = Target::Plane { point: [0.0, -8.0, 0.0], normal: [0.0, 1.0, 0.0] };
    for (steps, bounds) in [
        (Steps::Controlled { tolerance: 1e-5 }, Bounds([5e-3, 1e-4], [5e-2, 1e-3])),
        (Steps::Controlled { tolerance: 1e-7 }, Bounds([5e-5, 2e-6], [2e-2, 1e-3])),
        (Steps::Fixed { length: 0.02 }, Bounds([2e-2, 1e-3], [2e-2, 1e-3])),
        (Steps::Fixed { length: 0.005 }, Bounds([2e-3, 1e-4], [5e-2, 2e-3])),
    ] {
        for b in [5.4, 6.0, 8.0, 15.0, 25.0] {
            let from = start(-30.0, b, 0.0);
            check(&format!("b = {b} {steps:?}"), hole(steps).bend, below, &from, bounds);
        }
    }
}
