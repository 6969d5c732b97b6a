//! Settings, of pictures that take few rays.

use whit::render::{Order, Sampling, Size};
use whit::{Budget, Real, Settings, Termination};

use super::Source;

impl Source {
    pub fn settings<T: Real>(&mut self) -> Settings<T> {
        let largest = 16 * T::RANGE.unwrap().coordinate as u32 - 1;
        let size = match self.below(12) {
            0 => Size::new(largest, 1),
            1 => Size::new(1, largest),
            _ => Size::new(1 + self.below(6) as u32, 1 + self.below(6) as u32),
        };
        let first = self.below(size.height as usize) as u32;
        let rows = first..(first + 6).min(size.height);
        let sampling = self.sampling();
        let pixels = u64::from(size.width) * u64::from(rows.end - rows.start);
        let fair = (4000 / pixels).clamp(8, 400) as u32 * sampling.most();
        let cutoff = if self.once_in(4) { self.share() } else { 0.0 };
        let budget = Budget {
            cutoff: T::from_f32(cutoff),
            rays_per_pixel: if self.once_in(3) { fair.min(self.below(40) as u32) } else { fair },
            termination: self.termination(),
            ..Budget::with_depth(self.below(9) as u8)
        };
        Settings { size, rows, order: self.pick(&[Order::Rows, Order::CoarseToFine]), sampling, budget }
    }

    fn sampling<T: Real>(&mut self) -> Sampling<T> {
        match self.below(5) {
            0 | 1 => Sampling::Grid(1 + self.below(3) as u8),
            2 => Sampling::Sequence(1 + self.below(8) as u32),
            3 => Sampling::Sequence(20_000),
            _ => Sampling::Adaptive {
                first: self.below(4) as u32,
                most: 1 + self.below(6) as u32,
                contrast: T::from_f32(self.number(0.0, 1e9, &[0.0, 0.01, 0.1, 1.0])),
            },
        }
    }

    fn termination<T: Real>(&mut self) -> Termination<T> {
        match self.below(4) {
            0 | 1 => Termination::Background,
            2 => Termination::Black,
            _ => Termination::Color(self.triple(|source| source.number(0.0, 1e9, &[0.0, 1.0])).map(T::from_f32)),
        }
    }
}
