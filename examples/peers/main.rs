//! Renders a scene that other ray tracers for microcontrollers are measured by, and counts the instructions.
//!
//!     WHIT_SCENE=raystones cargo run --release --example peers --target thumbv7em-none-eabihf
//!     WHIT_SCENE=raystones cargo run --release --example peers
//!
//! WHIT_SCENE is `card`, `raystones` or `ftb`; WHIT_CUTOFF is `0` or `1/255`. On a board it says how many instructions the
//! processor took, on the machine at hand how many rays there were; with WHIT_COUNT=1 the board counts rays too, and the
//! instructions for that are counted with the others. Both say the checksum of the picture's bytes.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![allow(unsafe_code, clippy::indexing_slicing, clippy::panic)] // In constants, which the compiler evaluates.

#[path = "../board/mod.rs"]
mod board;
mod checksum;
mod choice;
mod picture;
mod rays;
mod scenes;

use core::mem::MaybeUninit;

use board::{Clock, Outcome, paint_stack, print, print_hexadecimal, print_number};
use checksum::{START, checksum};
use choice::{CUTOFF, IS_COUNTED, PEER, SCENE};
use picture::{Row, RowIsFull};
use rays::Rays;
use whit::render::RenderError;
use whit::{Frame, Tracer};

board::start!(render);

const WIDTH: usize = PEER.size[0] as usize;
const EFFECTS: u64 = SCENE.effects().bits();
const STACK: usize = SCENE.stack(PEER.depth as usize);
const MEDIA: usize = SCENE.media();

type Drawn = Frame<'static, f32, EFFECTS, STACK, Rays<IS_COUNTED>, MEDIA>;

/// Variables, so that the linker says how much memory is needed.
static TRACER: Tracer<'static, f32, EFFECTS, STACK, MEDIA> = whit::tracer!(SCENE, PEER.depth as usize);
static mut FRAME: MaybeUninit<Drawn> = MaybeUninit::uninit();
static mut ROW: Row<WIDTH, { PEER.size[1] }> = Row::EMPTY;

fn render() -> Outcome {
    let (frame, row) = (&raw mut FRAME, &raw mut ROW);
    // SAFETY: this function is called once, and nothing else names the variables.
    let (frame, row) = unsafe { (&mut *frame, &mut *row) };
    let settings = PEER.settings(CUTOFF);
    let frame = frame.write(Frame::observed(&TRACER, settings, Rays::NONE).map_err(|_| "settings out of range")?);

    let (mut instructions, mut sum) = (0, START);
    let clock = Clock::start();
    let now = || clock.as_ref().map_or(0, Clock::instructions);
    let stack = paint_stack();
    loop {
        let start = now();
        let is_row = draw_row(frame, row)?;
        instructions += now() - start;
        if !is_row {
            break;
        }
        sum = checksum(sum, row.bytes());
    }
    let stack = stack.map(|stack| stack.used()).transpose()?;

    print("scene ");
    print(PEER.name);
    print("\nchecksum ");
    print_hexadecimal(sum);
    let pixels = u64::from(PEER.size[0]) * u64::from(PEER.size[1]);
    report("pixels", pixels);
    report("rays", frame.observer().count().into());
    report("instructions", instructions);
    report("a pixel", instructions / pixels);
    report("a ray", instructions.checked_div(frame.observer().count().into()).unwrap_or(0));
    report("stack", stack.unwrap_or(0).into());
    print("\n");
    Ok(())
}

/// Whether there is another row, which is then in `row`. A function of its own, so that it can be found in the program.
#[unsafe(no_mangle)]
#[inline(never)]
fn draw_row(frame: &mut Drawn, row: &mut Row<WIDTH, { PEER.size[1] }>) -> Result<bool, &'static str> {
    match frame.render(row) {
        Ok(()) => Ok(false),
        Err(RenderError::Framebuffer(RowIsFull)) => Ok(true),
        Err(RenderError::Size { .. }) => Err("the row and the frame differ in size"),
    }
}

/// Says a number that is known here.
fn report(name: &str, number: u64) {
    if number > 0 {
        print("\n");
        print(name);
        print(": ");
        print_number(number);
    }
}
