//! Layers of equal thickness and of one index each.

use crate::math::Real;

/// The layers between two levels, numbered upwards from 0; −1 is all below them and `count` all above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layers<T> {
    pub from: T,
    pub to: T,
    /// How many there are.
    pub count: T,
    /// Of one of them: what was asked for, or a little more, so that they fill the space.
    pub thickness: T,
}

impl<T: Real> Layers<T> {
    /// The layer at a level, the nearest one for levels outside.
    pub(crate) fn at(&self, level: T) -> T {
        ((level - self.from) / self.thickness).floor().max(T::ZERO).min(self.count - T::ONE)
    }

    /// The lower border of a layer.
    pub(crate) fn border(&self, layer: T) -> T {
        if layer < self.count { self.from + layer * self.thickness } else { self.to }
    }

    /// The level whose index a layer has: its middle, and the nearest border for what is outside.
    pub(crate) fn level(&self, layer: T) -> T {
        (self.from + (layer + T::HALF) * self.thickness).max(self.from).min(self.to)
    }

    /// The level whose index a level has. A place on the outer border is taken to be inside, to some roundings.
    pub(crate) fn level_at(&self, level: T) -> T {
        let margin = self.thickness * T::from_f32(1.0 / 1024.0);
        if level < self.from - margin {
            self.from
        } else if level > self.to + margin {
            self.to
        } else {
            self.level(self.at(level))
        }
    }
}
