//! From pixels to the colours of `embedded_graphics`.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};

use super::dither;
use crate::render::{Encoding, Pixel};

/// How a pixel becomes the colour `C` of a draw target.
///
/// * [`Encoding`] rounds each channel of the RGB colours to the nearest level. The greys are those of
///   [`Encoding::grey8`] (the conversions of `embedded_graphics` weigh encoded values, which is no luminance).
///   [`BinaryColor`] is dithered like [`Mono`](crate::render::Mono).
/// * [`Dithered`] is for the RGB colours of 15 to 18 bits.
/// * A closure is for the rest, such as the red of electronic paper.
///
/// ```
/// use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
/// use whit::Rgb;
/// use whit::render::{DisplayColor, Encoding, Pixel};
/// let pixel = Pixel { x: 0, y: 0, cell: 1, color: Rgb::new(0.5, 0.0, 0.0) };
/// let color: Rgb565 = Encoding::Srgb.display_color(&pixel);
/// assert_eq!(color, Rgb565::new(23, 0, 0));
/// let is_red = |pixel: &Pixel| BinaryColor::from(pixel.color.r > pixel.color.g + pixel.color.b);
/// assert_eq!(is_red.display_color(&pixel), BinaryColor::On);
/// ```
pub trait DisplayColor<C> {
    /// The colour of the pixel.
    fn display_color(&self, pixel: &Pixel) -> C;

    /// Whether the colour depends on the pixel's place, so that an area of one value has several colours. A closure
    /// counts as one that does not.
    fn is_dithered(&self) -> bool {
        false
    }
}

/// Ordered dithering between the levels of a display with 5 or 6 bits a channel, as in
/// [`Rgb565::dithered`](crate::render::Rgb565::dithered).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dithered(pub Encoding);

impl<C, F: Fn(&Pixel) -> C> DisplayColor<C> for F {
    fn display_color(&self, pixel: &Pixel) -> C {
        self(pixel)
    }
}

macro_rules! nearest {
    ($($color:ty)*) => { $(
        impl DisplayColor<$color> for Encoding {
            fn display_color(&self, pixel: &Pixel) -> $color {
                let [r, g, b] = self.encode8(pixel.color);
                Rgb888::new(r, g, b).into()
            }
        }
    )* };
}

nearest!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);

macro_rules! grey {
    ($($color:ty)*) => { $(
        impl DisplayColor<$color> for Encoding {
            fn display_color(&self, pixel: &Pixel) -> $color {
                Gray8::new(self.grey8(pixel.color)).into()
            }
        }
    )* };
}

grey!(Gray2 Gray4 Gray8);

impl DisplayColor<BinaryColor> for Encoding {
    fn display_color(&self, pixel: &Pixel) -> BinaryColor {
        dither::is_lit(pixel).into()
    }

    fn is_dithered(&self) -> bool {
        true
    }
}

macro_rules! dithered {
    ($($color:ty)*) => { $(
        impl DisplayColor<$color> for Dithered {
            fn display_color(&self, pixel: &Pixel) -> $color {
                let [r, g, b] = self.0.encode8(pixel.color);
                let level = |value, max| dither::level(value, max, pixel.x, pixel.y);
                <$color>::new(level(r, <$color>::MAX_R), level(g, <$color>::MAX_G), level(b, <$color>::MAX_B))
            }

            fn is_dithered(&self) -> bool {
                true
            }
        }
    )* };
}

dithered!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666);

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::GrayColor;

    use super::*;
    use crate::math::Rgb;
    use crate::render::{ByteOrder, Framebuffer, Size};

    fn pixel(i: u32, color: Rgb<f32>) -> Pixel {
        Pixel { x: i % 8, y: i / 8, cell: 1, color }
    }

    /// The memory adapter has its own rounding.
    #[test]
    fn colors_are_those_of_the_memory_adapter() {
        for i in 0..64 {
            let pixel = pixel(i, Rgb::new(i as f32 / 63.0, 0.3, 0.7));
            let mut plain = [0; 128];
            let mut dithered = [0; 128];
            let size = Size::new(8, 8);
            let memory = |bytes| crate::render::Rgb565::new(size, bytes, Encoding::Srgb, ByteOrder::BigEndian).unwrap();
            let Ok(()) = memory(&mut plain).put(pixel);
            let Ok(()) = memory(&mut dithered).dithered().put(pixel);
            let at = i as usize * 2;
            let bits = |color: Rgb565| [color.r() << 3 | color.g() >> 3, color.g() << 5 | color.b()];
            assert_eq!(bits(Encoding::Srgb.display_color(&pixel)), plain[at..at + 2]);
            assert_eq!(bits(Dithered(Encoding::Srgb).display_color(&pixel)), dithered[at..at + 2]);
        }
    }

    /// `Gray8::from(Rgb888::GREEN)` of `embedded_graphics` is 149; sRGB of the luminance 0.7152 is 219.8.
    #[test]
    fn grey_is_encoded_luminance() {
        let grey: Gray8 = Encoding::Srgb.display_color(&pixel(0, Rgb::new(0.0, 1.0, 0.0)));
        assert_eq!(grey.luma(), 220);
        let grey: Gray2 = Encoding::Srgb.display_color(&pixel(0, Rgb::WHITE));
        assert_eq!(grey.luma(), 3);
    }

    #[test]
    fn one_bit_is_dithered() {
        let is_lit = |&i: &u32| BinaryColor::On == Encoding::Srgb.display_color(&pixel(i, Rgb::grey(0.25)));
        assert_eq!((0..64).filter(is_lit).count(), 16);
    }

    #[test]
    fn channels_of_each_color_are_where_they_belong() {
        let pixel = pixel(0, Rgb::new(1.0, 0.0, 0.0));
        assert_eq!(Bgr565::RED, Encoding::Srgb.display_color(&pixel));
        assert_eq!(Bgr565::RED, Dithered(Encoding::Srgb).display_color(&pixel));
        assert_eq!(Rgb666::RED, Dithered(Encoding::Srgb).display_color(&pixel));
        assert_eq!(Rgb888::RED, Encoding::Srgb.display_color(&pixel));
    }
}
