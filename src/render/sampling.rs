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

    /// Whether the places of the samples are those of a sequence.
    #[inline]
    pub(crate) fn is_sequence(&self) -> bool {
        self.grid == 0
    }

    /// Where a sample lies within its pixel.
    #[inline]
    pub(crate) fn position(&self, samples: &Samples) -> [T; 2] {
        match self.grid {
            0 => return samples.point(Sequence::PIXEL),
            1 => return [T::HALF; 2],
            _ => {}
        }
        let middle = |i: u32| (T::from_u32(i) + T::HALF) / T::from_u32(self.grid);
        [middle(samples.index % self.grid), middle(samples.index / self.grid)]
    }
}

/// The samples of the pixel at hand, summed up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Accumulator<T: Real> {
    /// Of red, green and blue.
    sums: [T::Wide; 3],
    pub count: u32,
    /// The extremes of the first samples, where it depends on them how many there are.
    darkest: Rgb<T>,
    brightest: Rgb<T>,
}

impl<T: Real> Accumulator<T> {
    pub(crate) const EMPTY: Self = Self { sums: [T::NOTHING; 3], count: 0, darkest: Rgb::BLACK, brightest: Rgb::BLACK };

    /// Forgets the samples.
    #[inline]
    pub(crate) fn clear(&mut self) {
        (self.sums, self.count) = ([T::NOTHING; 3], 0);
    }

    /// Adds a sample and tells whether the pixel is done.
    #[inline]
    pub(crate) fn add(&mut self, color: Rgb<T>, plan: &Plan<T>) -> bool {
        self.count += 1;
        for (sum, light) in self.sums.iter_mut().zip([color.r, color.g, color.b]) {
            *sum = *sum + light.summand();
        }
        self.count >= plan.most || (plan.first > 0 && self.is_even(color, plan))
    }

    /// Whether the first samples, of which this may be one, are known and differ little.
    #[inline(never)]
    fn is_even(&mut self, color: Rgb<T>, plan: &Plan<T>) -> bool {
        if self.count <= plan.first {
            let color = color.max(Rgb::BLACK).min(Rgb::grey(T::MAX));
            let (darkest, brightest) = if self.count == 1 { (color, color) } else { (self.darkest, self.brightest) };
            (self.darkest, self.brightest) = (darkest.min(color), brightest.max(color));
        }
        let spread = self.brightest.zip(self.darkest, |brightest, darkest| brightest - darkest).max_channel();
        self.count >= plan.first && spread <= plan.contrast
    }

    /// The mean of the samples, which may be infinite where lights are huge.
    #[inline]
    pub(crate) fn mean(&self) -> Rgb<T> {
        let [r, g, b] = self.sums.map(|sum| T::mean(sum, self.count));
        Rgb { r, g, b }
    }
}
