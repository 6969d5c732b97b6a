//! With one step too few a path ends out of steps; with as many as it takes, where it ends with more.

use whit::scene::{Method, Steps};

use crate::exact::glass::{exponential, linear, luneburg};
use crate::exact::mirage::air;
use crate::support::{ENOUGH, controlled, fixed, hole, layers, start, walled};
use crate::world::{End, Number, Start, World};

fn check<T: Number>(world: &World<'_>, from: &Start) {
    let needed = world.steps::<T>(from).unwrap();
    let end = world.follow::<T>(from, ENOUGH);
    println!("{needed} steps to {end:?}");
    assert_eq!(world.follow::<T>(from, needed), end);
    assert_ne!(end, End::OutOfSteps);
    for fewer in [needed - 1, needed / 2, 0] {
        assert_eq!(world.follow::<T>(from, fewer), End::OutOfSteps, "{fewer} of {needed}");
    }
}

const METHODS: [fn() -> Method<f64>; 3] = [|| controlled(1e-4), || fixed(0.05), || layers(0.05)];

#[test]
fn in_media() {
    for method in METHODS {
        for world in
            [walled(exponential(method()), 0.7), walled(luneburg(method()), 0.5), walled(luneburg(method()), 5.0)]
        {
            let from = start(-0.2, 0.1, 0.4);
            check::<f32>(&world, &from);
            check::<f64>(&world, &from);
        }
        // Through the lens and away.
        let world = World { targets: vec![], ..walled(luneburg(method()), 5.0) };
        check::<f32>(&world, &start(-2.0, 0.3, 0.0));
        check::<f64>(&world, &start(-2.0, 0.3, 0.0));
    }
    for method in [controlled(1e-5), fixed(1.0), layers(1e-3)] {
        check::<f32>(&walled(air(method), 700.0), &start(0.0, 1.5, -3e-3));
    }
}

#[test]
fn around_a_hole() {
    for steps in [Steps::Controlled { tolerance: 1e-5 }, Steps::Fixed { length: 0.05 }] {
        for b in [1.0, 5.0, 5.2, 8.0, 40.0] {
            check::<f32>(&hole(steps), &start(-100.0, b, 0.0));
            check::<f64>(&hole(steps), &start(-100.0, b, 0.0));
        }
    }
}

/// Light that is not bent any more takes no steps.
#[test]
fn light_on_its_way_out_takes_none() {
    let away = start(1e9, 1.0, 0.0);
    assert!(matches!(hole(Steps::Controlled { tolerance: 1e-5 }).follow::<f32>(&away, 0), End::Away(_)));
}

/// Walls at the ends of steps, and some roundings before and behind them, are met.
#[test]
fn walls_between_steps_are_met() {
    let length = 0.25_f64;
    // From the origin along the layers of n² = 2.25 − 0.3·y each step is as long as the others, along them.
    for k in 1..=8 {
        for ulps in -20..=20 {
            let x = f64::from(f32::from_bits(((length * f64::from(k)) as f32).to_bits().wrapping_add_signed(ulps)));
            for method in [fixed(length), controlled(1e-2), controlled(3e-5)] {
                for angle in [0.0, -40.0_f64.to_radians()] {
                    let end = walled(linear(method), x).follow::<f32>(&start(0.0, 0.0, angle), ENOUGH);
                    assert!(matches!(end, End::Surface { .. }), "{x} {method:?} {angle}: {end:?}");
                }
            }
        }
    }
}

/// Steps of fixed length are as many as fit in the path, and one for the rest of it.
#[test]
fn steps_are_counted() {
    for length in [0.3, 0.1, 0.01] {
        let (world, from) = (walled(linear(fixed(length)), 2.0), start(0.0, 0.0, 0.3));
        for (steps, end) in [
            (world.steps::<f32>(&from), world.follow::<f32>(&from, ENOUGH)),
            (world.steps::<f64>(&from), world.follow::<f64>(&from, ENOUGH)),
        ] {
            let End::Surface { distance, .. } = end else { panic!("{end:?}") };
            let (counted, fitting) = (f64::from(steps.unwrap()), distance / length);
            assert!((counted - fitting).abs() < 0.02 * fitting + 1.5, "{counted} {fitting}");
        }
    }
}
