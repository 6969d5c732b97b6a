//! Cameras.

use whit::scene::{Aperture, Extent, Lens};
use whit::{Camera, Vec3};

use super::Source;
use super::shapes::away_from;
use super::span::{AMOUNT, POSITIVE, TANGENT};

impl Source<'_> {
    pub fn camera(&mut self) -> Camera<f32> {
        let eye = if self.once_in(2) { self.point() } else { Vec3::new(0.0, 0.0, 8.0) * self.scale.min(1e11) };
        let target = self.point();
        let is_away = self.is_wild || (target - eye).length_squared() > 1e-24;
        let target = if is_away { target } else { away_from(eye) };
        let extent = self.pick(&[Extent::PixelEdges, Extent::PixelCentres], Extent::PixelEdges);
        let lens = if self.once_in(3) { Some(self.lens()) } else { None };
        let (up, half_height) = (self.up(target - eye), self.number(TANGENT));
        Camera { eye, target, up, half_height, extent, lens }
    }

    /// Sometimes as near to the line of sight as may be.
    fn up(&mut self, sight: Vec3<f32>) -> Vec3<f32> {
        let up = self.direction();
        if self.is_wild || is_apart(sight, up) {
            return up;
        }
        let aside = Vec3::new(1.0, 0.0, 0.0) * (sight.length() * 0.001_1);
        [sight + aside, Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)]
            .into_iter()
            .find(|up| is_apart(sight, *up))
            .unwrap_or(up)
    }

    fn lens(&mut self) -> Lens<f32> {
        let size = self.size(AMOUNT);
        let aperture = match self.below(2) {
            0 => Aperture::Disc { radius: size },
            _ => Aperture::Square { side: size },
        };
        Lens { aperture, focus: self.size(POSITIVE) }
    }
}

/// Whether validation would tell the two directions apart.
fn is_apart(sight: Vec3<f32>, up: Vec3<f32>) -> bool {
    let along = sight.dot(up);
    along * along < 0.999_999 * sight.length_squared() * up.length_squared()
}
