//! Where finished pixels go.

use crate::math::Rgb;

/// The size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Size {
    /// The most pixels a side: all their numbers are exact in `f32`.
    pub const LARGEST: u32 = 1 << 20;

    /// A size.
    pub const fn new(width: u32, height: u32) -> Self {
        Self { width, height }
    }

    /// How many pixels there are.
    #[must_use]
    pub const fn pixels(self) -> u64 {
        self.width as u64 * self.height as u64
    }
}

/// A finished pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Column, from the left.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
    /// The side of the square, with this pixel at its upper left, of which this is the first pixel to be known: 1 row
    /// by row; 8, 4, 2 or 1 from coarse to fine. A screen that shows a preview fills the square.
    pub cell: u32,
    /// Finite, linear (or as the scene's [`Tone`](crate::Tone) says), not limited to 1.
    pub color: Rgb<f32>,
}

/// A target for pixels: memory, a display, a file.
///
/// The target owns its memory; the renderer holds one pixel at a time. It hands over each pixel exactly once and says
/// when a row, or the row of one coarse-to-fine pass, is complete: the moment to send a line, or to swap the two
/// buffers of a DMA transfer. After an error the same call is made again when rendering goes on.
pub trait Framebuffer {
    /// What can go wrong; [`Infallible`](core::convert::Infallible) for memory.
    type Error;

    /// The size of the whole picture, whichever rows of it are rendered.
    fn size(&self) -> Size;

    /// Takes a pixel.
    ///
    /// # Errors
    /// The target's own; rendering stops there and can go on.
    fn put(&mut self, pixel: Pixel) -> Result<(), Self::Error>;

    /// Row `y` (of this pass) is complete.
    ///
    /// # Errors
    /// The target's own; rendering stops there and can go on.
    fn end_row(&mut self, y: u32) -> Result<(), Self::Error> {
        let _ = y;
        Ok(())
    }
}

impl<F: Framebuffer + ?Sized> Framebuffer for &mut F {
    type Error = F::Error;

    fn size(&self) -> Size {
        (**self).size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Self::Error> {
        (**self).put(pixel)
    }

    fn end_row(&mut self, y: u32) -> Result<(), Self::Error> {
        (**self).end_row(y)
    }
}
