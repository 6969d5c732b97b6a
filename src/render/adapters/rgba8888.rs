//! 32 bits a pixel.

use core::convert::Infallible;

use super::SizeError;
use super::packed::Packed;
use crate::render::{Encoding, Framebuffer, Pixel, Size};

/// Four bytes a pixel: red, green, blue, and 255 for alpha.
///
/// The layout of a web page's `ImageData`. A pixel outside of the picture is ignored.
#[derive(Debug)]
pub struct Rgba8888<'a> {
    pixels: Packed<'a, u8, 4>,
    encoding: Encoding,
}

impl<'a> Rgba8888<'a> {
    /// A picture in `bytes`.
    ///
    /// # Errors
    /// [`SizeError`] unless there are width · height · 4 bytes.
    pub fn new(size: Size, bytes: &'a mut [u8], encoding: Encoding) -> Result<Self, SizeError> {
        Ok(Self { pixels: Packed::new(size, bytes, "bytes")?, encoding })
    }
}

impl Framebuffer for Rgba8888<'_> {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.pixels.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        let [r, g, b] = self.encoding.encode8(pixel.color);
        self.pixels.set(&pixel, [r, g, b, 255]);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    #[test]
    fn pixels_are_opaque() {
        let mut bytes = [9; 8];
        let mut picture = Rgba8888::new(Size::new(2, 1), &mut bytes, Encoding::Display).unwrap();
        let Ok(()) = picture.put(Pixel { x: 1, y: 0, cell: 1, color: Rgb::new(0.2, 0.4, 0.6) });
        assert_eq!(bytes, [9, 9, 9, 9, 51, 102, 153, 255]);
    }

    #[test]
    fn wrong_length_is_an_error() {
        let error = Rgba8888::new(Size::new(2, 2), &mut [0; 12], Encoding::Srgb).unwrap_err();
        assert_eq!(error, SizeError { expected: 16, found: 12, unit: "bytes" });
    }
}
