//! Pixels as the renderer makes them.

use core::convert::Infallible;

use super::SizeError;
use super::packed::Packed;
use crate::math::Rgb;
use crate::render::{Framebuffer, Pixel, Size};

/// Pixels neither encoded nor limited, for whoever goes on calculating with them.
///
/// They are linear light unless the scene's [`Tone`](crate::Tone) says otherwise. A pixel outside of the picture is
/// ignored.
#[derive(Debug)]
pub struct LinearRgb<'a> {
    pixels: Packed<'a, Rgb<f32>, 1>,
}

impl<'a> LinearRgb<'a> {
    /// A picture in `pixels`.
    ///
    /// # Errors
    /// [`SizeError`] unless there are width · height of them.
    pub fn new(size: Size, pixels: &'a mut [Rgb<f32>]) -> Result<Self, SizeError> {
        Ok(Self { pixels: Packed::new(size, pixels, "pixels")? })
    }
}

impl Framebuffer for LinearRgb<'_> {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.pixels.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        self.pixels.set(&pixel, [pixel.color]);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_stay_as_they_are() {
        let mut pixels = [Rgb::BLACK; 4];
        let color = Rgb::new(-0.5, 1e-20, 7.0);
        let mut picture = LinearRgb::new(Size::new(2, 2), &mut pixels).unwrap();
        let Ok(()) = picture.put(Pixel { x: 0, y: 1, cell: 1, color });
        assert_eq!(pixels, [Rgb::BLACK, Rgb::BLACK, color, Rgb::BLACK]);
    }

    #[test]
    fn wrong_length_is_an_error() {
        let error = LinearRgb::new(Size::new(2, 2), &mut [Rgb::BLACK; 3]).unwrap_err();
        assert_eq!(error, SizeError { expected: 4, found: 3, unit: "pixels" });
    }
}
