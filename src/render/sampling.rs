//! How many samples a pixel takes, and where.

use crate::math::{Real, Rgb};
use crate::trace::{Samples, Sequence};

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
}

/// The samples of each pixel of a frame, as numbers: whatever was asked, one piece of code takes them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan<T> {
    /// How many squares there are in a row of the grid; 0 where samples are points of the sequence.
    grid: u32,
    first: u32,
    most: u32,
    /// Where no contrast is small enough to stop early, a number below 0.
    contrast: T,
}

impl<T: Real> Plan<T> {
    pub(crate) fn new(sampling: &Sampling<T>) -> Self {
        let most = sampling.most();
        match *sampling {
            Sampling::Grid(n) => Self { grid: n.into(), first: 0, most, contrast: -T::ONE },
            Sampling::Sequence(_) => Self { grid: 0, first: 0, most, contrast: -T::ONE },
            Sampling::Adaptive { first, contrast, .. } => Self { grid: 0, first, most, contrast },
        }
    }

    /// Where a sample lies within its pixel.
    #[inline]
    pub(crate) fn position(&self, samples: &Samples) -> [T; 2] {
        if self.grid == 0 {
            return samples.point(Sequence::PIXEL);
        }
        let middle = |i: u32| (T::from_u32(i) + T::HALF) / T::from_u32(self.grid);
        [middle(samples.index % self.grid), middle(samples.index / self.grid)]
    }
}

/// The samples of the pixel at hand, summed up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Accumulator<T: Real> {
    /// Red, green and blue.
    channels: [Channel<T>; 3],
    pub count: u32,
}

#[derive(Clone, Copy, Debug)]
struct Channel<T: Real> {
    sum: T::Wide,
    darkest: T,
    brightest: T,
}

impl<T: Real> Accumulator<T> {
    pub(crate) const EMPTY: Self =
        Self { channels: [Channel { sum: T::NOTHING, darkest: T::MAX, brightest: T::ZERO }; 3], count: 0 };

    /// Adds a sample and tells whether the pixel is done.
    #[inline]
    pub(crate) fn add(&mut self, color: Rgb<T>, plan: &Plan<T>) -> bool {
        self.count += 1;
        let mut spread = T::ZERO;
        for (channel, light) in self.channels.iter_mut().zip([color.r, color.g, color.b]) {
            // Huge lights may overflow; a finite pixel is promised. What is not a number would be black, not white.
            let light = light.max(T::ZERO).min(T::MAX);
            channel.sum = channel.sum + light.summand();
            if self.count <= plan.first {
                channel.darkest = channel.darkest.min(light);
                channel.brightest = channel.brightest.max(light);
            }
            spread = spread.max(channel.brightest - channel.darkest);
        }
        (self.count >= plan.first && spread <= plan.contrast) || self.count >= plan.most
    }

    /// The mean of the samples. The sum of some that are finite may not be.
    #[inline]
    pub(crate) fn mean(&self) -> Rgb<T> {
        let [r, g, b] = self.channels.each_ref().map(|channel| T::mean(channel.sum, self.count.max(1)));
        Rgb { r, g, b }
    }
}
