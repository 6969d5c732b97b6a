//! Draws a scene and a line of text on a display of 128×64 pixels in 16 greys, on the board lm3s6965evb (Cortex-M3). QEMU
//! shows it in a window:
//!
//!     cargo oled
//!     WHIT_SCENE=card WHIT_DEPTH=8 cargo oled
//!
//! which is short for
//!
//!     CARGO_TARGET_THUMBV7M_NONE_EABI_RUNNER='qemu-system-arm -M lm3s6965evb -semihosting-config enable=on,target=native -kernel' \
//!     cargo run --release --features embedded-graphics --example oled --target thumbv7m-none-eabi
//!
//! On Debian, QEMU's windows are in the package `qemu-system-gui`. The drawing takes some seconds, and what is drawn stays
//! until the window is closed. A picture that is too large, such as one of WHIT_SIZE=160x56, ends with an error before
//! anything is drawn.
//!
//! Without `--target` the same is drawn in memory, and written to `target/oled.png`:
//!
//!     cargo run --release --features embedded-graphics --example oled
#![cfg_attr(target_os = "none", no_std, no_main)]
#![allow(unsafe_code)] // Registers.
#![allow(clippy::indexing_slicing, clippy::panic)] // In constants, which the compiler evaluates.

#[path = "../board/mod.rs"]
mod board;
#[allow(dead_code)] // The state of the picture is of another type here.
#[path = "../firmware/choice.rs"]
mod choice;
#[cfg(not(target_os = "none"))]
mod host;
#[cfg(target_os = "none")]
mod lm3s6965evb;
mod screen;
#[cfg_attr(not(target_os = "none"), allow(dead_code))]
mod ssd0323;

use board::{Outcome, print};

board::start!(show);

/// Stays, so that the display can be looked at.
#[cfg(target_os = "none")]
fn show() -> Outcome {
    use core::fmt::Write;

    use ssd0323::Ssd0323;

    static mut SHOWN: [u8; ssd0323::BYTES] = [0; ssd0323::BYTES];
    let (bus, data_pin) = lm3s6965evb::display();
    let shown = &raw mut SHOWN;
    // SAFETY: this function is called once, and nothing else names the variable.
    let shown = unsafe { &mut *shown };
    let mut display = Ssd0323::start(bus, data_pin, shown).map_err(|_| "the display does not start")?;
    if let Err(problem) = screen::draw(&mut display) {
        let _ = writeln!(board::Console, "{problem}");
        return Err("the display stays as it was");
    }
    print("drawn\n");
    loop {
        cortex_m::asm::wfi();
    }
}

#[cfg(not(target_os = "none"))]
fn show() -> Outcome {
    let picture = host::picture().map_err(|problem| {
        eprintln!("{problem}");
        "nothing was drawn"
    })?;
    picture.save("target/oled.png").map_err(|_| "target/oled.png cannot be written; is there a folder target?")?;
    print("drawn: target/oled.png\n");
    Ok(())
}
