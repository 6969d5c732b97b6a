//! Renders a scene that a board reads from a file, in 16 KiB of RAM. What is wrong in the file, or does not fit, is an error
//! that says where.
//!
//!     cp examples/scene_file/scene.nff target/
//!     cargo run --release --example scene_file --target thumbv7em-none-eabihf
//!
//! The picture is `target/firmware.ppm`; the format of the file is Neutral File Format (`whit::scene::nff`).
#![cfg_attr(target_os = "none", no_std, no_main)]
#![allow(unsafe_code, clippy::indexing_slicing)] // Variables; constants, which the compiler evaluates.

#[path = "../board/mod.rs"]
mod board;
#[path = "../board/checksum.rs"]
mod checksum;
#[path = "../firmware/picture.rs"]
mod picture;

use core::fmt::{self, Write};
use core::mem::MaybeUninit;

use board::{Outcome, paint_stack, print, print_hexadecimal, print_number, write_error};
use picture::RowIsFull;
use whit::scene::nff;
use whit::{Background, Camera, Frame, Rgb, Scene, SceneBuf, Settings, Tracer, Vec3};

const WIDTH: usize = 96;
const HEIGHT: u32 = 72;
const DEPTH: usize = 5;

/// Room for a scene.
type Stored = SceneBuf<f32, 8, 2>;
type FileTracer<'a> = Tracer<'a, f32, { nff::EFFECTS.bits() }, DEPTH>;
type PixelRow = picture::Row<WIDTH, HEIGHT, true>;
type PictureFile = picture::Picture<WIDTH, HEIGHT, true>;

board::start!(render);

/// Variables, so that the linker says how much memory is needed.
static mut TEXT: [u8; 512] = [0; 512];
static mut STORED: MaybeUninit<Stored> = MaybeUninit::uninit();
static mut ROW: PixelRow = PixelRow::new();

fn render() -> Outcome {
    let (text, stored, row) = (&raw mut TEXT, &raw mut STORED, &raw mut ROW);
    // SAFETY: this function is called once, and nothing else names the variables.
    let (text, stored, row) = unsafe { (&mut *text, &mut *stored, &mut *row) };
    let stack = paint_stack();
    let stored = stored.write(Stored::new(ANY_CAMERA, Background::Solid(Rgb::BLACK)));
    let summary = load(text, stored)?;
    draw(&stored.as_scene(), row)?;

    print("objects ");
    print_number(summary.objects as u64);
    print("\nchecksum ");
    print_hexadecimal(row.checksum());
    if let Some(stack) = stack {
        print("\nstack ");
        print_number(stack.used()?.into());
    }
    print("\n");
    Ok(())
}

/// Reads the scene, into memory for the text and for what it says.
#[inline(never)] // The reader is not on the stack when the picture is rendered.
fn load(text: &mut [u8], stored: &mut Stored) -> Result<nff::Summary, &'static str> {
    let text = board::read_file(c"target/scene.nff", text)?;
    nff::read_bytes(text, stored).map_err(|error| tell("target/scene.nff", &error))
}

/// Renders into the picture's file.
#[inline(never)]
fn draw(scene: &Scene<'_, f32>, row: &mut PixelRow) -> Outcome {
    let tracer = FileTracer::try_new(scene).map_err(|error| tell("target/scene.nff", &error))?;
    let settings = Settings::new(WIDTH as u32, HEIGHT).with_depth(DEPTH as u8);
    let mut frame = Frame::new(&tracer, settings).map_err(|error| tell("the settings", &error))?;
    let mut picture = PictureFile::create()?;
    while let Err(RowIsFull) = frame.render(row).map_err(|_| RowIsFull) {
        picture.write(row)?;
    }
    picture.finish()
}

/// Says all about an error; gives what it is in short.
fn tell(what: &str, error: &dyn fmt::Display) -> &'static str {
    let _ = writeln!(Console, "{what}: {error}"); // Without a host there is nobody to be told.
    "no picture was rendered"
}

struct Console;

impl Write for Console {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        write_error(text.as_bytes());
        Ok(())
    }
}

/// For the scene before it is read.
const ANY_CAMERA: Camera<f32> = Camera::look_at(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 40.0);
