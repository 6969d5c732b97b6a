//! What a ray sees that meets nothing.

use crate::math::{Real, Rgb, Vec3};

/// The light that arrives from far away, by direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background<T> {
    /// The same from everywhere.
    Solid(Rgb<T>),
    /// From `below` to `above`, linear in the cosine of the angle from `up`.
    Gradient {
        /// Straight down.
        below: Rgb<T>,
        /// Straight up.
        above: Rgb<T>,
        /// Unit vector.
        up: Vec3<T>,
    },
    /// colour · (1 − d·up)⁴ for the direction d: bright at the horizon, dark above; the sky of Andrew Kensler's
    /// business-card tracer.
    Sky {
        /// At the horizon.
        horizon: Rgb<T>,
        /// Unit vector.
        up: Vec3<T>,
    },
    /// Stars on an even sky, the same at each run: the six faces of a cube are cut into cells, and about half of them hold
    /// a star.
    Stars {
        /// Between the stars.
        sky: Rgb<T>,
        /// Of the brightest star, in its middle.
        brightness: T,
        /// Cells along the edge of a face, 90° of the sky; at least 1.
        cells: u16,
        /// Radius of a star as a share of its cell, above 0 and at most 1/2. It fades towards its rim.
        radius: T,
    },
}

impl<T: Real> Background<T> {
    /// The same background in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Background<U> {
        match *self {
            Self::Solid(color) => Background::Solid(color.map(f)),
            Self::Gradient { below, above, up } => {
                Background::Gradient { below: below.map(&f), above: above.map(&f), up: up.map(&f) }
            }
            Self::Sky { horizon, up } => Background::Sky { horizon: horizon.map(&f), up: up.map(&f) },
            Self::Stars { sky, brightness, cells, radius } => {
                Background::Stars { sky: sky.map(&f), brightness: f(brightness), cells, radius: f(radius) }
            }
        }
    }
}
