//! A framebuffer that remembers what it is given.

use std::collections::HashSet;

use whit::Framebuffer;
use whit::render::{Pixel, Size};

pub struct Canvas {
    size: Size,
    pub pixels: Vec<Pixel>,
    /// How many rows, or rows of a pass, were said to be complete.
    pub rows_ended: usize,
}

impl Canvas {
    pub fn new(size: Size) -> Self {
        Self { size, pixels: Vec::new(), rows_ended: 0 }
    }

    /// Whether no pixel came twice.
    pub fn is_each_once(&self) -> bool {
        let mut seen = HashSet::new();
        self.pixels.iter().all(|pixel| seen.insert((pixel.x, pixel.y)))
    }
}

impl Framebuffer for Canvas {
    type Error = core::convert::Infallible;

    fn size(&self) -> Size {
        self.size
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Self::Error> {
        self.pixels.push(pixel);
        Ok(())
    }

    fn end_row(&mut self, _y: u32) -> Result<(), Self::Error> {
        self.rows_ended += 1;
        Ok(())
    }
}
