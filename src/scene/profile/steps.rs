//! How a bent path is found.

use crate::math::{Real, Vec3};

/// How light is taken through a medium whose index varies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method<T> {
    /// The medium is cut into layers of equal thickness and of one index each. Light goes straight through a layer; at its
    /// border it is refracted by Snell's law, or reflected totally.
    Layers {
        /// Thickness of a layer, in scene units.
        thickness: T,
    },
    /// Along the curve that the ray equation d/ds(n·dx/ds) = ∇n gives.
    Steps(Steps<T>),
}

/// How a curve is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Steps<T> {
    /// In steps of one length, by the method of Störmer and Verlet: of second order; it keeps n·sin θ in layered media, and
    /// the angular momentum around a centre. A path is cut that a step takes out of the range of numbers.
    Fixed {
        /// Length of a step, in scene units; around a black hole as a share of the distance from it.
        length: T,
    },
    /// In steps as long as the tolerance lets them be, by a Runge-Kutta-Nyström method of fourth order (Dormand,
    /// El-Mikkawy and Prince 1987). It keeps n·sin θ in layered media.
    Controlled {
        /// The largest error of one step: of its end, as a share of its length, and of its direction, in radians.
        tolerance: T,
    },
}

/// A black hole that does not turn: light is bent as Schwarzschild's metric has it, and lost behind the horizon, at
/// 2·mass from the centre. Light that comes closer than 3√3·mass, had it gone on straight, does not escape.
///
/// The scene's coordinates are Schwarzschild's, as Cartesian ones: a circle around the hole with the radius r is 2πr long.
/// Directions are those of the coordinates too, so that an eye next to the hole sees what they show and not what an observer
/// at rest there would.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlackHole<T> {
    /// Where it is.
    pub center: Vec3<T>,
    /// GM/c², in scene units.
    pub mass: T,
    /// How light is taken around it.
    pub steps: Steps<T>,
}

/// How light from lights gets to surfaces, through a medium whose index varies or around a black hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShadowRays {
    /// Along a straight line.
    Straight,
    /// Along the bent path that starts towards the light and, found in a few trials, ends there. Where there are more such
    /// paths than one, the light of the others is not seen; where none is found, there is a shadow.
    Bent,
}

impl<T: Real> Method<T> {
    /// The same method in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Method<U> {
        match *self {
            Self::Layers { thickness } => Method::Layers { thickness: f(thickness) },
            Self::Steps(steps) => Method::Steps(steps.map(f)),
        }
    }
}

impl<T: Real> Steps<T> {
    fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Steps<U> {
        match *self {
            Self::Fixed { length } => Steps::Fixed { length: f(length) },
            Self::Controlled { tolerance } => Steps::Controlled { tolerance: f(tolerance) },
        }
    }
}

impl<T: Real> BlackHole<T> {
    /// The same hole in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> BlackHole<U> {
        BlackHole { center: self.center.map(&f), mass: f(self.mass), steps: self.steps.map(f) }
    }
}
