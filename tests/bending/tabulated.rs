//! A table of a law's values bends light as the law does.

use whit::Vec3;
use whit::scene::{Law, Level, Method, Profile};

use crate::exact::mirage::air;
use crate::support::{assert_below, controlled, fixed, halved, landing, layers, mean, order, start, walled};
use crate::world::Number;

const FROM: f64 = 0.0;
const TO: f64 = 2.0;

fn up() -> Level<f64> {
    Level::Height { origin: Vec3::ZERO, up: Vec3::new(0.0, 1.0, 0.0) }
}

/// n = 1 + 0.5·e^(−y), and its values at equal spacings.
fn law() -> Law<'static, f64> {
    Law::Exponential { far: 1.0, excess: 0.5, scale: 1.0 }
}

fn values(spacing: f64) -> Vec<f64> {
    let count = ((TO - FROM) / spacing).round() as usize;
    (0..=count).map(|i| 0.5 * (-(FROM + i as f64 * spacing)).exp()).collect()
}

/// By how much a table's paths are off those of the law, at the wall.
fn difference<T: Number>(spacing: f64, method: Method<f64>) -> f64 {
    let values = values(spacing);
    let profile = Profile { level: up(), from: FROM, to: TO, law: law(), method };
    let table = Profile { law: Law::Table { spacing, values: &values }, ..profile };
    let paths = [(1.0, 0.3, 0.4), (1.5, 1.8, -0.7), (2.0, 0.9, 0.05), (1.0, 3.0, -1.2)];
    mean(paths.map(|(x, y, angle)| {
        let from = start(0.0, y, angle);
        landing::<T>(&walled(table, x), &from).0[1] - landing::<T>(&walled(profile, x), &from).0[1]
    }))
}

#[test]
fn fine_tables_are_as_good_as_the_law() {
    for method in [controlled(1e-6), fixed(0.01), layers(0.01)] {
        for (spacing, bound) in [(0.2, 1e-3), (0.05, 4e-5), (0.0125, 2e-6)] {
            let name = format!("{spacing} {method:?}");
            assert_below(&format!("{name}, f64"), difference::<f64>(spacing, method), bound);
            assert_below(&format!("{name}, f32"), difference::<f32>(spacing, method), bound + 3e-6);
        }
    }
}

#[test]
fn the_error_falls_with_the_spacing() {
    let order = order("table", &halved(0.2, 5), |spacing| difference::<f64>(spacing, fixed(0.002)));
    assert!(order > 1.8, "{order}");
}

/// The air over a road, of 121 values.
#[test]
fn tabulated_air() {
    let formula = air(controlled(1e-6));
    let spacing = 0.0025;
    let values: Vec<f64> =
        (0..=240).map(|i| formula.index(Vec3::new(0.0, spacing * f64::from(i), 0.0)) - 1.0).collect();
    let table = Profile { law: Law::Table { spacing, values: &values }, ..formula };
    for angle in [1e-3, 3e-3, 6e-3] {
        let from = start(0.0, 1.5, -angle);
        for x in [300.0, 600.0] {
            let height = |profile| landing::<f64>(&walled(profile, x), &from).0[1];
            assert_below(&format!("{angle} {x}"), (height(table) - height(formula)).abs(), 2e-3);
        }
    }
}
