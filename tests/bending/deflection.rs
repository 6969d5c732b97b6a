//! By which angle a black hole bends light from far away.
//!
//! Next to the critical impact parameter the angle goes with the logarithm of what is missing to it, so an error of b is
//! one of error/(b − b_critical) in the angle. In `f32` the table's b are rounded, and the exact angle is that of the rounded
//! one.

use std::f64::consts::TAU;

use whit::scene::Steps;

use crate::exact::deflection::{CRITICAL, deflection};
use crate::support::{ENOUGH, halved, hole, mean, number, order, rows, start, tenths};
use crate::tables::DEFLECTION;
use crate::world::{End, Number};

/// How far away light starts.
const FAR: f64 = 1e6;

/// The error of the angle, in radians; `None` if the light does not come back.
fn error<T: Number>(steps: Steps<f64>, b: f64) -> Option<f64> {
    let End::Away([x, y, _]) = hole(steps).follow::<T>(&start(-FAR, b, 0.0), ENOUGH) else { return None };
    let error = (-y).atan2(x) - deflection(T::of(b).get());
    Some(error - (error / TAU).round() * TAU)
}

fn impact_parameters() -> Vec<f64> {
    rows(DEFLECTION).map(|row| number(row[0])).collect()
}

/// The error that a relative error of b makes.
fn condition(b: f64) -> f64 {
    1.0 / (b / CRITICAL - 1.0)
}

/// All rows, with an error of at most `absolute` and that of a relative error of b.
fn check<T: Number>(steps: Steps<f64>, absolute: f64, relative: f64) {
    for b in impact_parameters() {
        let rounded = T::of(b).get();
        let uncertain = relative > rounded / CRITICAL - 1.0;
        let bound = absolute + relative * condition(rounded);
        match error::<T>(steps, b) {
            Some(error) => {
                println!("{} {steps:?} b = {b}: {error:.1e} of {bound:.1e}", size_of::<T>() * 8);
                assert!(error.abs() <= bound || uncertain, "{b}: {error:e}");
            }
            None => assert!(uncertain, "{b} is captured"),
        }
    }
}

#[test]
fn controlled_steps() {
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        check::<f64>(Steps::Controlled { tolerance }, 0.5 * tolerance, 0.5 * tolerance);
        check::<f32>(Steps::Controlled { tolerance }, 0.5 * tolerance + 5e-6, 0.5 * tolerance + 3e-6);
    }
}

#[test]
fn fixed_steps() {
    for length in [0.1, 0.05, 0.02, 0.01] {
        check::<f64>(Steps::Fixed { length }, 0.2 * length * length, 0.5 * length * length);
        check::<f32>(Steps::Fixed { length }, 0.2 * length * length + 2e-5, 0.5 * length * length + 1e-5);
    }
}

#[test]
fn orders() {
    let errors = |steps| mean([5.5, 6.0, 8.0, 10.0, 20.0].map(|b| error::<f64>(steps, b).unwrap()));
    let fixed = order("fixed", &halved(0.05, 5), |length| errors(Steps::Fixed { length }));
    let controlled = order("controlled", &tenths(1e-3, 5), |tolerance| errors(Steps::Controlled { tolerance }));
    assert!((1.9..2.1).contains(&fixed) && (0.8..1.6).contains(&controlled), "{fixed} {controlled}");
}

/// Far from the hole light is bent by 4M/b + 15π/4·(M/b)² + …
#[test]
fn weak_fields() {
    for b in [1e3, 1e4, 1e5, 1e6] {
        let steps = Steps::Controlled { tolerance: 1e-7 };
        let far = |x: f64| start(x, b, 0.0);
        let angle = |end| match end {
            End::Away([x, y, _]) => (-y).atan2(x),
            other => panic!("{other:?}"),
        };
        let series = 4.0 / b + 3.75 * std::f64::consts::PI / (b * b) + 128.0 / 3.0 / b.powi(3);
        let [single, double] = [
            angle(hole(steps).follow::<f32>(&far(-1e9), ENOUGH)),
            angle(hole(steps).follow::<f64>(&far(-1e9), ENOUGH)),
        ];
        println!("b = {b:e}: {:.1e} in f32, {:.1e} in f64 of {series:.1e}", single - series, double - series);
        assert!((double - series).abs() < 2e-9 && (single - series).abs() < 1e-8, "{single} {double} {series}");
    }
}
