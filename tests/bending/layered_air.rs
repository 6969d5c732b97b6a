//! In flat layers n·cos θ stays the same along a path, θ being the angle to the layers; around a centre n·r·sin θ.

use whit::Vec3;
use whit::scene::{Law, Level, Method, Profile};

use crate::exact::glass::{exponential, fish_eye, linear, luneburg, parabolic};
use crate::exact::mirage::air;
use crate::orbit::{length, plus};
use crate::support::{assert_below, controlled, fixed, halved, landing, layers, mean, order, start, tenths, walled};
use crate::world::{Bend, Number, Start, Target, Vector, World};

/// A layer of warm air on cold air, both much thicker than real ones.
fn inversion(method: Method<f64>) -> Profile<'static, f64> {
    let level = Level::Height { origin: Vec3::ZERO, up: Vec3::new(0.0, 1.0, 0.0) };
    let law = Law::Inversion { below: 0.5, above: 0.1, height: 0.5, thickness: 0.2 };
    Profile { level, from: -1.0, to: 2.0, law, method }
}

/// What stays the same in flat layers, and in round ones.
fn invariant(profile: &Profile<'_, f64>, point: Vector, direction: Vector) -> f64 {
    let n = profile.index(Vec3::from(point));
    match profile.level {
        Level::Height { .. } => n * direction[0].hypot(direction[2]),
        Level::Radius { .. } => {
            let along: f64 = (0..3).map(|i| point[i] * direction[i]).sum();
            n * length(plus(point, -along, direction))
        }
    }
}

type Medium = fn(Method<f64>) -> Profile<'static, f64>;

/// Media, where a wall is in them, and how light starts.
fn cases() -> Vec<(&'static str, Medium, f64, Start)> {
    vec![
        ("linear", linear as Medium, 1.5, start(0.0, 0.1, 0.4)),
        ("parabolic", parabolic, 2.0, start(0.0, 0.3, 0.4)),
        ("exponential", exponential, 0.9, start(0.0, 0.1, 0.9)),
        ("inversion", inversion, 1.3, start(0.0, 0.1, 0.7)),
        ("Luneburg", luneburg, 0.6, start(-0.4, 0.3, 0.2)),
        ("Luneburg from outside", luneburg, 0.6, start(-2.0, 0.4, 0.0)),
        ("Luneburg to the outside", luneburg, 1.5, start(-2.0, 0.4, 0.0)),
        ("fish-eye", fish_eye, 0.8, start(-0.4, 0.3, 0.5)),
    ]
}

/// By how much it changes along a path, as a share.
fn change<T: Number>(medium: Medium, method: Method<f64>, wall: f64, from: &Start) -> f64 {
    let profile = medium(method);
    let (point, direction) = landing::<T>(&walled(profile, wall), from);
    invariant(&profile, point, direction) / invariant(&profile, from.origin, from.direction) - 1.0
}

#[test]
fn it_stays() {
    for (name, medium, wall, from) in cases() {
        for (method, bound) in [
            (controlled(1e-3), 1e-3),
            (controlled(1e-5), 1e-5),
            (controlled(1e-7), 1e-6),
            (fixed(0.05), 3e-3),
            (fixed(0.01), 1e-4),
            (layers(0.044), 1e-12),
            (layers(0.0123), 1e-12),
        ] {
            let name = format!("{name} {method:?}");
            assert_below(&format!("{name}, f64"), change::<f64>(medium, method, wall, &from).abs(), bound);
            let single = change::<f32>(medium, method, wall, &from).abs();
            assert_below(&format!("{name}, f32"), single, bound + 2e-5);
        }
    }
}

#[test]
fn orders() {
    let all = |method| mean(cases().iter().map(|(_, medium, wall, from)| change::<f64>(*medium, method, *wall, from)));
    let fixed = order("fixed", &halved(0.1, 6), |length| all(fixed(length)));
    let controlled = order("controlled", &tenths(1e-2, 6), |tolerance| all(controlled(tolerance)));
    assert!((1.8..2.2).contains(&fixed) && (0.8..1.2).contains(&controlled), "{fixed} {controlled}");
}

/// In the air over a road the angle is a few thousandths, and n·cos θ stays to the last digits.
#[test]
fn it_stays_in_air() {
    for method in [controlled(1e-4), controlled(1e-6), fixed(1.0), layers(1e-3)] {
        for angle in [1e-3, 3e-3, 6e-3] {
            let from = start(0.0, 1.5, -angle);
            let error = change::<f64>(air, method, 400.0, &from).abs();
            assert_below(&format!("{angle} {method:?}, f64"), error, 5e-8);
            assert_below(&format!("{angle} {method:?}, f32"), change::<f32>(air, method, 400.0, &from).abs(), 2e-7);
        }
    }
}

/// Through layers of n = e^(−y) from y = −½ to ½, from outside to outside and without a turn, light goes aside by the
/// difference of asin(p·e^y), p being n·cos θ.
#[test]
fn layers_are_of_second_order_where_light_does_not_turn() {
    let (cosine, half) = (0.3_f64, 0.5_f64);
    let p = half.exp() * cosine;
    let bent = (p * half.exp()).asin() - (p * (-half).exp()).asin();
    let (below, above) = (cosine / (1.0 - cosine * cosine).sqrt(), {
        let cosine = p * half.exp();
        cosine / (1.0 - cosine * cosine).sqrt()
    });
    let exact = half * (below + above) + bent;
    let error = |thickness| {
        let profile = Profile { from: -half, to: half, ..exponential(layers(thickness)) };
        let ceiling = Target::Plane { point: [0.0, 1.0, 0.0], normal: [0.0, -1.0, 0.0] };
        let world = World { bend: Bend::Medium(profile), targets: vec![ceiling] };
        landing::<f64>(&world, &start(0.0, -1.0, cosine.acos())).0[0] - exact
    };
    let order = order("layers", &halved(0.1, 6), |thickness| error(thickness).abs());
    assert!((1.8..2.2).contains(&order), "{order}");
}
