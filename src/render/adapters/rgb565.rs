//! 16 bits a pixel.

use core::convert::Infallible;

use super::SizeError;
use super::dither;
use super::packed::Packed;
use crate::render::{Encoding, Framebuffer, Pixel, Size};

/// Which byte of a 16-bit pixel comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ByteOrder {
    /// The byte with red, as the controllers of most small displays take it.
    BigEndian,
    /// The byte with blue, as most processors keep a 16-bit number.
    LittleEndian,
}

/// Two bytes a pixel: 5 bits of red, the highest ones, 6 of green and 5 of blue.
///
/// The 8-bit encoded value is rounded to the nearest level, unless [`dithered`](Self::dithered). A pixel outside of
/// the picture is ignored.
///
/// ```
/// use whit::Rgb;
/// use whit::render::{ByteOrder, Encoding, Framebuffer, Pixel, Rgb565, Size};
/// let mut bytes = [0; 2];
/// let mut picture = Rgb565::new(Size::new(1, 1), &mut bytes, Encoding::Srgb, ByteOrder::BigEndian)?.dithered();
/// picture.put(Pixel { x: 0, y: 0, cell: 1, color: Rgb::new(1.0, 0.0, 0.0) }).unwrap();
/// assert_eq!(u16::from_be_bytes(bytes), 0b11111_000000_00000);
/// # Ok::<(), whit::render::SizeError>(())
/// ```
#[derive(Debug)]
pub struct Rgb565<'a> {
    pixels: Packed<'a, u8, 2>,
    encoding: Encoding,
    order: ByteOrder,
    dithered: bool,
}

impl<'a> Rgb565<'a> {
    /// A picture in `bytes`.
    ///
    /// # Errors
    /// [`SizeError`] unless there are width · height · 2 bytes.
    pub fn new(size: Size, bytes: &'a mut [u8], encoding: Encoding, order: ByteOrder) -> Result<Self, SizeError> {
        Ok(Self { pixels: Packed::new(size, bytes, "bytes")?, encoding, order, dithered: false })
    }

    /// The same picture with ordered dithering, which hides the steps in smooth shades.
    ///
    /// It mixes two neighbouring levels so that the mean of their encoded values is right; as these are close, so is
    /// the mean of the light, nearly. Black and white stay exact.
    #[must_use]
    pub fn dithered(self) -> Self {
        Self { dithered: true, ..self }
    }

    fn bits(&self, pixel: &Pixel) -> u16 {
        let [r, g, b] = self.encoding.encode8(pixel.color);
        let level = |value, max| match self.dithered {
            true => u16::from(dither::level(value, max, pixel.x, pixel.y)),
            false => nearest(value, max),
        };
        level(r, 31) << 11 | level(g, 63) << 5 | level(b, 31)
    }
}

/// From 0..=255 to 0..=`max`. 255 is odd, so that no value is halfway between two levels.
fn nearest(value: u8, max: u8) -> u16 {
    (u16::from(value) * u16::from(max) + 127) / 255
}

impl Framebuffer for Rgb565<'_> {
    type Error = Infallible;

    fn size(&self) -> Size {
        self.pixels.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        let bits = self.bits(&pixel);
        let bytes = match self.order {
            ByteOrder::BigEndian => bits.to_be_bytes(),
            ByteOrder::LittleEndian => bits.to_le_bytes(),
        };
        self.pixels.set(&pixel, bytes);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    const ONE: Size = Size::new(1, 1);

    fn written(color: Rgb<f32>, order: ByteOrder) -> [u8; 2] {
        let mut bytes = [0xAA; 2];
        let mut picture = Rgb565::new(ONE, &mut bytes, Encoding::Display, order).unwrap();
        let Ok(()) = picture.put(Pixel { x: 0, y: 0, cell: 1, color });
        bytes
    }

    #[test]
    fn bytes_have_the_order_asked_for() {
        let color = Rgb::new(1.0, 0.0, 1.0 / 31.0);
        assert_eq!(written(color, ByteOrder::BigEndian), [0xF8, 0x01]);
        assert_eq!(written(color, ByteOrder::LittleEndian), [0x01, 0xF8]);
        assert_eq!(written(Rgb::new(0.0, 1.0, 0.0), ByteOrder::BigEndian), [0x07, 0xE0]);
    }

    #[test]
    fn levels_are_the_nearest() {
        for max in [31, 63] {
            for value in 0..=255 {
                let exact = f64::from(value) * f64::from(max) / 255.0;
                assert_eq!(f64::from(nearest(value, max)), libm::round(exact), "{value} of {max}");
            }
        }
    }

    /// 128 is 15.56 of 31 and 31.62 of 63.
    #[test]
    fn dithering_keeps_the_mean() {
        let mut bytes = [0; 128];
        let mut picture =
            Rgb565::new(Size::new(8, 8), &mut bytes, Encoding::Display, ByteOrder::BigEndian).unwrap().dithered();
        for i in 0..64 {
            let Ok(()) = picture.put(Pixel { x: i % 8, y: i / 8, cell: 1, color: Rgb::grey(128.0 / 255.0) });
        }
        let mut sums = [0; 3];
        for pixel in bytes.chunks_exact(2) {
            let bits = u32::from(pixel[0]) << 8 | u32::from(pixel[1]);
            sums = [sums[0] + (bits >> 11), sums[1] + (bits >> 5 & 63), sums[2] + (bits & 31)];
        }
        for (sum, max) in sums.into_iter().zip([31.0, 63.0, 31.0]) {
            let error = f64::from(sum) / 64.0 - 128.0 / 255.0 * max;
            assert!(error.abs() <= 1.0 / 64.0, "{error}");
        }
    }

    #[test]
    fn wrong_length_is_an_error() {
        let error = Rgb565::new(ONE, &mut [0; 1], Encoding::Srgb, ByteOrder::BigEndian).unwrap_err();
        assert_eq!(error, SizeError { expected: 2, found: 1, unit: "bytes" });
    }
}
