//! Counts the instructions that rendering a scene takes by settings: on boards, and on the machine at hand the checksums alone.
//!
//!     WHIT_SCENE=glass WHIT_SIZE=32x24 WHIT_RUNS='5,0,background,1;3,0.00392,black,4' \
//!         cargo run --release --example sweep --target thumbv7em-none-eabihf
//!
//! prints a line for each run: bounces, cutoff, what stands for what is cut, samples a pixel, the instructions of the whole
//! picture, and the checksum of its linear pixels. What is fixed when it is compiled besides: WHIT_NUMBER, the number type;
//! WHIT_FRESNEL, `exact` or `schlick`; WHIT_SPECTRUM of thin films, `wavelengths`, `table`, or `bands:16`; WHIT_STEPS of bent light,
//! `length:0.02`, `tolerance:0.00001` or `layers:0.01`; WHIT_OFFSET, the distance at which rays leave surfaces, such as `0.001`. What
//! is not named is as the scene has it.
//!
//! It takes more memory than a micro:bit has, so that a program for a Cortex-M0 runs on a board with a Cortex-M3, which has the
//! same instructions and more:
//!
//!     cargo run --release --example sweep --target thumbv6m-none-eabi --config "target.thumbv6m-none-eabi.runner = \
//!         'qemu-system-arm -M mps2-an385 -nographic -semihosting-config enable=on,target=native -icount shift=0 -kernel'"
#![cfg_attr(any(target_os = "none", target_arch = "wasm32"), no_std, no_main)]
#![allow(unsafe_code, clippy::indexing_slicing, clippy::panic, clippy::expect_used)] // In constants, which the compiler evaluates.

#[path = "../board/mod.rs"]
mod board;
#[path = "../board/checksum.rs"]
mod checksum;
#[allow(dead_code)] // The number of bounces is that of the runs.
#[path = "../firmware/choice.rs"]
mod choice;
mod clock;
mod decimal;
mod memory;
mod models;
#[path = "../firmware/number.rs"]
mod number;
mod run;

use board::{Outcome, print, print_hexadecimal, print_number};
use checksum::Checksum;
use choice::SIZE;
use memory::Memory;
use models::SCENE;
use number::{Chosen, Drawn};
use run::{DEPTH, RUNS, Run};
use whit::render::{LinearRgb, Pixel, Size};
use whit::{Frame, Rgb};

board::start!(render);

/// How many pixels a picture has.
const PIXELS: usize = SIZE[0] as usize * SIZE[1] as usize;

fn render() -> Outcome {
    memory::render()
}

fn render_all(memory: &'static mut Memory) -> Outcome {
    let Memory { scene, frame, pixels } = memory;
    let pixels = pixels.write([Rgb::BLACK; PIXELS]);
    let tracer = Chosen::tracer(scene)?;
    clock::start();
    for text in RUNS.split(';') {
        let settings = Run::read(text)?.settings(SIZE);
        let frame = frame.write(Frame::new(&tracer, settings).map_err(|_| "WHIT_RUNS or WHIT_SIZE: too much")?);
        let before = clock::instructions();
        draw(frame, pixels)?;
        let after = clock::instructions();
        report(text, before.zip(after).map(|(before, after)| after.wrapping_sub(before)), checksum(pixels));
    }
    Ok(())
}

/// A function of its own, so that the compiler knows of the settings no more than they are variables.
#[inline(never)]
fn draw(frame: &mut Drawn, pixels: &mut [Rgb<f32>]) -> Outcome {
    let mut picture =
        LinearRgb::new(Size::new(SIZE[0], SIZE[1]), pixels).map_err(|_| "the picture's memory is wrong")?;
    frame.render(&mut picture).map_err(|_| "a picture was not finished")
}

fn checksum(pixels: &[Rgb<f32>]) -> u64 {
    let mut checksum = Checksum::EMPTY;
    for color in pixels {
        checksum.add(&Pixel { x: 0, y: 0, cell: 1, color: *color });
    }
    checksum.value()
}

/// A line, with the run as it was asked for.
fn report(text: &str, instructions: Option<u64>, checksum: u64) {
    print("run");
    for word in text.split(',') {
        print(" ");
        print(word.trim());
    }
    if let Some(instructions) = instructions {
        print(" instructions ");
        print_number(instructions);
    }
    print(" checksum ");
    print_hexadecimal(checksum);
    print("\n");
}
