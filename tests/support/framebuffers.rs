//! Framebuffers that watch the renderer, or get in its way.
#![allow(dead_code, unreachable_pub, clippy::expect_used)] // Each test that includes this file uses a part of it.

use whit::Rgb;
use whit::render::{Framebuffer, Pixel, Size};

/// Counts how often each pixel is put and each row is ended, successfully.
#[derive(Clone, Debug)]
pub struct Counting<F> {
    pub inner: F,
    /// Row by row, from the upper left.
    pub pixels: Vec<u32>,
    pub rows: Vec<u32>,
}

impl<F: Framebuffer> Counting<F> {
    pub fn new(inner: F) -> Self {
        let size = inner.size();
        Self { inner, pixels: vec![0; size.pixels() as usize], rows: vec![0; size.height as usize] }
    }

    /// How often the pixel was put.
    pub fn pixel(&self, x: u32, y: u32) -> u32 {
        self.pixels[(y * self.inner.size().width + x) as usize]
    }
}

impl<F: Framebuffer> Framebuffer for Counting<F> {
    type Error = F::Error;

    fn size(&self) -> Size {
        self.inner.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), F::Error> {
        self.inner.put(pixel)?;
        let Size { width, height } = self.inner.size();
        assert!(pixel.x < width && pixel.y < height, "{pixel:?} is outside of the picture");
        self.pixels[(pixel.y * width + pixel.x) as usize] += 1;
        Ok(())
    }

    fn end_row(&mut self, y: u32) -> Result<(), F::Error> {
        self.inner.end_row(y)?;
        self.rows[y as usize] += 1;
        Ok(())
    }
}

/// Fails once, on a certain call; the inner framebuffer does not see that call.
#[derive(Clone, Debug)]
pub struct Failing<F> {
    pub inner: F,
    calls: u64,
    fail_on: u64,
}

/// Why [`Failing`] fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure<E> {
    /// It was asked to.
    Planned,
    /// The inner framebuffer failed.
    Inner(E),
}

impl<F: Framebuffer> Failing<F> {
    /// `put` and `end_row` are counted together; 0 is the first call.
    pub fn new(inner: F, fail_on: u64) -> Self {
        Self { inner, calls: 0, fail_on }
    }

    /// How many calls there were, the failed ones included.
    pub fn calls(&self) -> u64 {
        self.calls
    }

    fn count(&mut self) -> Result<(), Failure<F::Error>> {
        let call = self.calls;
        self.calls += 1;
        if call == self.fail_on { Err(Failure::Planned) } else { Ok(()) }
    }
}

impl<F: Framebuffer> Framebuffer for Failing<F> {
    type Error = Failure<F::Error>;

    fn size(&self) -> Size {
        self.inner.size()
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), Self::Error> {
        self.count()?;
        self.inner.put(pixel).map_err(Failure::Inner)
    }

    fn end_row(&mut self, y: u32) -> Result<(), Self::Error> {
        self.count()?;
        self.inner.end_row(y).map_err(Failure::Inner)
    }
}

/// A renderer in miniature: puts `color(x, y)` row by row and, like the real one, makes a failed call again.
///
/// Gives how often that was.
pub fn draw_rows<F: Framebuffer>(framebuffer: &mut F, color: impl Fn(u32, u32) -> Rgb<f32>) -> u32 {
    let mut failures = 0;
    let Size { width, height } = framebuffer.size();
    for y in 0..height {
        for x in 0..width {
            let pixel = Pixel { x, y, cell: 1, color: color(x, y) };
            failures += repeated(|| framebuffer.put(pixel));
        }
        failures += repeated(|| framebuffer.end_row(y));
    }
    failures
}

/// The same from coarse to fine: cells of 8, 4, 2 and 1, each pixel with the largest cell whose grid it is on.
pub fn draw_coarse_to_fine<F: Framebuffer>(framebuffer: &mut F, color: impl Fn(u32, u32) -> Rgb<f32>) -> u32 {
    let mut failures = 0;
    let Size { width, height } = framebuffer.size();
    for cell in [8, 4, 2, 1] {
        for y in (0..height).step_by(cell as usize) {
            let new = |&x: &u32| cell == 8 || x % (2 * cell) != 0 || y % (2 * cell) != 0;
            for x in (0..width).step_by(cell as usize).filter(new) {
                let pixel = Pixel { x, y, cell, color: color(x, y) };
                failures += repeated(|| framebuffer.put(pixel));
            }
            failures += repeated(|| framebuffer.end_row(y));
        }
    }
    failures
}

fn repeated<E>(mut call: impl FnMut() -> Result<(), E>) -> u32 {
    (0..100).find(|_| call().is_ok()).expect("the framebuffer never recovers")
}
