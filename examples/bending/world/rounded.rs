//! Scenes in another number type.

use whit::scene::{Law, Level, Method, Profile, Steps};

use super::Number;

/// A profile in another number type; `values` are those of its table, if it has one.
pub fn profile_of<'b, T: Number>(profile: &Profile<'_, f64>, values: &'b [T]) -> Profile<'b, T> {
    let &Profile { level, from, to, law, method } = profile;
    let level = match level {
        Level::Height { origin, up } => Level::Height { origin: origin.map(T::of), up: up.map(T::of) },
        Level::Radius { center, radius } => Level::Radius { center: center.map(T::of), radius: T::of(radius) },
    };
    let method = match method {
        Method::Layers { thickness } => Method::Layers { thickness: T::of(thickness) },
        Method::Steps(steps) => Method::Steps(steps_of(steps)),
    };
    Profile { level, from: T::of(from), to: T::of(to), law: law_of(law, values), method }
}

fn law_of<'b, T: Number>(law: Law<'_, f64>, values: &'b [T]) -> Law<'b, T> {
    match law {
        Law::Polynomial { constant, linear, quadratic } => {
            Law::Polynomial { constant: T::of(constant), linear: T::of(linear), quadratic: T::of(quadratic) }
        }
        Law::Exponential { far, excess, scale } => {
            Law::Exponential { far: T::of(far), excess: T::of(excess), scale: T::of(scale) }
        }
        Law::Thermal { excess, ratio, scale } => {
            Law::Thermal { excess: T::of(excess), ratio: T::of(ratio), scale: T::of(scale) }
        }
        Law::Inversion { below, above, height, thickness } => Law::Inversion {
            below: T::of(below),
            above: T::of(above),
            height: T::of(height),
            thickness: T::of(thickness),
        },
        Law::FishEye { index, radius } => Law::FishEye { index: T::of(index), radius: T::of(radius) },
        Law::Table { spacing, .. } => Law::Table { spacing: T::of(spacing), values },
    }
}

pub fn steps_of<T: Number>(steps: Steps<f64>) -> Steps<T> {
    match steps {
        Steps::Fixed { length } => Steps::Fixed { length: T::of(length) },
        Steps::Controlled { tolerance } => Steps::Controlled { tolerance: T::of(tolerance) },
    }
}
