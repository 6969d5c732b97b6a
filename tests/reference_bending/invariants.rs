//! What stays the same along every path.

use super::reference::hole::Hole;
use super::reference::law::Law;
use super::reference::path::{Bend, End, Place, go};
use super::reference::profile::{Level, Profile};
use super::reference::vector::Vector;
use super::{UP, Worst, after, ball, layered, start, v};

fn laws() -> Vec<Law> {
    vec![
        Law::Polynomial { constant: 1.2, linear: 0.4, quadratic: -0.3 },
        Law::Exponential { far: 1.0, excess: 0.6, scale: 0.4 },
        Law::Thermal { excess: 0.4, ratio: -0.7, scale: 0.3 },
        Law::Inversion { below: 0.6, above: 0.1, height: 0.5, thickness: 0.1 },
        Law::FishEye { index: 2.0, radius: 0.8 },
        Law::Table { spacing: 0.2, values: vec![0.3, 0.5, 0.45, 0.7, 0.4, 0.2] },
    ]
}

/// Starts below, between and above the borders, in many directions.
fn starts() -> Vec<Place> {
    let heights = [0.1, 0.25, 0.5, 0.77, 1.0, 1.3];
    let angles = (-17..=18).map(|i| 0.173 * f64::from(i));
    heights.iter().flat_map(|&y| angles.clone().map(move |angle| start(v(0.0, y), angle))).collect()
}

#[test]
fn layers_keep_the_law_of_snell() {
    let mut worst = Worst::default();
    for law in laws() {
        let profile = layered(0.2, 1.1, law);
        for from in starts() {
            for length in [0.3, 1.0, 3.0] {
                let end = after(Bend::Graded(&profile), from, length);
                let invariant = |place: Place| profile.index(place.point) * place.direction.x;
                worst.note((invariant(end) - invariant(from)).abs(), 1e-11, (&profile.law, from));
            }
        }
    }
    println!("n·cos θ: {:.1e}", worst.0);
}

#[test]
fn balls_keep_the_angular_momentum() {
    let mut worst = Worst::default();
    for law in laws() {
        let balls = [
            ball(0.2, 1.1, law.clone()),
            Profile::new(Level::Radius { center: v(0.3, -0.5), radius: 0.6 }, 0.1, 0.9, law),
        ];
        for profile in balls {
            let Level::Radius { center, .. } = profile.level else { panic!() };
            for from in starts() {
                let end = after(Bend::Graded(&profile), from, 3.0);
                let momentum =
                    |place: Place| (place.point - center).cross(place.direction) * profile.index(place.point);
                worst.note((momentum(end) - momentum(from)).length(), 2e-11, (&profile.law, from));
            }
        }
    }
    println!("n·r·sin θ: {:.1e}", worst.0);
}

/// Light that is turned round goes back where it came from.
#[test]
fn paths_can_be_reversed() {
    let mut worst = Worst::default();
    let profiles: Vec<Profile> =
        laws().into_iter().flat_map(|law| [layered(0.2, 1.1, law.clone()), ball(0.2, 1.1, law)]).collect();
    let hole = Hole { center: v(-0.4, 0.2), mass: 0.03 };
    let bends = profiles.iter().map(Bend::Graded).chain([Bend::Hole(&hole)]);
    for bend in bends {
        for from in starts() {
            for length in [0.4, 2.5] {
                let End::At(end) = go(bend, from, length) else { continue };
                let back = after(bend, Place { direction: -end.direction, ..end }, length);
                worst.note((back.point - from.point).length(), 1e-9, (bend, from, length));
                worst.note((back.direction + from.direction).length(), 1e-9, (bend, from, length));
            }
        }
    }
    println!("reversal: {:.1e}", worst.0);
}

/// The slope is that of the index, and beyond its borders the index stays what it is there.
#[test]
fn gradients_are_those_of_the_index() {
    let d = 1e-5;
    for law in laws() {
        for profile in [layered(0.2, 1.1, law.clone()), ball(0.2, 1.1, law)] {
            for i in 1..=40 {
                let level = 0.2 + 0.9 * (f64::from(i) - 0.3) / 40.0;
                let (point, up) = (v(0.6 * level, 0.8 * level), v(0.6, 0.8));
                let at = |point| match profile.level {
                    Level::Height { .. } => UP * level_of(&profile, point),
                    Level::Radius { .. } => point,
                };
                let up = if matches!(profile.level, Level::Height { .. }) { UP } else { up };
                let here = at(point);
                let number = profile.joints.iter().rposition(|&joint| joint <= profile.level.at(here)).unwrap_or(0);
                if number + 1 == profile.joints.len() || profile.level.at(here) < 0.2 {
                    continue;
                }
                let (n, gradient) = profile.smooth(here, number);
                assert_eq!(n, profile.index(here));
                let [a, b] = [-d, d].map(|off| profile.smooth(here + up * off, number).0);
                assert!((gradient - up * ((b - a) / (2.0 * d))).length() < 1e-7, "{:?} at {level}", profile.law);
            }
            for (inside, outside) in [(0.2, 0.1), (0.2, 0.0), (1.1, 1.2), (1.1, 5.0)] {
                assert!((profile.index(v(0.0, inside)) - profile.index(v(0.0, outside))).abs() < 1e-15);
            }
        }
    }
}

fn level_of(profile: &Profile, point: Vector) -> f64 {
    profile.level.at(point)
}

/// The library's own number for the index, in `f32`.
#[test]
fn the_laws_are_those_of_the_scenes() {
    use whit::Vec3;
    use whit::scene::{Law, Level, Method, Profile, Steps};
    let laws: [Law<'_, f32>; 6] = [
        Law::Polynomial { constant: 1.2, linear: 0.4, quadratic: -0.3 },
        Law::Exponential { far: 1.0, excess: 0.6, scale: 0.4 },
        Law::Thermal { excess: 0.4, ratio: -0.7, scale: 0.3 },
        Law::Inversion { below: 0.6, above: 0.1, height: 0.5, thickness: 0.1 },
        Law::FishEye { index: 2.0, radius: 0.8 },
        Law::Table { spacing: 0.2, values: &[0.3, 0.5, 0.45, 0.7, 0.4, 0.2] },
    ];
    for law in laws {
        for level in [
            Level::Height { origin: Vec3::new(0.0, 0.1, 0.0), up: Vec3::new(0.0, 1.0, 0.0) },
            Level::Radius { center: Vec3::new(0.1, -0.5, 0.0), radius: 0.4 },
        ] {
            let method = Method::Steps(Steps::Fixed { length: 0.1 });
            let profile = Profile { level, from: 0.2, to: 1.1, law, method };
            let exact = super::reference::profile::Profile::from(&profile);
            for i in -10..=40 {
                let point = Vec3::new(0.03, 0.05 * i as f32, 0.2);
                let n = f64::from(profile.index(point));
                assert!((n - exact.index(point.into())).abs() < 2e-6, "{law:?} at {point:?}");
            }
        }
    }
}
