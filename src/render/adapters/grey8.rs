//! 8 bits a pixel, no colour.

use core::convert::Infallible;

use super::SizeError;
use super::packed::Packed;
use crate::render::{Encoding, Framebuffer, Pixel, Size};

/// One byte a pixel: the encoded luminance, see [`Encoding::grey8`].
///
/// The layout of a binary PGM (`P5`) after its header. A pixel outside of the picture is ignored.
#[derive(Debug)]
pub struct Grey8<'a> {
    pixels: Packed<'a, u8, 1>,
    encoding: Encoding,
}

impl<'a> Grey8<'a> {
    /// A picture in `bytes`.
    ///
    /// # Errors
    /// [`SizeError`] unless there are width · height bytes.
    pub fn new(size: Size, bytes: &'a mut [u8], encoding: Encoding) -> Result<Self, SizeError> {
        Ok(Self { pixels: Packed::new(size, bytes, "bytes")?, encoding })
    }
}

impl Framebuffer for Grey8<'_> {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.pixels.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        self.pixels.set(&pixel, [self.encoding.grey8(pixel.color)]);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    /// sRGB of a luminance of 0.2126 is 0.4985, 127.1 of 255; the luma of encoded red would be 54.
    #[test]
    fn luminance_is_encoded() {
        let mut bytes = [9; 4];
        let mut picture = Grey8::new(Size::new(2, 2), &mut bytes, Encoding::Srgb).unwrap();
        let Ok(()) = picture.put(Pixel { x: 1, y: 1, cell: 1, color: Rgb::new(1.0, 0.0, 0.0) });
        assert_eq!(bytes, [9, 9, 9, 127]);
    }

    #[test]
    fn wrong_length_is_an_error() {
        let error = Grey8::new(Size::new(2, 2), &mut [0; 5], Encoding::Srgb).unwrap_err();
        assert_eq!(error, SizeError { expected: 4, found: 5, unit: "bytes" });
    }
}
