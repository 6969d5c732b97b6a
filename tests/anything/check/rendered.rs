//! What came of a frame.

use whit::Stats;
use whit::render::Pixel;

use super::canvas::Canvas;
use super::watch::Watch;
use super::{Fault, require};

/// What came of a frame.
pub struct Rendered {
    pub canvas: Canvas,
    pub stats: Stats,
    pub watch: Watch,
    /// Column, row and the bits of the weight that was cut, per pixel.
    pub dropped: Vec<(u32, u32, [u32; 3])>,
    pub is_done: bool,
}

impl Rendered {
    /// The same bits; if one of them is not done, as far as it is.
    pub fn compare(&self, other: &Self) -> Result<(), Fault> {
        let different = self.canvas.pixels.iter().zip(&other.canvas.pixels).find(|(a, b)| bits(a) != bits(b));
        require(different.is_none(), || format!("other pixels: {different:?}"))?;
        let same = self.dropped.iter().zip(&other.dropped).all(|(a, b)| a == b);
        require(same, || "other weights are dropped".into())?;
        let same = !(self.is_done && other.is_done) || self.stats == other.stats;
        require(same, || format!("{:?} and not {:?}", self.stats, other.stats))
    }
}

fn bits(pixel: &Pixel) -> (u32, u32, u32, [u32; 3]) {
    (pixel.x, pixel.y, pixel.cell, [pixel.color.r, pixel.color.g, pixel.color.b].map(f32::to_bits))
}
