//! Renders a scene on a board, a row at a time, into a file on the host.
//!
//!     cargo run --release --example firmware --target thumbv7em-none-eabihf
//!     WHIT_SCENE=glass WHIT_SIZE=64x48 WHIT_DEPTH=8 cargo run --release --example firmware --target thumbv6m-none-eabi
//!
//! WHIT_NUMBER=f64 computes in another number type; the scene is then converted to it at the start, and has to fit into memory.
//! The picture is `target/firmware.ppm`. Beside it the program says the checksum of its linear pixels, how many instructions
//! the processor took for it and how much stack. Without `--target` it runs on the machine at hand.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![allow(unsafe_code, clippy::indexing_slicing, clippy::panic)] // In constants, which the compiler evaluates.
#![cfg_attr(target_arch = "wasm32", allow(unused))]

#[path = "../board/mod.rs"]
mod board;
#[path = "../board/checksum.rs"]
mod checksum;
mod choice;
mod number;
mod picture;

use core::mem::MaybeUninit;

use board::{Clock, Outcome, paint_stack, print, print_hexadecimal, print_number};
use choice::{DEPTH, NAME, SCENE, SIZE};
use number::{Chosen, Drawn, Memory};
use picture::{Picture, Row, RowIsFull};
use whit::render::RenderError;
use whit::{Frame, Settings, Tone};

board::start!(render);

/// A row of the picture, and its file.
type PixelRow = Row<{ SIZE[0] as usize }, { SIZE[1] }, { matches!(SCENE.tone, Tone::Linear) }>;
type PictureFile = Picture<{ SIZE[0] as usize }, { SIZE[1] }, { matches!(SCENE.tone, Tone::Linear) }>;

/// Variables, so that the linker says how much memory is needed.
static mut MEMORY: MaybeUninit<Memory> = MaybeUninit::uninit();
static mut FRAME: MaybeUninit<Drawn> = MaybeUninit::uninit();
static mut ROW: PixelRow = PixelRow::new();

fn render() -> Outcome {
    print("scene ");
    print(NAME);
    print("\n");
    let (memory, frame, row) = (&raw mut MEMORY, &raw mut FRAME, &raw mut ROW);
    // SAFETY: this function is called once, and nothing else names the variables.
    let (memory, frame, row) = unsafe { (&mut *memory, &mut *frame, &mut *row) };
    let tracer = Chosen::tracer(memory)?;
    let settings = Settings::new(SIZE[0], SIZE[1]).with_depth(DEPTH);
    let frame =
        frame.write(Frame::new(&tracer, settings).map_err(|_| "WHIT_SIZE: expected 1 to 1048576 pixels a side")?);
    let mut picture = PictureFile::create()?;

    let clock = Clock::start();
    let stack = paint_stack();
    while draw_row(frame, row)? {
        picture.write(row)?;
    }
    let stack = stack.map(|stack| stack.used()).transpose()?;
    let instructions = clock.map(|clock| clock.instructions());

    picture.finish()?;
    print("checksum ");
    print_hexadecimal(row.checksum());
    report("\ninstructions ", instructions);
    report("\nstack ", stack.map(u64::from));
    print("\n");
    Ok(())
}

/// Whether there is another row, which is then in `row`.
///
/// A function of its own, so that all the stack that rendering takes lies below its caller's, and of a name that can be found
/// in the program.
#[unsafe(no_mangle)]
#[inline(never)]
fn draw_row(frame: &mut Drawn, row: &mut PixelRow) -> Result<bool, &'static str> {
    match frame.render(row) {
        Ok(()) => Ok(false),
        Err(RenderError::Framebuffer(RowIsFull)) => Ok(true),
        Err(RenderError::Size { .. }) => Err("the row and the frame differ in size"),
    }
}

fn report(name: &str, number: Option<u64>) {
    if let Some(number) = number {
        print(name);
        print_number(number);
    }
}
