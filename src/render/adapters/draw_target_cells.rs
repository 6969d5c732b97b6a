//! Squares onto a display.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size as Extent};
use embedded_graphics_core::primitives::Rectangle;

use super::placement::{part, place};
use super::{DisplayColor, PlacementError};
use crate::render::{Encoding, Framebuffer, Pixel, Size};

/// Fills the [`cell`](Pixel::cell) of each pixel on an `embedded_graphics` draw target: by one `fill_solid`, or, if the
/// colours are dithered, by one `fill_contiguous`.
///
/// It needs no memory. From coarse to fine a slow display shows a preview at once, which is then refined. Row by row
/// each pixel is a call of its own, so that [`DrawTargetLines`](super::DrawTargetLines) is the faster one. A square is
/// cut off at the edges of the picture; a pixel outside of it is ignored. When only some rows of the picture are
/// rendered, the last squares may reach below them.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::BinaryColor;
/// use whit::Rgb;
/// use whit::render::{DrawTargetCells, Encoding, Framebuffer, Pixel, Size};
/// let mut display = MockDisplay::<BinaryColor>::new();
/// let mut picture = DrawTargetCells::new(&mut display, Size::new(5, 3), Encoding::Srgb)?;
/// picture.put(Pixel { x: 0, y: 0, cell: 4, color: Rgb::WHITE }).unwrap();
/// display.assert_pattern(&["####", "####", "####"]);
/// # Ok::<(), whit::render::PlacementError>(())
/// ```
#[derive(Debug)]
pub struct DrawTargetCells<'a, D, E = Encoding> {
    target: &'a mut D,
    picture: Rectangle,
    colors: E,
}

impl<'a, D: DrawTarget, E: DisplayColor<D::Color>> DrawTargetCells<'a, D, E> {
    /// A picture in the upper left of the target's bounding box.
    ///
    /// # Errors
    /// [`PlacementError::Outside`] when the picture is larger than the target.
    pub fn new(target: &'a mut D, size: Size, colors: E) -> Result<Self, PlacementError> {
        let bounds = target.bounding_box();
        let picture = place(size, bounds.top_left, bounds)?;
        Ok(Self { target, picture, colors })
    }

    /// The same picture with its upper left at this point of the target.
    ///
    /// # Errors
    /// [`PlacementError::Outside`] when the target does not contain all of it.
    pub fn at(self, upper_left: Point) -> Result<Self, PlacementError> {
        Ok(Self { picture: place(self.size(), upper_left, self.target.bounding_box())?, ..self })
    }
}

impl<D: DrawTarget, E: DisplayColor<D::Color>> Framebuffer for DrawTargetCells<'_, D, E> {
    type Error = D::Error;

    fn size(&self) -> Size {
        Size::new(self.picture.size.width, self.picture.size.height)
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), D::Error> {
        let colors = &self.colors;
        match part(self.picture, (pixel.x, pixel.y), pixel.cell, pixel.cell) {
            // Coarse pixels have low places in the dithering matrix only: one colour for the cell would be too light.
            Some(cell) if pixel.cell > 1 && colors.is_dithered() => {
                let colors = pixels(pixel, cell.size).map(|pixel| colors.display_color(&pixel));
                self.target.fill_contiguous(&cell, colors)
            }
            Some(cell) => self.target.fill_solid(&cell, colors.display_color(&pixel)),
            None => Ok(()),
        }
    }
}

/// The pixels of a cell that is inside the picture, row by row.
fn pixels(first: Pixel, extent: Extent) -> impl Iterator<Item = Pixel> {
    let row = move |y| (0..extent.width).map(move |x| Pixel { x: first.x + x, y: first.y + y, cell: 1, ..first });
    (0..extent.height).flat_map(row)
}
