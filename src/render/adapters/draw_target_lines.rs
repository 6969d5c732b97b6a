//! Rows onto a display.

use core::fmt;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::primitives::Rectangle;

use super::placement::{part, place};
use super::{DisplayColor, PlacementError, SizeError};
use crate::render::{Encoding, Framebuffer, Pixel, Size};

/// Sends each row to an `embedded_graphics` draw target when it is complete, by one `fill_contiguous`.
///
/// The row is collected in a buffer of the caller's. When the target fails, the buffer keeps the row, and the next
/// `end_row` sends it again; so a new adapter over the same buffer can go on in the middle of a row, too.
///
/// It is for rendering row by row. From coarse to fine a row has holes until the last pass, so the first coarse pixel
/// is [`LineError::CoarsePixel`]; [`DrawTargetCells`](super::DrawTargetCells) is for that order. Pixels and rows
/// outside of the picture are ignored.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use embedded_graphics::prelude::Point;
/// use whit::Rgb;
/// use whit::render::{DrawTargetLines, Encoding, Framebuffer, Pixel, Size};
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut line = [Rgb565::BLACK; 3];
/// let mut picture =
///     DrawTargetLines::new(&mut display, Size::new(3, 2), &mut line, Encoding::Srgb)?.at(Point::new(10, 20))?;
/// for x in 0..3 {
///     picture.put(Pixel { x, y: 0, cell: 1, color: Rgb::WHITE }).unwrap();
/// }
/// picture.end_row(0).unwrap();
/// assert_eq!(display.get_pixel(Point::new(12, 20)), Some(Rgb565::WHITE));
/// # Ok::<(), whit::render::PlacementError>(())
/// ```
#[derive(Debug)]
pub struct DrawTargetLines<'a, D: DrawTarget, E = Encoding> {
    target: &'a mut D,
    picture: Rectangle,
    line: &'a mut [D::Color],
    colors: E,
}

impl<'a, D: DrawTarget, E: DisplayColor<D::Color>> DrawTargetLines<'a, D, E> {
    /// A picture in the upper left of the target's bounding box. `line` has at least as many entries as a row has
    /// pixels; what they are at first does not matter.
    ///
    /// # Errors
    /// [`PlacementError`] when the line is too short or the picture larger than the target.
    pub fn new(target: &'a mut D, size: Size, line: &'a mut [D::Color], colors: E) -> Result<Self, PlacementError> {
        let bounds = target.bounding_box();
        let picture = place(size, bounds.top_left, bounds)?;
        let found = line.len();
        let too_short = SizeError { expected: u64::from(size.width), found, unit: "pixels" };
        let line = line.get_mut(..size.width as usize).ok_or(PlacementError::Line(too_short))?;
        Ok(Self { target, picture, line, colors })
    }

    /// The same picture with its upper left at this point of the target.
    ///
    /// # Errors
    /// [`PlacementError::Outside`] when the target does not contain all of it.
    pub fn at(self, upper_left: Point) -> Result<Self, PlacementError> {
        Ok(Self { picture: place(self.size(), upper_left, self.target.bounding_box())?, ..self })
    }
}

impl<D: DrawTarget, E: DisplayColor<D::Color>> Framebuffer for DrawTargetLines<'_, D, E> {
    type Error = LineError<D::Error>;

    fn size(&self) -> Size {
        Size::new(self.picture.size.width, self.picture.size.height)
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Self::Error> {
        if pixel.cell > 1 {
            return Err(LineError::CoarsePixel);
        }
        if let Some(entry) = self.line.get_mut(pixel.x as usize) {
            *entry = self.colors.display_color(&pixel);
        }
        Ok(())
    }

    fn end_row(&mut self, y: u32) -> Result<(), Self::Error> {
        let Some(row) = part(self.picture, (0, y), u32::MAX, 1) else { return Ok(()) };
        self.target.fill_contiguous(&row, self.line.iter().copied()).map_err(LineError::Target)
    }
}

/// Why [`DrawTargetLines`] stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineError<E> {
    /// The draw target's own error. Rendering can go on: the row is sent again.
    Target(E),
    /// The picture is rendered from coarse to fine, in which rows are not contiguous.
    CoarsePixel,
}

impl<E: fmt::Display> fmt::Display for LineError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Target(error) => write!(f, "draw target: {error}"),
            Self::CoarsePixel => f.write_str("a coarse pixel; only whole rows can be sent, so render row by row"),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for LineError<E> {}
