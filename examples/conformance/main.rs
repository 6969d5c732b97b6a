//! Prints a checksum of the linear pixels of every built-in scene: the same on every machine.
//!
//!     cargo run --release --example conformance
//!     cargo run --release --example conformance --target thumbv7em-none-eabihf
#![cfg_attr(any(target_os = "none", target_arch = "wasm32"), no_std, no_main)]
#![allow(unsafe_code)] // The exported start of a program for WebAssembly.

#[path = "../board/mod.rs"]
mod board;
#[path = "../board/checksum.rs"]
mod checksum;

use board::{Outcome, print, print_hexadecimal};
use checksum::Checksum;
use whit::render::{ForEach, Pixel, Size};
use whit::{Effects, Frame, Scene, Settings, Tracer, scenes};

const SIZE: Size = Size::new(16, 12);
const DEPTH: u8 = 5;
/// The places for bounces that a tracer of any scene needs: dispersion takes two more.
const STACK: usize = DEPTH as usize + 2;

/// One tracer for all scenes, as for scenes that are known only at run time.
type AnyTracer = Tracer<'static, f32, { Effects::ALL.bits() }, STACK, 8>;

board::start!(print_all);

fn print_all() -> Outcome {
    for (name, scene) in &scenes::ALL {
        let value = checksum_of(scene)?;
        print_hexadecimal(value);
        print(" ");
        print(name);
        print("\n");
    }
    Ok(())
}

fn checksum_of(scene: &'static Scene<'static, f32>) -> Result<u64, &'static str> {
    let tracer = AnyTracer::try_new(scene).map_err(|_| "a built-in scene was found to be wrong")?;
    let mut checksum = Checksum::EMPTY;
    let mut target = ForEach::new(SIZE, |pixel: Pixel| {
        checksum.add(&pixel);
        Ok::<(), &'static str>(())
    });
    let settings = Settings::new(SIZE.width, SIZE.height).with_depth(DEPTH);
    let mut frame = Frame::new(&tracer, settings).map_err(|_| "the settings were found to be wrong")?;
    frame.render(&mut target).map_err(|_| "a picture was not finished")?;
    Ok(checksum.value())
}
