//! Light over a hot road: down, round and up again, or to the ground.

use whit::Vec3;
use whit::scene::{Level, Method, Profile};

use crate::exact::mirage::{air, turning};
use crate::support::{
    ENOUGH, UP, assert_below, controlled, fixed, halved, landing, layers, mean, number, order, rows, start, tenths,
    walled,
};
use crate::tables::MIRAGE;
use crate::world::{End, Number, Start, Target, World};

/// The start of a path, and where it turns if it does: at which height and how far away.
fn paths() -> Vec<(Start, Option<(f64, f64)>)> {
    let path = |row: Vec<&str>| {
        let from = start(0.0, number(row[0]), -number(row[1]));
        (from, row[3].parse().ok().map(|away| (number(row[2]), away)))
    };
    rows(MIRAGE).map(path).collect()
}

/// The air, the ground and a wall.
fn road(method: Method<f64>, wall: f64) -> World<'static> {
    let ground = Target::Plane { point: [0.0; 3], normal: UP };
    let mut world = walled(air(method), wall);
    world.targets.push(ground);
    world
}

/// By how much paths are off in height where they turn, and where they are back at the height of the eye, in scene units.
fn errors<T: Number>(method: Method<f64>) -> [Vec<f64>; 2] {
    let turns = paths().into_iter().filter_map(|(from, turn)| Some((from, turn?)));
    let error = |(from, (height, away)): (Start, (f64, f64))| {
        let at = |x| landing::<T>(&road(method, x), &from).0[1];
        [at(away) - height, at(2.0 * away) - from.origin[1]]
    };
    let errors: Vec<_> = turns.map(error).collect();
    [0, 1].map(|i| errors.iter().map(|error| error[i]).collect())
}

fn worst(errors: &[f64]) -> f64 {
    errors.iter().fold(0.0, |worst, error| error.abs().max(worst))
}

fn check(method: Method<f64>, bounds: [f64; 2], single: [f64; 2]) {
    let (double, float) = (errors::<f64>(method), errors::<f32>(method));
    for (i, name) in ["turn", "eye"].into_iter().enumerate() {
        assert_below(&format!("{name} {method:?} f64"), worst(&double[i]), bounds[i]);
        assert_below(&format!("{name} {method:?} f32"), worst(&float[i]), single[i]);
    }
}

#[test]
fn controlled_steps() {
    for tolerance in [1e-4, 1e-5, 1e-6, 1e-7] {
        check(controlled(tolerance), [100.0 * tolerance; 2], [100.0 * tolerance + 1e-4; 2]);
    }
    let order = order("eye", &tenths(1e-4, 4), |tolerance| mean(errors::<f64>(controlled(tolerance))[1].clone()));
    assert!((0.8..1.5).contains(&order), "{order}");
}

#[test]
fn fixed_steps() {
    for length in [2.0, 1.0, 0.5] {
        let bound = 3e-4 * length * length;
        check(fixed(length), [bound; 2], [bound + 5e-4; 2]);
    }
    let order = order("eye", &halved(2.0, 5), |length| mean(errors::<f64>(fixed(length))[1].clone()));
    assert!((1.8..2.2).contains(&order), "{order}");
}

#[test]
fn thin_layers() {
    for thickness in [1e-3, 2.5e-4] {
        check(layers(thickness), [5e-3, 5e-2], [5e-3, 5e-2]);
    }
    let order = order("turn", &halved(1e-3, 6), |thickness| mean(errors::<f64>(layers(thickness))[0].clone()));
    assert!(order > 0.3, "{order}");
}

/// Steeper light meets the ground.
#[test]
fn steep_light_meets_the_ground() {
    for method in [controlled(1e-5), fixed(1.0), layers(1e-3)] {
        for (from, turn) in paths() {
            let far = turn.map_or(400.0, |(_, away)| 2.0 * away);
            for end in [road(method, far).follow::<f32>(&from, ENOUGH), road(method, far).follow::<f64>(&from, ENOUGH)]
            {
                let End::Surface { object, .. } = end else { panic!("{end:?}") };
                assert_eq!(object, usize::from(turn.is_none()), "{from:?} {method:?}");
            }
        }
    }
}

/// A road 100 m above the origin: the place has fewer digits there, the direction has not.
#[test]
fn directions_keep_their_digits_far_from_the_origin() {
    const HEIGHT: f64 = 100.0;
    let angle = 5e-3_f64;
    let (_, away) = turning(1.5, angle).unwrap();
    for method in [controlled(1e-5), fixed(1.0), fixed(0.25), layers(1e-3)] {
        let level = Level::Height { origin: Vec3::new(0.0, HEIGHT, 0.0), up: Vec3::new(0.0, 1.0, 0.0) };
        let world = walled(Profile { level, ..air(method) }, 2.0 * away);
        let (_, direction) = landing::<f32>(&world, &start(0.0, HEIGHT + 1.5, -angle));
        assert_below(&format!("{method:?}"), (direction[1] / angle - 1.0).abs(), 3e-4);
    }
}
