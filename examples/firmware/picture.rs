//! A file in PPM format that is written a row at a time.

use core::ffi::CStr;

use whit::render::{Encoding, Framebuffer, Pixel, Size};

use crate::board::{File, Outcome, rename};
use crate::checksum::Checksum;
use crate::choice::{SCENE, SIZE};

const WIDTH: usize = SIZE[0] as usize;
const NAME: &CStr = c"target/firmware.ppm";
/// What the file is called until it is whole.
const UNFINISHED: &CStr = c"target/firmware.ppm.part";

/// The file and a row for it.
pub struct Picture {
    file: File,
    row: [[u8; 3]; WIDTH],
    checksum: Checksum,
}

impl Picture {
    /// An empty picture.
    pub fn create() -> Result<Self, &'static str> {
        let mut file = File::create(UNFINISHED)?;
        file.write(&HEADER)?;
        Ok(Self { file, row: [[0; 3]; WIDTH], checksum: Checksum::EMPTY })
    }

    /// Ends the file; gives the checksum of the linear pixels.
    pub fn finish(&mut self) -> Result<u64, &'static str> {
        rename(UNFINISHED, NAME)?;
        Ok(self.checksum.value())
    }
}

impl Framebuffer for Picture {
    type Error = &'static str;

    fn size(&self) -> Size {
        Size::new(SIZE[0], SIZE[1])
    }

    fn put(&mut self, pixel: Pixel) -> Outcome {
        self.checksum.add(&pixel);
        if let Some(place) = self.row.get_mut(pixel.x as usize) {
            *place = Encoding::of(&SCENE).encode8(pixel.color);
        }
        Ok(())
    }

    fn end_row(&mut self, _: u32) -> Outcome {
        self.file.write(self.row.as_flattened())
    }
}

/// Format, width, height and largest value, between white space.
const HEADER: [u8; 21] = {
    let mut header = *b"P6 000000 000000 255\n";
    write_number(&mut header, 8, SIZE[0]);
    write_number(&mut header, 15, SIZE[1]);
    header
};

/// Writes the digits of a number, the last one at a given place.
const fn write_number(text: &mut [u8], last: usize, number: u32) {
    let (mut place, mut rest) = (last, number);
    while rest > 0 {
        text[place] = b'0' + (rest % 10) as u8;
        rest /= 10;
        place -= 1;
    }
}
