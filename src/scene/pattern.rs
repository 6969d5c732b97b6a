//! How the colour of a body varies over its surface.

use crate::math::{Real, Rgb, Vec3};

/// A colour for every point of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pattern<T> {
    /// One colour everywhere.
    Solid(Rgb<T>),
    /// Two colours by the parity of ⌊p·u⌋ + ⌊p·v⌋.
    ///
    /// `u` and `v` are the directions of the squares, each with the length 1/(side of a square). Two directions and
    /// not three, so that a floor does not lie on the border between two layers of cubes.
    Checker {
        /// Where the parity is even.
        even: Rgb<T>,
        /// Where it is odd.
        odd: Rgb<T>,
        /// First direction, in 1/scene units.
        u: Vec3<T>,
        /// Second direction, in 1/scene units.
        v: Vec3<T>,
    },
    /// From one colour to another along an axis: t = (p − origin)·axis, held between 0 and 1.
    Gradient {
        /// Where t ≤ 0.
        from: Rgb<T>,
        /// Where t ≥ 1.
        to: Rgb<T>,
        /// Where t = 0.
        origin: Vec3<T>,
        /// Direction of the change, with the length 1/(distance over which it happens).
        axis: Vec3<T>,
    },
    /// Two colours by the parity of ⌊|p − centre|/width⌋.
    Rings {
        /// In the middle.
        even: Rgb<T>,
        /// In the next ring.
        odd: Rgb<T>,
        /// Where they start.
        center: Vec3<T>,
        /// Of a ring, in scene units.
        width: T,
    },
}

impl<T: Real> Pattern<T> {
    /// The same pattern in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Pattern<U> {
        match *self {
            Self::Solid(color) => Pattern::Solid(color.map(f)),
            Self::Checker { even, odd, u, v } => {
                Pattern::Checker { even: even.map(&f), odd: odd.map(&f), u: u.map(&f), v: v.map(&f) }
            }
            Self::Gradient { from, to, origin, axis } => {
                Pattern::Gradient { from: from.map(&f), to: to.map(&f), origin: origin.map(&f), axis: axis.map(&f) }
            }
            Self::Rings { even, odd, center, width } => {
                Pattern::Rings { even: even.map(&f), odd: odd.map(&f), center: center.map(&f), width: f(width) }
            }
        }
    }
}
