//! The window and what is rendered into it.

use std::convert::Infallible;
use std::error::Error;
use std::time::{Duration, Instant};

use embedded_graphics::geometry::AnchorY;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics_simulator::{SimulatorDisplay, Window};
#[cfg(feature = "window")]
use embedded_graphics_simulator::{SimulatorEvent, sdl2::Keycode};
use whit::render::{DrawTargetCells, Encoding, Order, Progress};
use whit::{Effects, Frame, Settings, Tracer};

use crate::panel::Panel;
use crate::view::View;

const DEPTH: u8 = 8;
/// One tracer for all scenes. Dispersion takes two branches more than bounces.
type AnyTracer<'a> = Tracer<'a, f32, { Effects::ALL.bits() }, { DEPTH as usize + 2 }, 8>;

/// How long is rendered until the window is looked after.
const SLICE: Duration = Duration::from_millis(25);
const RAYS: u32 = 500;

/// Shows a view and those that the user asks for next, until the window is closed.
pub fn run<P: Panel>(view: View) -> Result<(), Box<dyn Error>> {
    let wants_file = std::env::vars_os().any(|(name, _)| name.to_string_lossy().starts_with("EG_SIMULATOR_"));
    if !wants_file && !cfg!(feature = "window") {
        return Err("there is no window in this program: expected the name of a file in EG_SIMULATOR_DUMP".into());
    }
    let mut display = SimulatorDisplay::<P>::new(P::SIZE);
    let mut window = Window::new("whit", &P::settings());
    if !wants_file {
        println!("{}", crate::KEYS);
    }
    // The window writes the file when it is first updated, and ends the program.
    let slice = if wants_file { Duration::MAX } else { SLICE };
    let mut view = Some(view);
    while let Some(shown) = view {
        view = show(shown, &mut display, &mut window, slice)?;
    }
    Ok(())
}

/// Shows a view until the user asks for another; `None` is the end.
fn show<P: Panel>(
    view: View,
    display: &mut SimulatorDisplay<P>,
    window: &mut Window,
    slice: Duration,
) -> Result<Option<View>, Box<dyn Error>> {
    let line_of_text = P::FONT.character_size.height;
    let below = display.bounding_box().resized_height(line_of_text, AnchorY::Bottom);
    write(&mut display.cropped(&below), view.name())?;

    let scene = view.scene();
    let tracer = AnyTracer::try_new(&scene)?;
    let Size { width, height } = P::SIZE;
    let settings = Settings::new(width, height - line_of_text).with_depth(DEPTH);
    let size = settings.size;
    let settings = Settings { order: Order::CoarseToFine, ..settings };
    let mut frame = Frame::new(&tracer, settings)?;
    let mut progress = Progress::More;
    loop {
        let start = Instant::now();
        while progress == Progress::More && start.elapsed() < slice {
            let mut target = DrawTargetCells::new(display, size, P::colors(Encoding::of(&scene)))?;
            progress = frame.step(RAYS, &mut target)?;
        }
        window.update(display);
        match asked(view, window) {
            Some(same) if same == view => {}
            other => return Ok(other),
        }
    }
}

fn write<P: Panel>(
    display: &mut impl DrawTarget<Color = P, Error = Infallible>,
    text: &str,
) -> Result<(), Box<dyn Error>> {
    let style = MonoTextStyle::new(&P::FONT, P::from(BinaryColor::On));
    display.clear(P::from(BinaryColor::Off))?;
    Text::with_baseline(text, Point::new(2, 0), style, Baseline::Top).draw(display)?;
    Ok(())
}

/// What the user wants to see, by all keys since the last time.
#[cfg(feature = "window")]
fn asked(view: View, window: &Window) -> Option<View> {
    let mut view = view;
    for event in window.events() {
        match event {
            SimulatorEvent::Quit => return None,
            SimulatorEvent::KeyDown { keycode, .. } => view = after(view, keycode),
            _ => {}
        }
    }
    Some(view)
}

#[cfg(not(feature = "window"))]
fn asked(_: View, _: &Window) -> Option<View> {
    None
}

#[cfg(feature = "window")]
fn after(view: View, key: Keycode) -> View {
    const ANGLE: f32 = 0.1;
    const FACTOR: f32 = 1.1;
    match key {
        Keycode::Left => view.turned(-ANGLE),
        Keycode::Right => view.turned(ANGLE),
        Keycode::Up => view.raised(ANGLE),
        Keycode::Down => view.raised(-ANGLE),
        Keycode::Plus | Keycode::Equals | Keycode::KpPlus => view.scaled(1.0 / FACTOR),
        Keycode::Minus | Keycode::KpMinus => view.scaled(FACTOR),
        Keycode::N => view.next(),
        Keycode::P => view.previous(),
        Keycode::R => view.start(),
        _ => view,
    }
}
