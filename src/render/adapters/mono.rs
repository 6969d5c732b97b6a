//! 1 bit a pixel.

use core::convert::Infallible;

use super::SizeError;
use super::dither;
use crate::render::{Framebuffer, Pixel, Size};

/// Eight pixels a byte, with ordered dithering; 1 is lit.
///
/// The most significant bit is the leftmost pixel, and each row begins with a new byte; the bits that fill up a row
/// stay as they are. This is the layout of a binary PBM (`P4`) after its header, in which 1 is black, however.
///
/// There is no [`Encoding`](crate::render::Encoding) to choose: the light of a screen whose pixels are on or off is in
/// proportion to the number of them that are on, so linear light is compared with the dithering thresholds as it is.
/// Pixels that hold display values ([`Tone::Display`](crate::Tone::Display)) are compared by their luma; as that is
/// not light, middle greys come out brighter than on a screen with more levels. A pixel outside of the picture is
/// ignored.
///
/// ```
/// use whit::Rgb;
/// use whit::render::{Framebuffer, Mono, Pixel, Size};
/// let mut bytes = [0; 4];
/// let mut picture = Mono::new(Size::new(10, 2), &mut bytes)?;
/// for x in 0..10 {
///     picture.put(Pixel { x, y: 1, cell: 1, color: Rgb::WHITE }).unwrap();
/// }
/// assert_eq!(bytes, [0, 0, 0b1111_1111, 0b1100_0000]);
/// # Ok::<(), whit::render::SizeError>(())
/// ```
#[derive(Debug)]
pub struct Mono<'a> {
    size: Size,
    bytes: &'a mut [u8],
}

impl<'a> Mono<'a> {
    /// A picture in `bytes`.
    ///
    /// # Errors
    /// [`SizeError`] unless there are ⌈width / 8⌉ · height bytes.
    pub fn new(size: Size, bytes: &'a mut [u8]) -> Result<Self, SizeError> {
        let expected = u64::from(size.width.div_ceil(8)) * u64::from(size.height);
        SizeError::check(expected, bytes.len(), "bytes")?;
        Ok(Self { size, bytes })
    }

    fn byte(&mut self, pixel: &Pixel) -> Option<&mut u8> {
        if pixel.x >= self.size.width || pixel.y >= self.size.height {
            return None;
        }
        // Inside, every index is below the length of `bytes`, so this does not overflow.
        self.bytes.get_mut(pixel.y as usize * self.size.width.div_ceil(8) as usize + pixel.x as usize / 8)
    }
}

impl Framebuffer for Mono<'_> {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.size
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        let mask = 0x80 >> (pixel.x % 8);
        if let Some(byte) = self.byte(&pixel) {
            *byte = if dither::is_lit(&pixel) { *byte | mask } else { *byte & !mask };
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn put(picture: &mut Mono<'_>, x: u32, y: u32, light: f32) {
        let Ok(()) = picture.put(Pixel { x, y, cell: 1, color: Rgb::grey(light) });
    }

    #[test]
    fn rows_are_padded_to_bytes() {
        let mut bytes = [0; 6];
        let mut picture = Mono::new(Size::new(11, 3), &mut bytes).unwrap();
        for (x, y) in [(0, 0), (7, 0), (8, 0), (10, 1), (1, 2)] {
            put(&mut picture, x, y, 1.0);
        }
        assert_eq!(bytes, [0b1000_0001, 0b1000_0000, 0, 0b0010_0000, 0b0100_0000, 0]);
    }

    #[test]
    fn dark_pixels_clear_their_bit_only() {
        let mut bytes = [0xFF; 2];
        let mut picture = Mono::new(Size::new(11, 1), &mut bytes).unwrap();
        put(&mut picture, 3, 0, 0.0);
        put(&mut picture, 10, 0, 0.0);
        assert_eq!(bytes, [0b1110_1111, 0b1101_1111]);
    }

    #[test]
    fn pixels_outside_change_nothing() {
        let mut bytes = [0x55; 4];
        let mut picture = Mono::new(Size::new(11, 2), &mut bytes).unwrap();
        // The columns 11 to 15 have a bit each, but no pixel.
        for (x, y) in [(11, 0), (15, 1), (0, 2), (u32::MAX, u32::MAX)] {
            put(&mut picture, x, y, 1.0);
            put(&mut picture, x, y, 0.0);
        }
        assert_eq!(bytes, [0x55; 4]);
    }

    /// A quarter of the light: sRGB encodes it as 0.537, which must not decide.
    #[test]
    fn light_is_the_part_of_lit_pixels() {
        let mut bytes = [0; 8];
        let mut picture = Mono::new(Size::new(8, 8), &mut bytes).unwrap();
        for i in 0..64 {
            put(&mut picture, i % 8, i / 8, 0.25);
        }
        assert_eq!(bytes.iter().map(|byte| byte.count_ones()).sum::<u32>(), 16);
    }

    #[test]
    fn wrong_length_is_an_error() {
        let error = Mono::new(Size::new(11, 3), &mut [0; 5]).unwrap_err();
        assert_eq!(error, SizeError { expected: 6, found: 5, unit: "bytes" });
        let error = Mono::new(Size::new(u32::MAX, u32::MAX), &mut []).unwrap_err();
        assert_eq!(error.expected, (1 << 29) * 0xFFFF_FFFF);
    }

    #[test]
    fn empty_pictures_need_no_memory() {
        for size in [Size::new(0, 0), Size::new(9, 0), Size::new(0, 9)] {
            put(&mut Mono::new(size, &mut []).unwrap(), 0, 0, 1.0);
        }
    }
}
