//! Pixels that lie one after the other in memory, `N` elements each.

use super::SizeError;
use crate::render::{Pixel, Size};

/// Rows from the top, each from the left, nothing between them.
#[derive(Debug)]
pub(super) struct Packed<'a, T, const N: usize> {
    size: Size,
    elements: &'a mut [T],
}

impl<'a, T, const N: usize> Packed<'a, T, N> {
    /// `elements` must be exactly `size.pixels() * N`; `unit` is what the error calls them.
    pub(super) fn new(size: Size, elements: &'a mut [T], unit: &'static str) -> Result<Self, SizeError> {
        SizeError::check(size.pixels().saturating_mul(N as u64), elements.len(), unit)?;
        Ok(Self { size, elements })
    }

    pub(super) fn size(&self) -> Size {
        self.size
    }

    /// Nothing happens when the pixel is outside of the picture.
    #[inline]
    pub(super) fn set(&mut self, pixel: &Pixel, value: [T; N]) {
        if pixel.x >= self.size.width || pixel.y >= self.size.height {
            return;
        }
        // Inside, every index is below the length of `elements`, so this does not overflow.
        let start = (pixel.y as usize * self.size.width as usize + pixel.x as usize) * N;
        if let Some(place) = self.elements.get_mut(start..).and_then(|rest| rest.first_chunk_mut()) {
            *place = value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn pixel(x: u32, y: u32) -> Pixel {
        Pixel { x, y, cell: 1, color: Rgb::BLACK }
    }

    #[test]
    fn rows_follow_each_other() {
        let mut bytes = [0u8; 12];
        let mut packed = Packed::<_, 2>::new(Size::new(3, 2), &mut bytes, "bytes").unwrap();
        packed.set(&pixel(2, 0), [1, 2]);
        packed.set(&pixel(0, 1), [3, 4]);
        packed.set(&pixel(2, 1), [5, 6]);
        assert_eq!(bytes, [0, 0, 0, 0, 1, 2, 3, 4, 0, 0, 5, 6]);
    }

    #[test]
    fn pixels_outside_change_nothing() {
        let mut bytes = [7u8; 12];
        let mut packed = Packed::<_, 2>::new(Size::new(3, 2), &mut bytes, "bytes").unwrap();
        for outside in [pixel(3, 0), pixel(0, 2), pixel(u32::MAX, 0), pixel(0, u32::MAX), pixel(u32::MAX, u32::MAX)] {
            packed.set(&outside, [0, 0]);
        }
        assert_eq!(bytes, [7; 12]);
    }

    #[test]
    fn length_must_be_exact() {
        let size = Size::new(3, 2);
        for found in [0, 11, 13] {
            let error = Packed::<_, 2>::new(size, &mut [0u8; 13][..found], "bytes").unwrap_err();
            assert_eq!(error, SizeError { expected: 12, found, unit: "bytes" });
        }
    }

    /// 3 · (2³² − 1)² is about 2⁶⁵·⁶: a product that wraps would ask for fewer bytes.
    #[test]
    fn length_does_not_overflow() {
        let error = Packed::<_, 3>::new(Size::new(u32::MAX, u32::MAX), &mut [0u8; 3], "bytes").unwrap_err();
        assert_eq!(error.expected, u64::MAX);
        // 2³² · 3 bytes: 0 when 32 bits are kept.
        let error = Packed::<_, 3>::new(Size::new(1 << 16, 1 << 16), &mut [0u8; 0], "bytes").unwrap_err();
        assert_eq!(error.expected, 3 << 32);
    }

    #[test]
    fn empty_pictures_need_no_memory() {
        for size in [Size::new(0, 0), Size::new(5, 0), Size::new(0, 5)] {
            let mut packed = Packed::<u8, 3>::new(size, &mut [], "bytes").unwrap();
            packed.set(&pixel(0, 0), [1, 2, 3]);
        }
    }
}
