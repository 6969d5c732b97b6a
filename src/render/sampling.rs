//! How many samples a pixel takes, and where.

use crate::math::{Real, Rgb};
use crate::trace::Samples;
use crate::trace::Sequence;

/// The samples of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling<T> {
    /// The middles of n×n equal squares; 1 is the middle of the pixel. Lenses and lights with an area take their
    /// points from the sequence.
    Grid(u8),
    /// The first n points of the pixel's [`Sequence`]; powers of two are best.
    Sequence(u32),
    /// The first points of the sequence; where they differ, more of them.
    Adaptive {
        /// How many are always taken.
        first: u32,
        /// How many are taken at most.
        most: u32,
        /// The difference between the brightest and the darkest of the first ones, in any channel, from which on all
        /// are taken.
        contrast: T,
    },
}

impl<T: Real> Sampling<T> {
    /// The largest number of samples a pixel takes.
    #[must_use]
    pub fn most(&self) -> u32 {
        match *self {
            Self::Grid(n) => u32::from(n) * u32::from(n),
            Self::Sequence(n) => n,
            Self::Adaptive { first, most, .. } => first.max(most),
        }
    }

    /// Where a sample lies within its pixel.
    #[inline]
    pub(crate) fn position(&self, samples: &Samples) -> [T; 2] {
        match *self {
            Self::Grid(1) => [T::HALF; 2],
            Self::Grid(n) => {
                let n = u32::from(n.max(1));
                let middle = |i: u32| (T::from_u32(i) + T::HALF) / T::from_u32(n);
                [middle(samples.index % n), middle(samples.index / n)]
            }
            _ => samples.point(Sequence::PIXEL),
        }
    }
}

/// The samples of the pixel at hand, summed up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Accumulator<T> {
    pub sum: Rgb<T>,
    pub count: u32,
    darkest: Rgb<T>,
    brightest: Rgb<T>,
}

impl<T: Real> Accumulator<T> {
    pub(crate) const EMPTY: Self =
        Self { sum: Rgb::BLACK, count: 0, darkest: Rgb::grey(T::MAX), brightest: Rgb::BLACK };

    /// Adds a sample and tells whether the pixel is done.
    #[inline]
    pub(crate) fn add(&mut self, color: Rgb<T>, sampling: &Sampling<T>) -> bool {
        // Huge lights may overflow; a finite pixel is promised. What is not a number would be black, not white.
        let color = color.max(Rgb::BLACK).min(Rgb::grey(T::MAX));
        self.sum += color;
        self.count += 1;
        let Sampling::Adaptive { first, contrast, .. } = *sampling else {
            return self.count >= sampling.most();
        };
        if self.count <= first {
            self.darkest = self.darkest.min(color);
            self.brightest = self.brightest.max(color);
        }
        let spread = self.brightest + self.darkest * -T::ONE;
        let even = self.count >= first && spread.max_channel() <= contrast;
        even || self.count >= sampling.most()
    }

    /// The mean of the samples.
    #[inline]
    pub(crate) fn mean(&self) -> Rgb<T> {
        (self.sum * (T::ONE / T::from_u32(self.count.max(1)))).min(Rgb::grey(T::MAX))
    }
}
