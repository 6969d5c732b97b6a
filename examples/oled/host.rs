//! The same drawing in memory, as QEMU would show it.

use std::convert::Infallible;

use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::raw::{BigEndian, RawU4};
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics::prelude::*;
use image::{GrayImage, Luma};

use crate::screen::{self, Problem};

const WIDTH: usize = 128;
const HEIGHT: usize = 64;
/// QEMU shows each pixel as a square with this many pixels a side.
const MAGNIFICATION: u32 = 4;
/// From 15 to 255.
const LEVEL: u8 = 17;

/// The picture of the display.
pub fn picture() -> Result<GrayImage, Problem<Infallible>> {
    let mut display =
        Framebuffer::<Gray4, RawU4, BigEndian, WIDTH, HEIGHT, { buffer_size::<Gray4>(WIDTH, HEIGHT) }>::new();
    screen::draw(&mut display)?;
    let grey = |x, y| {
        let place = Point::new((x / MAGNIFICATION) as i32, (y / MAGNIFICATION) as i32);
        Luma([display.pixel(place).map_or(0, |color| color.luma() * LEVEL)])
    };
    Ok(GrayImage::from_fn(WIDTH as u32 * MAGNIFICATION, HEIGHT as u32 * MAGNIFICATION, grey))
}
