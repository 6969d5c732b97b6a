//! Paths in graded glass whose closed forms are known: parabolas, sines, and those of an exponential.

use whit::scene::{Method, Profile};

use crate::exact::glass::{exponential, linear, parabolic};
use crate::support::{
    assert_below, controlled, fixed, halved, landing, layers, mean, number, order, rows, start, tenths, walled,
};
use crate::tables::GLASS;
use crate::world::Number;

/// One of the media, its rows in the table, and the height that light starts at.
struct Case {
    name: &'static str,
    profile: fn(Method<f64>) -> Profile<'static, f64>,
    height: f64,
    /// The largest error in steps of the length 1, that of shorter steps going with the square of their length.
    fixed: f64,
}

const CASES: [Case; 3] = [
    Case { name: "linear_n2", profile: linear, height: 0.0, fixed: 0.02 },
    Case { name: "parabolic", profile: parabolic, height: 0.3, fixed: 0.2 },
    Case { name: "exponential", profile: exponential, height: 0.0, fixed: 100.0 },
];

impl Case {
    fn errors<T: Number>(&self, method: Method<f64>) -> Vec<f64> {
        self.errors_of::<T>(method, |_| true)
    }

    /// By how much paths are off, across the x axis, at the places of the table, of some of the angles.
    fn errors_of<T: Number>(&self, method: Method<f64>, wanted: impl Fn(f64) -> bool) -> Vec<f64> {
        let rows = rows(GLASS)
            .filter(|row| row[0].starts_with(self.name) && row[3] != "0.000000000000" && wanted(number(row[1])));
        rows.map(|row| {
            let [degrees, x, y] = [1, 3, 4].map(|column| number(row[column]));
            let world = walled((self.profile)(method), x);
            let (point, _) = landing::<T>(&world, &start(0.0, self.height, degrees.to_radians()));
            point[1] - y
        })
        .collect()
    }

    fn worst<T: Number>(&self, method: Method<f64>) -> f64 {
        self.errors::<T>(method).into_iter().fold(0.0, |worst, error| error.abs().max(worst))
    }
}

#[test]
fn tolerances_are_kept() {
    for case in &CASES {
        for tolerance in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
            let method = controlled(tolerance);
            let [single, double] = [case.worst::<f32>(method), case.worst::<f64>(method)];
            assert_below(&format!("{} {tolerance:e} f64", case.name), double, 20.0 * tolerance);
            assert_below(&format!("{} {tolerance:e} f32", case.name), single, 20.0 * tolerance + 1.5e-5);
        }
    }
}

#[test]
fn fixed_steps_are_of_second_order() {
    for case in &CASES {
        let order = order(case.name, &halved(0.2, 6), |length| mean(case.errors::<f64>(fixed(length))));
        assert!((1.8..2.2).contains(&order), "{}: {order}", case.name);
        for length in [0.1, 0.05, 0.02, 0.01] {
            let [single, double] = [case.worst::<f32>(fixed(length)), case.worst::<f64>(fixed(length))];
            assert_below(&format!("{} {length} f64", case.name), double, case.fixed * length * length);
            assert_below(&format!("{} {length} f32", case.name), single, case.fixed * length * length + 1e-5);
        }
    }
}

#[test]
fn the_error_goes_with_the_tolerance() {
    for case in &CASES {
        let order = order(case.name, &tenths(1e-2, 4), |tolerance| mean(case.errors::<f64>(controlled(tolerance))));
        assert!((0.8..1.3).contains(&order), "{}: {order}", case.name);
    }
}

/// Light that starts along flat layers goes straight on in one of them, and is left out here. Where light turns in a layer, the
/// error goes with the root of its thickness.
#[test]
fn thin_layers() {
    for case in &CASES {
        for thickness in halved(0.05, 8) {
            let bound = 6.0 * thickness.sqrt();
            let double = mean(case.errors_of::<f64>(layers(thickness), |degrees| degrees != 0.0));
            let single = mean(case.errors_of::<f32>(layers(thickness), |degrees| degrees != 0.0));
            assert_below(&format!("{} {thickness}, f64", case.name), double, bound);
            assert_below(&format!("{} {thickness}, f32", case.name), single, bound);
        }
    }
}
