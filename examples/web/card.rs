//! The card alone: as small a module as renders a scene. `card.html` shows it.
//!
//! It has no imports. `step` goes on with the picture at `pixels`.
#![cfg_attr(target_arch = "wasm32", no_std)]
#![allow(unsafe_code)] // A name that is exported could stand in for another's. And static memory: see `FRAME`.

mod alone;
mod trap;

use core::convert::Infallible;

use alone::Alone;
use whit::render::{Encoding, Framebuffer, Order, Pixel, Progress, Sampling, Size};
use whit::{Frame, Settings, Tracer, scenes::CARD};

const EFFECTS: u64 = CARD.effects().bits();
const STACK: usize = CARD.stack(15);

static TRACER: Tracer<'static, f32, EFFECTS, STACK> = whit::tracer!(CARD, 15);

const SIDE: usize = 256;

// A page calls one function at a time, from one thread, so these have one user.
static FRAME: Alone<Option<Frame<'static, f32, EFFECTS, STACK>>> = Alone::new(None);
static PIXELS: Alone<[[u8; 4]; SIDE * SIDE]> = Alone::new([[0; 4]; SIDE * SIDE]);

/// Where the picture is: 256×256 pixels of red, green, blue and alpha.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn pixels() -> *const u8 {
    unsafe { PIXELS.get() }.as_ptr().cast()
}

/// Begins the picture anew with so many samples a pixel, at least one.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn start(samples: u32) {
    let sampling = Sampling::Sequence(samples);
    let settings = Settings { order: Order::CoarseToFine, sampling, ..Settings::new(SIDE as u32, SIDE as u32) };
    *unsafe { FRAME.get() } = Frame::new(&TRACER, settings.with_depth(15)).ok();
}

/// Traces about so many rays more; whether there is more to do.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn step(rays: u32) -> bool {
    let frame = unsafe { FRAME.get() }.as_mut();
    matches!(frame.map(|frame| frame.step(rays, &mut Screen)), Some(Ok(Progress::More)))
}

struct Screen;

impl Framebuffer for Screen {
    type Error = Infallible;

    fn size(&self) -> Size {
        Size::new(SIDE as u32, SIDE as u32)
    }

    /// Fills the whole square, so that a coarse picture is seen at once. The side is a multiple of every square's.
    fn put(&mut self, pixel: Pixel) -> Result<(), Infallible> {
        let [r, g, b] = Encoding::Display.encode8(pixel.color);
        let pixels = unsafe { PIXELS.get() };
        for row in pixels.chunks_exact_mut(SIDE).skip(pixel.y as usize).take(pixel.cell as usize) {
            for place in row.iter_mut().skip(pixel.x as usize).take(pixel.cell as usize) {
                *place = [r, g, b, 255];
            }
        }
        Ok(())
    }
}
