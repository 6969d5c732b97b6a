//! The place of a picture on a draw target.

use core::fmt;

use embedded_graphics_core::geometry::{Point, Size as Extent};
use embedded_graphics_core::primitives::Rectangle;

use super::SizeError;
use crate::render::Size;

/// A picture that does not go onto a draw target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlacementError {
    /// The buffer for a row is too short.
    Line(SizeError),
    /// Some of the picture would be outside of the target; both in the coordinates of the target, in pixels.
    Outside {
        /// Where the picture would be.
        picture: Rectangle,
        /// The target's bounding box.
        target: Rectangle,
    },
}

impl fmt::Display for PlacementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(error) => write!(f, "row: {error}"),
            Self::Outside { picture: p, target: t } => write!(
                f,
                "the picture of {} × {} pixels at ({}, {}) is not within the target's {} × {} at ({}, {})",
                p.size.width,
                p.size.height,
                p.top_left.x,
                p.top_left.y,
                t.size.width,
                t.size.height,
                t.top_left.x,
                t.top_left.y,
            ),
        }
    }
}

impl core::error::Error for PlacementError {}

/// The rectangle of a picture with its upper left at `at`, when `target` contains it.
pub(super) fn place(size: Size, at: Point, target: Rectangle) -> Result<Rectangle, PlacementError> {
    let picture = Rectangle::new(at, Extent::new(size.width, size.height));
    let fits = fits_axis(at.x, size.width, target.top_left.x, target.size.width)
        && fits_axis(at.y, size.height, target.top_left.y, target.size.height);
    if fits { Ok(picture) } else { Err(PlacementError::Outside { picture, target }) }
}

/// 64 bits, in which no sum of a coordinate and a length overflows.
fn fits_axis(start: i32, length: u32, outer_start: i32, outer_length: u32) -> bool {
    let end = i64::from(start) + i64::from(length);
    start >= outer_start && end <= i64::from(outer_start) + i64::from(outer_length)
}

/// The part of `picture` from its pixel (x, y), width × height or what there is of them; nothing when (x, y) is
/// outside.
pub(super) fn part(picture: Rectangle, (x, y): (u32, u32), width: u32, height: u32) -> Option<Rectangle> {
    let extent =
        Extent::new(picture.size.width.checked_sub(x)?.min(width), picture.size.height.checked_sub(y)?.min(height));
    // Within a target whose bounding box has `i32` coordinates nothing saturates.
    let corner =
        Point::new(picture.top_left.x.saturating_add_unsigned(x), picture.top_left.y.saturating_add_unsigned(y));
    (extent.width > 0 && extent.height > 0).then(|| Rectangle::new(corner, extent))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(x: i32, y: i32, width: u32, height: u32) -> Rectangle {
        Rectangle::new(Point::new(x, y), Extent::new(width, height))
    }

    #[test]
    fn pictures_must_be_inside() {
        let target = rectangle(-2, 3, 10, 8);
        let fits = |x, y, width, height| place(Size::new(width, height), Point::new(x, y), target).is_ok();
        assert!(fits(-2, 3, 10, 8) && fits(7, 10, 1, 1) && fits(0, 4, 8, 7));
        assert!(!fits(-3, 3, 10, 8) && !fits(-2, 2, 1, 1) && !fits(-2, 3, 11, 8) && !fits(-2, 3, 10, 9));
        assert!(!fits(8, 10, 1, 1) && !fits(7, 11, 1, 1));
        assert!(!fits(i32::MAX, 3, u32::MAX, 1) && !fits(i32::MIN, 3, u32::MAX, 1));
    }

    #[test]
    fn text_says_both_rectangles() {
        let error = place(Size::new(8, 4), Point::new(3, 0), rectangle(0, 0, 10, 20)).unwrap_err();
        assert_eq!(
            std::format!("{error}"),
            "the picture of 8 × 4 pixels at (3, 0) is not within the target's 10 × 20 at (0, 0)"
        );
        let error = PlacementError::Line(SizeError { expected: 8, found: 5, unit: "pixels" });
        assert_eq!(std::format!("{error}"), "row: the picture needs a buffer of 8 pixels, not of 5");
    }

    #[test]
    fn parts_are_cut_off_at_the_edges() {
        let picture = rectangle(10, 20, 5, 4);
        assert_eq!(part(picture, (0, 0), 8, 8), Some(picture));
        assert_eq!(part(picture, (4, 2), 8, 1), Some(rectangle(14, 22, 1, 1)));
        assert_eq!(part(picture, (5, 0), 1, 1), None);
        assert_eq!(part(picture, (0, 4), 1, 1), None);
        assert_eq!(part(picture, (u32::MAX, u32::MAX), 1, 1), None);
    }
}
