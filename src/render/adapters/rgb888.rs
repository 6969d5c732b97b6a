//! 24 bits a pixel.

use core::convert::Infallible;

use super::SizeError;
use super::packed::Packed;
use crate::render::{Encoding, Framebuffer, Pixel, Size};

/// Three bytes a pixel: red, green, blue.
///
/// The layout of a binary PPM (`P6`) after its header. A pixel outside of the picture is ignored.
///
/// ```
/// use whit::Rgb;
/// use whit::render::{Encoding, Framebuffer, Pixel, Rgb888, Size};
/// let mut bytes = [0; 2 * 3];
/// let mut picture = Rgb888::new(Size::new(2, 1), &mut bytes, Encoding::Srgb)?;
/// picture.put(Pixel { x: 1, y: 0, cell: 1, color: Rgb::new(1.0, 0.5, 0.0) }).unwrap();
/// assert_eq!(bytes, [0, 0, 0, 255, 188, 0]);
/// # Ok::<(), whit::render::SizeError>(())
/// ```
#[derive(Debug)]
pub struct Rgb888<'a> {
    pixels: Packed<'a, u8, 3>,
    encoding: Encoding,
}

impl<'a> Rgb888<'a> {
    /// A picture in `bytes`.
    ///
    /// # Errors
    /// [`SizeError`] unless there are width · height · 3 bytes.
    pub fn new(size: Size, bytes: &'a mut [u8], encoding: Encoding) -> Result<Self, SizeError> {
        Ok(Self { pixels: Packed::new(size, bytes, "bytes")?, encoding })
    }
}

impl Framebuffer for Rgb888<'_> {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.pixels.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        self.pixels.set(&pixel, self.encoding.encode8(pixel.color));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    #[test]
    fn channels_are_red_green_blue() {
        let mut bytes = [9; 12];
        let mut picture = Rgb888::new(Size::new(2, 2), &mut bytes, Encoding::Display).unwrap();
        let Ok(()) = picture.put(Pixel { x: 0, y: 1, cell: 1, color: Rgb::new(0.2, 0.4, 0.6) });
        assert_eq!(bytes, [9, 9, 9, 9, 9, 9, 51, 102, 153, 9, 9, 9]);
    }

    #[test]
    fn wrong_length_is_an_error() {
        let error = Rgb888::new(Size::new(2, 2), &mut [0; 4], Encoding::Srgb).unwrap_err();
        assert_eq!(error, SizeError { expected: 12, found: 4, unit: "bytes" });
    }
}
