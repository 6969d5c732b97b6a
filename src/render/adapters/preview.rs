//! Coarse pixels made visible.

use crate::render::{Framebuffer, Pixel, Size};

/// Fills the whole square of a coarse pixel, so that memory which is shown while it is rendered from coarse to fine
/// shows a preview: each pixel of the [`cell`](Pixel::cell) inside the picture is put into the inner framebuffer.
///
/// None of the square's other pixels is known yet; each is put again when it is. Row by row it makes no difference.
/// After an error the square is begun anew, so the inner framebuffer gets some pixels twice. When only some rows of the
/// picture are rendered, the last squares may reach below them.
///
/// ```
/// use whit::Rgb;
/// use whit::render::{Encoding, Framebuffer, Grey8, Pixel, Preview, Size};
/// let mut bytes = [0; 12];
/// let mut picture = Preview(Grey8::new(Size::new(4, 3), &mut bytes, Encoding::Srgb)?);
/// picture.put(Pixel { x: 2, y: 0, cell: 2, color: Rgb::WHITE }).unwrap();
/// assert_eq!(bytes, [0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 0, 0]);
/// # Ok::<(), whit::render::SizeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Preview<F>(pub F);

impl<F: Framebuffer> Framebuffer for Preview<F> {
    type Error = F::Error;

    fn size(&self) -> Size {
        self.0.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), F::Error> {
        let Size { width, height } = self.0.size();
        for y in pixel.y..pixel.y.saturating_add(pixel.cell).min(height) {
            for x in pixel.x..pixel.x.saturating_add(pixel.cell).min(width) {
                self.0.put(Pixel { x, y, cell: 1, color: pixel.color })?;
            }
        }
        Ok(())
    }

    fn end_row(&mut self, y: u32) -> Result<(), F::Error> {
        self.0.end_row(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;
    use crate::render::LinearRgb;

    fn filled(pixel: Pixel) -> [f32; 15] {
        let mut pixels = [Rgb::BLACK; 15];
        let Ok(()) = Preview(LinearRgb::new(Size::new(5, 3), &mut pixels).unwrap()).put(pixel);
        pixels.map(|pixel| pixel.r)
    }

    #[test]
    fn squares_are_cut_off_at_the_edges() {
        let color = Rgb::WHITE;
        #[rustfmt::skip]
        assert_eq!(filled(Pixel { x: 4, y: 0, cell: 2, color }), [
            0.0, 0.0, 0.0, 0.0, 1.0,
            0.0, 0.0, 0.0, 0.0, 1.0,
            0.0, 0.0, 0.0, 0.0, 0.0,
        ]);
        assert_eq!(filled(Pixel { x: 0, y: 0, cell: u32::MAX, color }), [1.0; 15]);
        assert_eq!(filled(Pixel { x: u32::MAX, y: u32::MAX, cell: 8, color }), [0.0; 15]);
    }
}
