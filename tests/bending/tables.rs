//! The formulas of the tests against the tables.

use crate::exact::deflection::{closest_approach, deflection};
use crate::exact::glass::exponential_height;
use crate::exact::mirage;
use crate::orbit::Orbit;
use crate::support::{distance, number, rows, start};
use crate::world::End;

pub const GLASS: &str = include_str!("../data/oracles/grin_exact.csv");
pub const MIRAGE: &str = include_str!("../data/oracles/mirage_inferior.csv");
pub const DEFLECTION: &str = include_str!("../data/oracles/schwarzschild_deflection.csv");

#[test]
fn deflections() {
    for row in rows(DEFLECTION) {
        let [b, nearest, angle] = [0, 1, 2].map(|column| number(row[column]));
        assert!((closest_approach(b) / nearest - 1.0).abs() < 1e-9, "{b}");
        // Next to the critical impact parameter its last digit counts.
        let tolerance = 1e-13 / (b / 5.196_152_422_706_632 - 1.0) + 1e-12;
        assert!((deflection(b) - angle).abs() < tolerance, "{b}: {} {angle}", deflection(b));
    }
}

#[test]
fn orbits() {
    for b in [5.2, 5.25, 6.0, 10.0, 50.0] {
        let from = start(-1e9, b, 0.0);
        let End::Away(direction) = Orbit::new(&from).end(None) else { panic!("{b}") };
        let angle = deflection(b);
        assert!(distance(direction, [angle.cos(), -angle.sin(), 0.0]) < 1e-8, "{b}: {direction:?} {angle}");
    }
}

#[test]
fn mirages() {
    for row in rows(MIRAGE) {
        let found = mirage::turning(number(row[0]), number(row[1]));
        let Ok(height) = row[2].parse::<f64>() else {
            assert_eq!(found, None);
            continue;
        };
        let (turn, away) = found.unwrap();
        assert!(
            (turn / height - 1.0).abs() < 1e-9 && (away / number(row[3]) - 1.0).abs() < 1e-8,
            "{turn} {away} {row:?}"
        );
    }
}

#[test]
fn exponential_air() {
    for row in rows(GLASS).filter(|row| row[0].starts_with("exponential")) {
        let [degrees, x, y] = [1, 3, 4].map(|column| number(row[column]));
        assert!((exponential_height(degrees.to_radians(), x) - y).abs() < 1e-11, "{row:?}");
    }
}
