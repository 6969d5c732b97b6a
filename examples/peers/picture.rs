//! A row of a picture, as bytes.

use whit::render::{Encoding, Framebuffer, Pixel, Size};

/// A row of the picture. When it is full, rendering stops with an error, and goes on when the row has been taken: so what is done
/// with it is not counted.
pub struct Row<const WIDTH: usize, const HEIGHT: u32> {
    pixels: [[u8; 3]; WIDTH],
    is_full: bool,
}

/// The row is to be taken.
pub struct RowIsFull;

impl<const WIDTH: usize, const HEIGHT: u32> Row<WIDTH, HEIGHT> {
    /// The first row, empty.
    pub const EMPTY: Self = Self { pixels: [[0; 3]; WIDTH], is_full: false };

    /// Red, green and blue of each pixel.
    pub fn bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }
}

impl<const WIDTH: usize, const HEIGHT: u32> Framebuffer for Row<WIDTH, HEIGHT> {
    type Error = RowIsFull;

    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT)
    }

    /// The light as it is, from 0 to 1: none of the scenes asks for a curve.
    fn put(&mut self, pixel: Pixel) -> Result<(), RowIsFull> {
        if let Some(place) = self.pixels.get_mut(pixel.x as usize) {
            *place = Encoding::Display.encode8(pixel.color);
        }
        Ok(())
    }

    /// The second call for a row, when rendering goes on, says that it has been taken.
    fn end_row(&mut self, _: u32) -> Result<(), RowIsFull> {
        self.is_full = !self.is_full;
        if self.is_full { Err(RowIsFull) } else { Ok(()) }
    }
}
