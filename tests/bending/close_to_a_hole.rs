//! Light that starts next to a black hole: the part of all directions from which none escapes, in the scene's coordinates.
//!
//! At the angle ψ to the direction outwards, light at the distance r has the impact parameter r·sin ψ/√(1 − 2M·sin²ψ/r).
//! Outside of 3M what is captured goes inwards with less than the critical one; inside of 3M what escapes goes outwards with
//! less than it.

use whit::scene::Steps;

use crate::capture::{edge, is_captured};
use crate::support::{assert_below, hole};
use crate::world::{Number, Start};

const METHODS: [(Steps<f64>, f64); 5] = [
    (Steps::Controlled { tolerance: 1e-3 }, 2e-4),
    (Steps::Controlled { tolerance: 1e-5 }, 1e-6),
    (Steps::Controlled { tolerance: 1e-7 }, 5e-9),
    (Steps::Fixed { length: 0.05 }, 2e-3),
    (Steps::Fixed { length: 0.01 }, 1e-4),
];

/// At the distance r, along the x axis, at an angle to the direction outwards.
fn at(r: f64, angle: f64) -> Start {
    Start { origin: [r, 0.0, 0.0], direction: [angle.cos(), angle.sin(), 0.0] }
}

/// The sine of the angle at which light has the critical impact parameter.
fn critical_sine(r: f64) -> f64 {
    (27.0 / (r * r + 54.0 / r)).min(1.0).sqrt()
}

/// The angle outwards that the light that escapes stays within.
fn cone<T: Number>(steps: Steps<f64>, r: f64) -> f64 {
    // From straight inwards, which is captured, to straight outwards.
    let turned = |angle: f64| at(r, std::f64::consts::PI - angle);
    std::f64::consts::PI - edge::<T>(&hole(steps), turned, 0.01, 3.1)
}

#[test]
fn the_shadow_has_its_size() {
    for (steps, bound) in METHODS {
        for r in [2.1, 2.5, 3.0, 3.5, 6.0, 10.0, 100.0] {
            let inside = critical_sine(r).asin();
            let exact = if r < 3.0 { inside } else { std::f64::consts::PI - inside };
            let name = format!("r = {r}, {steps:?}");
            assert_below(&format!("{name}, f64"), (cone::<f64>(steps, r) - exact).abs(), bound);
            assert_below(&format!("{name}, f32"), (cone::<f32>(steps, r) - exact).abs(), bound + 2e-6);
        }
    }
}

/// Straight to the hole and away from it, and from below the horizon.
#[test]
fn straight_light() {
    for (steps, _) in METHODS {
        for r in [2.0001, 2.1, 3.0, 10.0, 1e5] {
            let inwards = Start { origin: [r, 0.0, 0.0], direction: [-1.0, 0.0, 0.0] };
            assert!(is_captured::<f64>(&hole(steps), &inwards) && is_captured::<f32>(&hole(steps), &inwards), "{r}");
            let outwards = at(r, 0.0);
            assert!(
                !is_captured::<f64>(&hole(steps), &outwards) && !is_captured::<f32>(&hole(steps), &outwards),
                "{r}"
            );
        }
        for r in [0.0, 1e-30, 0.5, 1.9999, 2.0] {
            for angle in [0.0, 1.0, 3.0] {
                assert!(is_captured::<f64>(&hole(steps), &at(r, angle)), "{r}");
                assert!(is_captured::<f32>(&hole(steps), &at(r, angle)), "{r}");
            }
        }
    }
}
