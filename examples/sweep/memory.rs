//! Memory for the scene in another number type, for the picture, and on boards for the stack: the linker knows of as much as the
//! smallest board has, which is too little.

use core::mem::MaybeUninit;

use whit::Rgb;

use crate::board::Outcome;
use crate::{Drawn, PIXELS, number};

/// What outlives a picture.
pub struct Memory {
    pub scene: MaybeUninit<number::Memory>,
    pub frame: MaybeUninit<Drawn>,
    pub pixels: MaybeUninit<[Rgb<f32>; PIXELS]>,
}

/// Renders with the memory. This is done once.
#[cfg(not(target_os = "none"))]
pub fn render() -> Outcome {
    static mut MEMORY: MaybeUninit<Memory> = MaybeUninit::uninit();
    let memory = &raw mut MEMORY;
    // SAFETY: this function is called once, nothing else names the variable, and all in it may be without a value.
    crate::render_all(unsafe { (*memory).assume_init_mut() })
}

#[cfg(target_os = "none")]
pub use board::render;

/// The board's own memory, of which linker scripts say nothing.
#[cfg(target_os = "none")]
mod board {
    use core::arch::asm;

    use super::{Memory, Outcome};

    /// 16 MiB at this address are the PSRAM of `mps2-an385` and `mps2-an386`, and a part of the memory of RISC-V's `virt`.
    const START: usize = if cfg!(target_arch = "arm") { 0x2100_0000 } else { 0x8400_0000 };
    /// The stack grows downwards from here; the rest is from here upwards.
    const MIDDLE: usize = START + 0x0080_0000;

    /// Goes on with another stack, and does not come back: what is returned is how the program ends.
    pub fn render() -> Outcome {
        // SAFETY: nothing is below the new stack, and nothing of the old one is used any more.
        unsafe {
            #[cfg(target_arch = "arm")]
            asm!("mov sp, {stack}", "bx {end}", stack = in(reg) MIDDLE, end = in(reg) end, options(noreturn));
            #[cfg(target_arch = "riscv32")]
            asm!("mv sp, {stack}", "jr {end}", stack = in(reg) MIDDLE, end = in(reg) end, options(noreturn));
        }
    }

    extern "C" fn end() -> ! {
        // SAFETY: this is reached once, nothing else is there, and all in it may be without a value.
        let memory = unsafe { &mut *(MIDDLE as *mut Memory) };
        crate::board::finish(crate::render_all(memory))
    }
}
