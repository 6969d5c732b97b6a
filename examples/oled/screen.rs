//! What is on the display: a picture and, below it, a line of text.

use core::fmt::{self, Debug, Write};

use embedded_graphics::geometry::{AnchorPoint, AnchorY};
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_5X8;
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Alignment, Baseline, Text, TextStyleBuilder};
use whit::render::{DrawTargetLines, Encoding, LineError, PlacementError, RenderError, Sampling, SettingsError};
use whit::{Frame, Settings, Stats};

use crate::choice::{self, DEPTH, NAME, SCENE};

const LINE_OF_TEXT: u32 = FONT_5X8.character_size.height;
/// The size of the picture: WHIT_SIZE, or all that the line of text leaves of 128×64 pixels.
const SIZE: [u32; 2] = if option_env!("WHIT_SIZE").is_some() { choice::SIZE } else { [128, 64 - LINE_OF_TEXT] };
const FONT: MonoTextStyle<'_, Gray4> = MonoTextStyle::new(&FONT_5X8, Gray4::WHITE);

/// Draws it all, row by row. A picture that does not fit changes nothing.
pub fn draw<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<(), Problem<D::Error>> {
    let whole = display.bounding_box();
    let above = whole.resized_height(whole.size.height.saturating_sub(LINE_OF_TEXT), AnchorY::Top);
    let rays = draw_picture(&mut display.cropped(&above))?;
    let below = whole.resized_height(LINE_OF_TEXT, AnchorY::Bottom);
    draw_text(&mut display.cropped(&below), rays).map_err(Problem::Text)
}

/// Gives the number of rays that it took.
fn draw_picture<D: DrawTarget<Color = Gray4>>(display: &mut D) -> Result<u64, Problem<D::Error>> {
    let mut row = [Gray4::BLACK; SIZE[0] as usize];
    let size = whit::render::Size::new(SIZE[0], SIZE[1]);
    let mut picture =
        DrawTargetLines::new(display, size, &mut row, Encoding::of(&SCENE)).map_err(Problem::Placement)?;
    let tracer = whit::tracer!(SCENE, DEPTH as usize);
    let settings = Settings::new(SIZE[0], SIZE[1]).with_depth(DEPTH).with_sampling(Sampling::Grid(2));
    let mut frame = Frame::observed(&tracer, settings, Stats::default()).map_err(Problem::Settings)?;
    frame.render(&mut picture).map_err(Problem::Rendering)?;
    let Stats { eye, reflected, transmitted, passed, shadow, .. } = frame.observer();
    Ok(eye + reflected + transmitted + passed + shadow)
}

fn draw_text<D: DrawTarget<Color = Gray4>>(display: &mut D, rays: u64) -> Result<(), D::Error> {
    let style = |alignment| TextStyleBuilder::new().alignment(alignment).baseline(Baseline::Top).build();
    let area = display.bounding_box();
    display.clear(Gray4::BLACK)?;
    Text::with_text_style(NAME, area.top_left, FONT, style(Alignment::Left)).draw(display)?;
    let mut text = heapless::String::<25>::new();
    let _ = write!(text, "{rays} rays"); // 20 digits at most.
    Text::with_text_style(&text, area.anchor_point(AnchorPoint::TopRight), FONT, style(Alignment::Right))
        .draw(display)?;
    Ok(())
}

/// Why there is no picture.
#[derive(Debug)]
pub enum Problem<E> {
    Placement(PlacementError),
    Settings(SettingsError),
    Rendering(RenderError<LineError<E>>),
    Text(E),
}

impl<E: Debug> fmt::Display for Problem<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Placement(error) => write!(f, "{error}"),
            Self::Settings(error) => write!(f, "{error}"),
            Self::Rendering(error) => write!(f, "{error:?}"),
            Self::Text(error) => write!(f, "text: {error:?}"),
        }
    }
}
