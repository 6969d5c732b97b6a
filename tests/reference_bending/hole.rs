//! Orbits around a black hole.

use super::reference::hole::{Hole, Orbit};
use super::reference::integrator::root;
use super::reference::path::{Bend, End, Place, go};
use super::reference::vector::Vector;
use super::{Worst, X, first, number, rows, v};

const HOLE: Hole = Hole { center: Vector::ZERO, mass: 1.0 };

/// How much an error of b counts: the angle goes like −ln(b − 3√3).
fn condition(b: f64) -> f64 {
    b / (b - 27.0_f64.sqrt())
}

/// From infinity to infinity.
#[test]
fn orbits_turn_by_the_angles_in_the_table() {
    let (mut angles, mut distances) = (Worst::default(), Worst::default());
    for row in rows(include_str!("../data/bending/hole.csv")) {
        let b = number(row[0]);
        let mut orbit = Orbit { u: 0.0, slope: 1.0 / b };
        let (mut phi, mut next, mut nearest) = (0.0, 0.1, 0.0);
        let turned = loop {
            let (h, end) = orbit.controlled(&mut next, 0.1);
            let at = |h| orbit.step(h).0;
            if orbit.slope > 0.0 && end.slope <= 0.0 {
                // u″ = 3u² − u
                let turn = root(|h| [at(h).slope, (3.0 * at(h).u - 1.0) * at(h).u], 0.0, h, 0.0);
                nearest = 1.0 / at(turn).u;
            }
            if end.u < 0.0 {
                break phi + root(|h| [at(h).u, at(h).slope], 0.0, h, 0.0);
            }
            assert!((end.constant() * b * b - 1.0).abs() < 1e-11 * condition(b), "{row:?}");
            phi += h;
            orbit = end;
        };
        let error = (turned - std::f64::consts::PI - number(row[2])).abs();
        angles.note(error / condition(b).max(1.0), 1e-13, &row);
        distances.note((nearest / number(row[1]) - 1.0).abs() / condition(b).sqrt(), 1e-13, &row);
        println!("b = {b} M: angle off by {error:.1e}");
    }
    println!("orbits: {:.1e} of the angle and {:.1e} of the distance, by condition", angles.0, distances.0);
}

/// From far away to far away.
#[test]
fn paths_turn_by_the_angles_in_the_table() {
    let mut worst = Worst::default();
    for row in rows(include_str!("../data/bending/hole.csv")) {
        let (b, angle) = (number(row[0]), number(row[2]));
        let from = Place { point: v(-1e5 * b, b), direction: X };
        let End::At(end) = go(Bend::Hole(&HOLE), from, 1e9 * b) else { panic!("{row:?}") };
        let expected = v(angle.cos(), -angle.sin());
        worst.note((end.direction - expected).length() / condition(b), 2e-11, &row);
    }
    println!("paths: {:.1e}, by condition", worst.0);
}

#[test]
fn light_below_the_critical_distance_is_lost() {
    let lost = |b: f64, distance: f64| {
        let from = Place { point: v(-distance, b), direction: X };
        go(Bend::Hole(&HOLE), from, 1e3 * distance) == End::Captured
    };
    let critical = 27.0_f64.sqrt();
    for distance in [1e5, 1e6] {
        for share in [0.0, 1e-20, 1e-14, 1e-10, 1e-3, 0.5, 0.99, 1.0 - 1e-6, 1.0 - 1e-9] {
            assert!(lost(share * critical, distance), "{share}");
        }
        for share in [1.0 + 1e-9, 1.0 + 1e-6, 1.01, 2.0] {
            assert!(!lost(share * critical, distance), "{share}");
        }
    }
    // An eye at r sees a shadow of the angle θ with sin θ = 3√3·M·√(1 − 2M/r)/r in a frame at rest; in the coordinates
    // b = r·sin ψ/√(1 − (2M/r)·sin²ψ), of the tangent's angle ψ.
    for r in [2.1_f64, 2.9, 3.1, 6.0, 30.0] {
        let sine = (critical / r) / (1.0 + 2.0 * critical * critical / r.powi(3)).sqrt();
        for (share, is_lost) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
            let psi = (share * sine).asin();
            let inwards = if r > 3.0 { -1.0 } else { 1.0 };
            let direction = v(inwards * psi.cos(), psi.sin());
            let captured = go(Bend::Hole(&HOLE), Place { point: v(r, 0.0), direction }, 1e4) == End::Captured;
            assert_eq!(captured, is_lost == (r > 3.0), "{r} {share}");
        }
    }
}

/// Light across the radius goes round and round at 3M, and for long next to it.
#[test]
fn the_photon_sphere() {
    for (r, captured) in [(3.0 - 1e-9, true), (3.0 + 1e-9, false)] {
        let from = Place { point: v(r, 0.0), direction: v(0.0, 1.0) };
        let here = Bend::Hole(&HOLE);
        let round = first(here, from, |place| if place.point.x < 0.0 { -place.point.y } else { -1.0 });
        assert!((round.point - v(-r, 0.0)).length() < 1e-7);
        assert_eq!(go(here, from, 1e4) == End::Captured, captured);
    }
}

/// x″ = −3·M·h²·x/r⁵ by a parameter of which h = |x × x′| is constant: the same curve in another form.
#[test]
fn the_orbit_obeys_the_cartesian_equation() {
    let from = Place { point: v(-9.0, 6.5), direction: X };
    let d = 1e-3;
    for length in [1.0, 5.0, 9.0, 12.0, 20.0] {
        let at = |length| match go(Bend::Hole(&HOLE), from, length) {
            End::At(place) => place,
            End::Captured => panic!("captured"),
        };
        let (here, turned) = (at(length), (at(length + d).direction - at(length - d).direction) * (0.5 / d));
        // With the direction t = x′/|x′| and the length s, dt/ds = (x″ across t)/|x′|², and h/|x′| = |x × t|.
        let lever = here.point.cross(here.direction).length();
        let force = here.point * (-3.0 * lever * lever / here.point.length().powi(5));
        let expected = force - here.direction * force.dot(here.direction);
        assert!((turned - expected).length() < 1e-6, "{length}");
    }
}
