//! How far from a surface the next ray starts.

use crate::math::Real;

/// How far from a surface the rays start that leave it, so that they do not meet it again where they start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Offset<T> {
    /// By a bound on the rounding error of the point: just enough, at any size and distance.
    Bounded,
    /// By the same distance everywhere, in scene units: the usual way. It saves the bound, and is right for a scene of one
    /// size that is seen from near; where it is too small the surface shadows itself in speckles, and where it is too large
    /// shadows come off what throws them, and light gets into corners.
    Fixed(T),
}

impl<T: Real> Offset<T> {
    /// The same offset in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Offset<U> {
        match *self {
            Self::Bounded => Offset::Bounded,
            Self::Fixed(distance) => Offset::Fixed(f(distance)),
        }
    }
}
