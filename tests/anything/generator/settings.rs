//! Sizes, samples and budgets.

use whit::render::{Order, Sampling, Size};
use whit::{Budget, Settings, Termination};

use super::Source;
use super::span::FINITE;

/// So many rays at most are asked for in a whole picture, unless it is one that is not meant to be finished.
const RAYS: u32 = 2000;

impl Source<'_> {
    pub fn settings(&mut self) -> Settings<f32> {
        let size = self.picture_size();
        let sampling = self.sampling();
        Settings { size, rows: self.rows(size.height), order: self.order(), sampling, budget: self.budget(size) }
    }

    fn picture_size(&mut self) -> Size {
        let small = Size::new(1 + self.below(8) as u32, 1 + self.below(8) as u32);
        match self.below(24) {
            20 => Size::new(64, 1),
            21 => Size::new(1, 64),
            22 => Size::new(Size::LARGEST, small.height),
            23 => Size::new(small.width, Size::LARGEST),
            19 if self.is_wild => Size::new(self.word(), self.word()),
            _ => small,
        }
    }

    fn rows(&mut self, height: u32) -> core::ops::Range<u32> {
        if !self.once_in(6) {
            return 0..height;
        }
        if self.is_wild {
            return self.word()..self.word();
        }
        let start = self.word() % height.max(1);
        start..(start + 1 + self.below(8) as u32).min(height)
    }

    fn order(&mut self) -> Order {
        self.pick(&[Order::Rows, Order::CoarseToFine], Order::Rows)
    }

    fn sampling(&mut self) -> Sampling<f32> {
        match self.below(8) {
            0..=3 => Sampling::Grid(1),
            4 => Sampling::Grid(1 + self.byte() % 3),
            5 if self.is_wild => Sampling::Grid(self.byte()),
            6 => {
                let (first, most) = (self.below(4) as u32, 1 + self.below(6) as u32);
                Sampling::Adaptive { first, most, contrast: self.number(FINITE) }
            }
            7 if self.is_wild => Sampling::Sequence(self.word()),
            _ => Sampling::Sequence(1 + self.below(8) as u32),
        }
    }

    fn budget(&mut self, size: Size) -> Budget<f32> {
        let fair = u32::try_from(u64::from(RAYS) / size.pixels().max(1)).unwrap_or(0);
        let rays_per_pixel = match self.below(12) {
            0..=5 => fair,
            6..=8 => fair.min(self.below(40) as u32),
            9 => fair.min(self.below(5) as u32),
            10 => fair / 2,
            _ => u32::MAX,
        };
        let cutoff = if self.once_in(4) { self.number(FINITE) } else { 0.0 };
        let depth = if self.is_wild { self.byte() } else { 8 - self.byte() % 9 };
        Budget { cutoff, rays_per_pixel, termination: self.termination(), ..Budget::with_depth(depth) }
    }

    fn termination(&mut self) -> Termination<f32> {
        match self.below(4) {
            0 | 1 => Termination::Background,
            2 => Termination::Black,
            _ => Termination::Color(self.triple(FINITE)),
        }
    }
}
