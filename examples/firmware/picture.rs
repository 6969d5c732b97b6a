//! A file in PPM format that is written a row at a time.

use core::ffi::CStr;

use whit::render::{Encoding, Framebuffer, Pixel, Size};

use crate::board::{File, Outcome, rename};
use crate::checksum::Checksum;

const NAME: &CStr = c"target/firmware.ppm";
/// What the file is called until it is whole.
const UNFINISHED: &CStr = c"target/firmware.ppm.part";

/// A row of the picture. When it is full, rendering stops with an error, and goes on when the row has been written: so
/// nothing is written from within rendering, on top of its stack. `IS_LINEAR` says what the pixels hold (`Tone`), so that
/// the other encoding is not in the program.
pub struct Row<const WIDTH: usize, const HEIGHT: u32, const IS_LINEAR: bool> {
    pixels: [[u8; 3]; WIDTH],
    is_full: bool,
    checksum: Checksum,
}

/// The row is to be written.
pub struct RowIsFull;

impl<const WIDTH: usize, const HEIGHT: u32, const IS_LINEAR: bool> Row<WIDTH, HEIGHT, IS_LINEAR> {
    const ENCODING: Encoding = if IS_LINEAR { Encoding::Srgb } else { Encoding::Display };

    /// The first row, empty.
    pub const fn new() -> Self {
        Self { pixels: [[0; 3]; WIDTH], is_full: false, checksum: Checksum::EMPTY }
    }

    /// Of the linear pixels so far.
    pub fn checksum(&self) -> u64 {
        self.checksum.value()
    }
}

impl<const WIDTH: usize, const HEIGHT: u32, const IS_LINEAR: bool> Framebuffer for Row<WIDTH, HEIGHT, IS_LINEAR> {
    type Error = RowIsFull;

    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT)
    }

    fn put(&mut self, pixel: Pixel) -> Result<(), RowIsFull> {
        self.checksum.add(&pixel);
        if let Some(place) = self.pixels.get_mut(pixel.x as usize) {
            *place = Self::ENCODING.encode8(pixel.color);
        }
        Ok(())
    }

    /// The second call for a row, when rendering goes on, says that it has been written.
    fn end_row(&mut self, _: u32) -> Result<(), RowIsFull> {
        self.is_full = !self.is_full;
        if self.is_full { Err(RowIsFull) } else { Ok(()) }
    }
}

/// The picture's file.
pub struct Picture<const WIDTH: usize, const HEIGHT: u32, const IS_LINEAR: bool>(File);

impl<const WIDTH: usize, const HEIGHT: u32, const IS_LINEAR: bool> Picture<WIDTH, HEIGHT, IS_LINEAR> {
    const HEADER: [u8; 21] = header(WIDTH as u32, HEIGHT);

    /// A picture without rows.
    pub fn create() -> Result<Self, &'static str> {
        let mut file = File::create(UNFINISHED)?;
        file.write(&Self::HEADER)?;
        Ok(Self(file))
    }

    /// Adds a row.
    pub fn write(&mut self, row: &Row<WIDTH, HEIGHT, IS_LINEAR>) -> Outcome {
        self.0.write(row.pixels.as_flattened())
    }

    /// Gives the file its name, in place of an older picture.
    pub fn finish(self) -> Outcome {
        drop(self);
        rename(UNFINISHED, NAME)
    }
}

/// Format, width, height and largest value, between white space.
const fn header(width: u32, height: u32) -> [u8; 21] {
    let mut header = *b"P6 000000 000000 255\n";
    write_number(&mut header, 8, width);
    write_number(&mut header, 15, height);
    header
}

/// Writes the digits of a number, the last one at a given place.
const fn write_number(text: &mut [u8], last: usize, number: u32) {
    let (mut place, mut rest) = (last, number);
    while rest > 0 {
        text[place] = b'0' + (rest % 10) as u8;
        rest /= 10;
        place -= 1;
    }
}
