//! What stands around a black hole is met where the orbit gets to it.

use whit::scene::Steps;

use crate::orbit::{Orbit, impact_parameter};
use crate::support::{ENOUGH, assert_below, distance, halved, hole, landing, order, tenths};
use crate::world::{End, Number, Start, Target, Vector, World};

/// Paths from the distance 30 in all directions that are not straight to the hole, with different impact parameters, in a
/// plane that is along none of the axes.
fn paths() -> Vec<Start> {
    let tilt = |[x, y]: [f64; 2]| [0.36 * x - 0.8 * y, 0.48 * x + 0.6 * y, 0.8 * x];
    let bs = [5.3, 5.5, 6.0, 7.0, 10.0, 15.0, 25.0, -5.4, -6.5, -12.0];
    let start = |b: f64| {
        let sine = b / 30.0;
        Start { origin: tilt([-30.0, 0.0]), direction: tilt([(1.0 - sine * sine).sqrt(), sine]) }
    };
    bs.map(start).to_vec()
}

fn around(steps: Steps<f64>, target: Target) -> World<'static> {
    World { targets: vec![target], ..hole(steps) }
}

fn exact(start: &Start, radius: f64) -> (Vector, Vector) {
    match Orbit::new(start).end(Some(radius)) {
        End::Surface { point, direction, .. } => (point, direction),
        other => panic!("{other:?}"),
    }
}

/// By how much the place on a sphere of radius 40 is off, as a share of the radius, and the direction there.
fn errors<T: Number>(steps: Steps<f64>) -> [Vec<f64>; 2] {
    let world = around(steps, Target::Sphere { center: [0.0; 3], radius: 40.0 });
    let error = |start: &Start| {
        let (found, known) = (landing::<T>(&world, start), exact(start, 40.0));
        [distance(found.0, known.0) / 40.0, distance(found.1, known.1)]
    };
    let errors: Vec<_> = paths().iter().map(error).collect();
    [0, 1].map(|i| errors.iter().map(|error| error[i]).collect())
}

fn check<T: Number>(steps: Steps<f64>, bound: f64) {
    let name = format!("{steps:?}, f{}", 8 * size_of::<T>());
    for (errors, what) in errors::<T>(steps).into_iter().zip(["place", "direction"]) {
        assert_below(&format!("{name}, {what}"), errors.into_iter().fold(0.0, f64::max), bound);
    }
}

#[test]
fn controlled_steps() {
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        check::<f64>(Steps::Controlled { tolerance }, 10.0 * tolerance);
        check::<f32>(Steps::Controlled { tolerance }, 10.0 * tolerance + 2e-4);
    }
}

#[test]
fn fixed_steps() {
    for length in [0.05, 0.02, 0.01] {
        check::<f64>(Steps::Fixed { length }, 10.0 * length * length);
        check::<f32>(Steps::Fixed { length }, 10.0 * length * length + 3e-4);
    }
}

#[test]
fn orders() {
    let mean = |steps| crate::support::mean(errors::<f64>(steps)[0].clone());
    let fixed = order("fixed", &halved(0.05, 5), |length| mean(Steps::Fixed { length }));
    let controlled = order("controlled", &tenths(1e-3, 5), |tolerance| mean(Steps::Controlled { tolerance }));
    assert!((1.8..2.2).contains(&fixed) && (0.8..1.6).contains(&controlled), "{fixed} {controlled}");
}

/// A small ball on the orbit is met, and one next to it is not.
#[test]
fn small_balls() {
    let steps = Steps::Controlled { tolerance: 1e-5 };
    for start in paths() {
        for away in [8.0, 12.0, 20.0, 40.0] {
            let outgoing = exact_outside(&start, away);
            let Some((point, direction)) = outgoing else { continue };
            let ball = |center| around(steps, Target::Sphere { center, radius: 0.05 });
            let side = across(direction);
            let shifted = |s: f64| [0, 1, 2].map(|i| point[i] + s * side[i]);
            for (shift, met) in [(0.0, true), (0.045, true), (-0.045, true), (0.055, false), (-0.055, false)] {
                for end in [
                    ball(shifted(shift)).follow::<f32>(&start, ENOUGH),
                    ball(shifted(shift)).follow::<f64>(&start, ENOUGH),
                ] {
                    assert_eq!(matches!(end, End::Surface { .. }), met, "{start:?} {away} {shift}: {end:?}");
                }
            }
        }
    }
}

/// Where an orbit that has gone around the hole gets to a distance on its way out.
fn exact_outside(start: &Start, radius: f64) -> Option<(Vector, Vector)> {
    let mut orbit = Orbit::new(start);
    for _ in 0..100_000 {
        orbit = orbit.after(1e-3);
        let (point, direction) = orbit.place();
        let r = distance(point, [0.0; 3]);
        let outwards = crate::orbit::dot(point, direction) > 0.0;
        if outwards && r > radius {
            return (r < 2.0 * radius).then_some((point, direction));
        }
    }
    None
}

/// A unit vector across another one.
fn across([x, y, z]: Vector) -> Vector {
    let size = (x * x + y * y).sqrt();
    if size > 0.1 { [y / size, -x / size, 0.0] } else { [1.0, 0.0, -x / z] }
}

/// The impact parameter on the way out is that on the way in.
#[test]
fn the_impact_parameter_stays() {
    for (steps, bound, single) in [
        (Steps::Controlled { tolerance: 1e-4 }, 1e-3, 1e-3),
        (Steps::Controlled { tolerance: 1e-6 }, 2e-6, 2e-5),
        (Steps::Fixed { length: 0.05 }, 1e-3, 1e-3),
        (Steps::Fixed { length: 0.01 }, 1e-4, 1e-4),
    ] {
        let world = around(steps, Target::Sphere { center: [0.0; 3], radius: 40.0 });
        for start in paths() {
            let before = impact_parameter(start.origin, start.direction);
            for ((point, direction), bound) in
                [(landing::<f64>(&world, &start), bound), (landing::<f32>(&world, &start), single)]
            {
                let change = impact_parameter(point, direction) / before - 1.0;
                assert_below(&format!("{steps:?} {before}"), change.abs(), bound);
            }
        }
    }
}
