//! A driver of displays with the controller SSD0323 of Solomon Systech: 128×64 pixels of 16 greys, over a serial bus.
//!
//! Commands are called what the data sheet calls them.

use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;

pub const WIDTH: u32 = 128;
pub const HEIGHT: u32 = 64;
/// A byte holds two pixels, the left one in its upper half.
pub const BYTES: usize = BYTES_PER_ROW * HEIGHT as usize;
const BYTES_PER_ROW: usize = WIDTH as usize / 2;

const SET_COLUMN_ADDRESS: u8 = 0x15;
const SET_ROW_ADDRESS: u8 = 0x75;
const SET_REMAP: u8 = 0xA0;
const SET_DISPLAY_START_LINE: u8 = 0xA1;
const SET_DISPLAY_OFFSET: u8 = 0xA2;
const NORMAL_DISPLAY: u8 = 0xA4;
const DISPLAY_ON: u8 = 0xAF;

/// As the panel is wired: rows from the last to the first and every other one from the other side, the upper half of a
/// byte on the left; addresses go on along the row.
const REMAP: u8 = 0x52;

/// The display, on a device of a serial bus and a pin that tells data from commands.
///
/// Nothing can be read from it over that bus, and a byte is two pixels. So what it shows is kept here as well.
pub struct Ssd0323<'a, S, P> {
    device: S,
    data_pin: P,
    shown: &'a mut [u8; BYTES],
}

/// What the bus or the pin says went wrong.
#[derive(Debug)]
pub enum Error<S, P> {
    Bus(#[allow(dead_code)] S),
    Pin(#[allow(dead_code)] P),
}

type Done<S, P> = Result<(), Error<S, P>>;

impl<'a, S: SpiDevice, P: OutputPin> Ssd0323<'a, S, P> {
    /// Turns the display on, all black.
    pub fn start(device: S, data_pin: P, memory: &'a mut [u8; BYTES]) -> Result<Self, Error<S::Error, P::Error>> {
        let mut display = Self { device, data_pin, shown: memory };
        display.command(&[SET_REMAP, REMAP])?;
        display.command(&[SET_DISPLAY_START_LINE, 0])?;
        display.command(&[SET_DISPLAY_OFFSET, 0])?;
        display.command(&[NORMAL_DISPLAY])?;
        display.clear(Gray4::BLACK)?;
        display.command(&[DISPLAY_ON])?;
        Ok(display)
    }

    fn command(&mut self, bytes: &[u8]) -> Done<S::Error, P::Error> {
        self.data_pin.set_low().map_err(Error::Pin)?;
        self.device.write(bytes).map_err(Error::Bus)
    }

    /// Sends what is in memory for an area, which must not be empty: whole bytes, in one window.
    fn send(&mut self, area: &Rectangle) -> Done<S::Error, P::Error> {
        let (columns, rows) = (area.columns(), area.rows());
        let (first, last) = (columns.start as usize / 2, (columns.end - 1) as usize / 2);
        self.command(&[SET_COLUMN_ADDRESS, first as u8, last as u8])?;
        self.command(&[SET_ROW_ADDRESS, rows.start as u8, (rows.end - 1) as u8])?;
        self.data_pin.set_high().map_err(Error::Pin)?;
        let all_rows = self.shown.chunks_exact(BYTES_PER_ROW);
        for row in all_rows.skip(rows.start as usize).take(rows.len()) {
            self.device.write(row.get(first..=last).unwrap_or_default()).map_err(Error::Bus)?;
        }
        Ok(())
    }

    /// Changes a pixel in memory; `false` when it is outside.
    fn set(&mut self, Point { x, y }: Point, color: Gray4) -> bool {
        if !self.bounding_box().contains(Point::new(x, y)) {
            return false;
        }
        let Some(byte) = self.shown.get_mut(y as usize * BYTES_PER_ROW + x as usize / 2) else { return false };
        *byte = if x % 2 == 0 { *byte & 0x0F | color.luma() << 4 } else { *byte & 0xF0 | color.luma() };
        true
    }
}

impl<S, P> OriginDimensions for Ssd0323<'_, S, P> {
    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT)
    }
}

impl<S: SpiDevice, P: OutputPin> DrawTarget for Ssd0323<'_, S, P> {
    type Color = Gray4;
    type Error = Error<S::Error, P::Error>;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(place, color) in pixels {
            if self.set(place, color) {
                self.send(&Rectangle::new(place, Size::new_equal(1)))?;
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Gray4>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Self::Error> {
        for (place, color) in area.points().zip(colors) {
            self.set(place, color);
        }
        let inside = area.intersection(&self.bounding_box());
        if inside.is_zero_sized() { Ok(()) } else { self.send(&inside) }
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray4) -> Result<(), Self::Error> {
        self.fill_contiguous(area, core::iter::repeat(color))
    }
}
