//! Rays from anywhere to anywhere.

use whit::{Ray, Vec3};

use super::Source;
use super::points::exact_unit;

impl Source<'_> {
    pub fn ray(&mut self) -> Ray<f32> {
        let origin = self.point();
        let direction = match self.below(6) {
            0 => self.axis(),
            // Along an axis but for a very little.
            1 => {
                let tiny = self.pick(&[1e-45, -1e-40, 1e-30, 1e-20, 6e-8, -1e-7, 1e-4], 0.0);
                exact_unit(self.axis() + self.axis() * tiny)
            }
            2 => exact_unit(self.direction() - origin),
            _ => exact_unit(self.direction()),
        };
        let is_unit = (direction.length_squared() - 1.0).abs() < 1e-6;
        Ray { origin, direction: if is_unit { direction } else { Vec3::new(0.0, -0.0, 1.0) } }
    }
}
