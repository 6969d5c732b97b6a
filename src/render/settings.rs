//! What is asked of a frame.

use core::fmt;
use core::ops::Range;

use super::{Order, Sampling, Size};
use crate::math::Real;
use crate::trace::{Budget, MOST_BOUNCES, Termination};

/// What is to be rendered, and how well.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings<T> {
    /// The size of the whole picture.
    pub size: Size,
    /// The rows of it that are rendered; others come from other frames, with the same bits in any division.
    pub rows: Range<u32>,
    /// In which order.
    pub order: Order,
    /// The samples of a pixel.
    pub sampling: Sampling<T>,
    /// The limits of each ray tree.
    pub budget: Budget<T>,
}

impl<T: Real> Settings<T> {
    /// All rows of a picture, row by row, one sample in the middle of each pixel; 8 bounces of branches that weigh at least 1/255.
    ///
    /// The depth and the cutoff are those that most built-in scenes get the most accuracy for their time from:
    /// `docs/accuracy.md`.
    #[must_use]
    pub const fn new(width: u32, height: u32) -> Self {
        Self {
            size: Size::new(width, height),
            rows: 0..height,
            order: Order::Rows,
            sampling: Sampling::Grid(1),
            budget: Budget { cutoff: T::DISPLAY_STEP, ..Budget::with_depth(8) },
        }
    }

    /// The same settings with another number of bounces.
    #[must_use]
    pub fn with_depth(self, depth: u8) -> Self {
        Self { budget: Budget { depth, ..self.budget }, ..self }
    }

    /// The same settings with other samples.
    #[must_use]
    pub fn with_sampling(self, sampling: Sampling<T>) -> Self {
        Self { sampling, ..self }
    }

    pub(super) fn check(&self, depth: usize) -> Result<(), SettingsError> {
        // In fixed point a column must be a number.
        let largest = T::RANGE.map_or(Size::LARGEST, |range| 16 * range.coordinate as u32 - 1);
        let side = 1..=largest;
        if !side.contains(&self.size.width) || !side.contains(&self.size.height) {
            return Err(SettingsError::Size { asked: self.size, largest });
        }
        if self.rows.is_empty() || self.rows.end > self.size.height {
            return Err(SettingsError::Rows { start: self.rows.start, end: self.rows.end, height: self.size.height });
        }
        let most = depth.min(usize::from(MOST_BOUNCES));
        if usize::from(self.budget.depth) > most {
            return Err(SettingsError::Depth { asked: self.budget.depth, most });
        }
        let finite = |x: T| x >= T::ZERO && x <= T::MAX;
        if !finite(self.budget.cutoff) {
            return Err(SettingsError::NotAnAmount("cutoff"));
        }
        if let Termination::Color(color) = self.budget.termination {
            if !(finite(color.r) && finite(color.g) && finite(color.b)) {
                return Err(SettingsError::NotAnAmount("termination"));
            }
        }
        if let Sampling::Adaptive { contrast, .. } = self.sampling {
            if !finite(contrast) {
                return Err(SettingsError::NotAnAmount("contrast"));
            }
        }
        if self.sampling.most() == 0 {
            return Err(SettingsError::NoSamples);
        }
        Ok(())
    }
}

/// Why a frame cannot be rendered as asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingsError {
    /// The picture has no pixels, or too many in a row or column.
    Size {
        /// What was asked.
        asked: Size,
        /// The most there may be: [`Size::LARGEST`], or less in fixed point.
        largest: u32,
    },
    /// The rows are none, or not all in the picture.
    Rows {
        /// First row.
        start: u32,
        /// Row after the last.
        end: u32,
        /// Rows of the picture.
        height: u32,
    },
    /// More bounces than the tracer's stack has room for, or than can be counted.
    Depth {
        /// What was asked.
        asked: u8,
        /// The tracer's `DEPTH`, or 254 where that is more.
        most: usize,
    },
    /// A number that must be finite and not negative.
    NotAnAmount(&'static str),
    /// No samples at all.
    NoSamples,
}

impl fmt::Display for SettingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { asked: Size { width, height }, largest } => {
                write!(f, "a picture of {width}×{height}: expected 1 to {largest} pixels a side")
            }
            Self::Rows { start, end, height } => {
                write!(f, "rows {start}..{end}: expected one row or more within 0..{height}")
            }
            Self::Depth { asked, most } => write!(f, "depth {asked}: the tracer's stack has room for {most}"),
            Self::NotAnAmount(field) => write!(f, "{field}: expected a finite number of at least 0"),
            Self::NoSamples => f.write_str("samples: expected at least 1 a pixel"),
        }
    }
}

impl core::error::Error for SettingsError {}
