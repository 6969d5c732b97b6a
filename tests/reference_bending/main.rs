//! The reference tracer's bent light against closed forms and tables: curves through media of varying index and around a
//! black hole, and what is seen and lit along them.
//!
//! `graded.csv` holds closed forms, `mirage.csv` quadratures, `hole.csv` elliptic integrals, all with more digits than
//! are written there.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../reference/mod.rs"]
mod reference;

mod curves;
mod hole;
mod invariants;
mod meetings;
mod pictures;
mod shadows;
mod sky;

use reference::integrator::root;
use reference::law::Law;
use reference::path::{Bend, End, Piece, Place, go};
use reference::profile::{Level, Profile};
use reference::vector::Vector;

const UP: Vector = Vector::new(0.0, 1.0, 0.0);
const X: Vector = Vector::new(1.0, 0.0, 0.0);

/// A point of the plane that all is in.
fn v(x: f64, y: f64) -> Vector {
    Vector::new(x, y, 0.0)
}

/// From a point, at an angle from the x axis in radians.
fn start(point: Vector, angle: f64) -> Place {
    Place { point, direction: v(angle.cos(), angle.sin()) }
}

/// An index by the height y.
fn layered(from: f64, to: f64, law: Law) -> Profile {
    Profile::new(Level::Height { origin: Vector::ZERO, up: UP }, from, to, law)
}

/// An index by the distance from the origin.
fn ball(from: f64, to: f64, law: Law) -> Profile {
    Profile::new(Level::Radius { center: Vector::ZERO, radius: 0.0 }, from, to, law)
}

/// The first place of a path where a quantity becomes 0 from below.
fn first(bend: Bend<'_>, start: Place, quantity: impl Fn(Place) -> f64) -> Place {
    for piece in bend.course(start) {
        let finite = match piece {
            Piece::Straight { start, length } => Piece::Straight { start, length: length.min(1e9) },
            other => other,
        };
        let [a, b] = [0.0, 1.0].map(|share| quantity(finite.at(share)));
        if a < 0.0 && b >= 0.0 {
            return finite.at(root(|share| [quantity(finite.at(share)), b - a], 0.0, 1.0, 0.0));
        }
    }
    panic!("it is never 0")
}

/// Where the path is after a length.
fn after(bend: Bend<'_>, start: Place, length: f64) -> Place {
    match go(bend, start, length) {
        End::At(place) => place,
        End::Captured => panic!("captured"),
    }
}

/// The rows of a table, as text fields.
fn rows(table: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().skip(1).map(|line| line.split(',').collect())
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// The largest error so far.
#[derive(Default)]
struct Worst(f64);

impl Worst {
    fn note(&mut self, error: f64, tolerance: f64, what: impl std::fmt::Debug) {
        assert!(error <= tolerance, "{what:?}: {error:e}");
        self.0 = self.0.max(error);
    }
}
