//! Small pictures, side by side.

use std::path::Path;

use image::{Rgb as Bytes, RgbImage};
use rayon::iter::ParallelIterator;
use whit::Rgb;
use whit::render::Encoding;

/// Pixels of a picture, in steps.
pub const WIDTH: u32 = 240;
pub const HEIGHT: u32 = 180;
const GAP: u32 = 8;

/// A picture of [`WIDTH`] × [`HEIGHT`] pixels: the colour of each, by its middle in pixels.
pub fn picture(color: impl Fn(f32, f32) -> Rgb<f32> + Sync) -> RgbImage {
    let mut picture = RgbImage::new(WIDTH, HEIGHT);
    picture.par_enumerate_pixels_mut().for_each(|(x, y, pixel)| {
        *pixel = Bytes(Encoding::Srgb.encode8(color(x as f32 + 0.5, y as f32 + 0.5)));
    });
    picture
}

/// How many pixels differ.
pub fn differing(a: &RgbImage, b: &RgbImage) -> usize {
    a.pixels().zip(b.pixels()).filter(|(a, b)| a != b).count()
}

/// Writes pictures from left to right into one file.
pub fn save(path: &Path, pictures: &[&RgbImage]) -> Result<(), String> {
    let count = pictures.len() as u32;
    let mut row = RgbImage::from_pixel((WIDTH + GAP) * count - GAP, HEIGHT, Bytes([255; 3]));
    for (i, picture) in (0..count).zip(pictures) {
        image::imageops::replace(&mut row, *picture, i64::from((WIDTH + GAP) * i), 0);
    }
    row.save(path).map_err(|error| format!("{}: {error}", path.display()))
}
