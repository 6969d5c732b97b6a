//! The displays.

use embedded_graphics::mono_font::MonoFont;
use embedded_graphics::mono_font::ascii::{FONT_5X8, FONT_6X12};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{BinaryColorTheme, OutputSettings, OutputSettingsBuilder};
use whit::render::{DisplayColor, Dithered, Encoding};

/// A display with pixels of this colour.
pub trait Panel: PixelColor + From<BinaryColor> + From<Rgb888> + Into<Rgb888> {
    type Colors: DisplayColor<Self>;

    const SIZE: Size;
    /// Of the line of text below the picture.
    const FONT: MonoFont<'static>;

    /// How pixels become its colours.
    fn colors(encoding: Encoding) -> Self::Colors;

    /// What it looks like on the screen.
    fn settings() -> OutputSettings;
}

impl Panel for Rgb565 {
    type Colors = Dithered;

    const SIZE: Size = Size::new(320, 240);
    const FONT: MonoFont<'static> = FONT_6X12;

    fn colors(encoding: Encoding) -> Dithered {
        Dithered(encoding)
    }

    fn settings() -> OutputSettings {
        OutputSettingsBuilder::new().scale(2).build()
    }
}

impl Panel for Gray4 {
    type Colors = Encoding;

    const SIZE: Size = Size::new(128, 64);
    const FONT: MonoFont<'static> = FONT_5X8;

    fn colors(encoding: Encoding) -> Encoding {
        encoding
    }

    fn settings() -> OutputSettings {
        OutputSettingsBuilder::new().scale(5).build()
    }
}

impl Panel for BinaryColor {
    type Colors = Encoding;

    const SIZE: Size = Size::new(128, 64);
    const FONT: MonoFont<'static> = FONT_5X8;

    fn colors(encoding: Encoding) -> Encoding {
        encoding
    }

    fn settings() -> OutputSettings {
        OutputSettingsBuilder::new().theme(BinaryColorTheme::OledBlue).scale(4).build()
    }
}
