//! The order in which pixels are rendered.

use core::ops::Range;

/// The order in which the pixels of a frame are rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Order {
    /// Row by row, from left to right.
    #[default]
    Rows,
    /// Every 8th pixel of every 8th row, then those between at every 4th, every 2nd, and the rest; each pixel once.
    CoarseToFine,
}

impl Order {
    /// The distance between the pixels of the first pass.
    const fn coarsest(self) -> u32 {
        match self {
            Self::Rows => 1,
            Self::CoarseToFine => 8,
        }
    }
}

/// The pixel whose turn it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cursor {
    pub x: u32,
    pub y: u32,
    /// The distance between the pixels of this pass and the last one together.
    pub cell: u32,
    order: Order,
}

/// What comes after a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Next {
    SameRow,
    OtherRow,
    End,
}

impl Cursor {
    /// The first pixel of some rows, which must not be empty.
    #[inline]
    pub(crate) fn new(width: u32, rows: &Range<u32>, order: Order) -> Self {
        let cell = order.coarsest();
        let mut cursor = Self { x: 0, y: first_row(rows, cell), cell, order };
        if cursor.y >= rows.end {
            cursor.find_row(width, rows);
        }
        cursor
    }

    /// Moves to the next pixel.
    #[inline]
    pub(crate) fn advance(&mut self, width: u32, rows: &Range<u32>) -> Next {
        // In the only pass there is, no pixel is passed over.
        let step = if self.order == Order::Rows { 1 } else { self.columns().1 };
        self.x = self.x.saturating_add(step);
        if self.x < width {
            return Next::SameRow;
        }
        self.find_row(width, rows)
    }

    /// Moves to the next row, of this pass or the next, that has a pixel.
    #[inline(never)]
    fn find_row(&mut self, width: u32, rows: &Range<u32>) -> Next {
        while self.cell > 0 {
            self.y = self.y.saturating_add(self.cell);
            while self.y >= rows.end {
                self.cell /= 2;
                if self.cell == 0 {
                    return Next::End;
                }
                self.y = first_row(rows, self.cell);
            }
            self.x = self.columns().0;
            if self.x < width {
                return Next::OtherRow;
            }
        }
        Next::End
    }

    /// The first column of this row and the distance to the next: without those of coarser passes.
    fn columns(&self) -> (u32, u32) {
        let coarser = self.cell * 2;
        let seen = self.cell < self.order.coarsest() && self.y.is_multiple_of(coarser);
        if seen { (self.cell, coarser) } else { (0, self.cell) }
    }
}

/// The first of the rows that is a multiple of `cell`, a power of two.
#[inline]
const fn first_row(rows: &Range<u32>, cell: u32) -> u32 {
    rows.start.wrapping_add(cell - 1) & !(cell - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_has_its_turn_once() {
        for (width, rows) in [(1, 0..1), (7, 0..5), (16, 0..16), (9, 3..8), (8, 8..9), (3, 5..6), (20, 1..17)] {
            for order in [Order::Rows, Order::CoarseToFine] {
                let mut turns = std::vec![0; (width * rows.end) as usize];
                let mut cursor = Cursor::new(width, &rows, order);
                loop {
                    assert!(rows.contains(&cursor.y) && cursor.x < width, "{cursor:?}");
                    turns[(cursor.y * width + cursor.x) as usize] += 1;
                    let before = cursor;
                    match cursor.advance(width, &rows) {
                        Next::SameRow => assert!(cursor.y == before.y && cursor.cell == before.cell),
                        Next::OtherRow => assert!(cursor.y != before.y || cursor.cell < before.cell),
                        Next::End => break,
                    }
                }
                let outside = (width * rows.start) as usize;
                assert!(turns[..outside].iter().all(|&n| n == 0) && turns[outside..].iter().all(|&n| n == 1));
            }
        }
    }

    #[test]
    fn the_first_pass_is_every_eighth_pixel() {
        let mut cursor = Cursor::new(32, &(0..32), Order::CoarseToFine);
        for i in 0..16 {
            assert_eq!((cursor.x, cursor.y, cursor.cell), (i % 4 * 8, i / 4 * 8, 8));
            cursor.advance(32, &(0..32));
        }
        assert_eq!((cursor.x, cursor.y, cursor.cell), (4, 0, 4));
    }
}
