//! How much stack was used: its free part is filled with a pattern, and looked at later.

use core::arch::asm;

unsafe extern "C" {
    // The lowest address of the memory for the stack.
    #[cfg_attr(target_arch = "riscv32", link_name = "__estack")]
    #[cfg_attr(target_arch = "arm", link_name = "_stack_end")]
    static mut STACK_END: u32;
}

const PATTERN: u32 = 0xA5C3_5A3C;

#[inline(always)]
fn stack_pointer() -> usize {
    let pointer: usize;
    // SAFETY: reading a register changes nothing.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack));
        #[cfg(target_arch = "riscv32")]
        asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack));
    }
    pointer
}

/// A stack whose free part was filled.
pub struct Painted {
    pointer: usize,
}

/// Fills the free part of the stack. `None` where the machine does not let programs do that.
#[inline(always)] // What this function itself has on the stack is not to be overwritten.
pub fn paint_stack() -> Option<Painted> {
    let pointer = stack_pointer();
    let mut place = &raw mut STACK_END;
    while (place as usize) < pointer {
        // SAFETY: all from there up to the stack pointer is free.
        unsafe {
            place.write_volatile(PATTERN);
            place = place.add(1);
        }
    }
    Some(Painted { pointer })
}

impl Painted {
    /// The bytes below the stack pointer at that time that were written to since. When no byte was left, more than the stack's
    /// memory may have been.
    #[inline(never)]
    pub fn used(&self) -> Result<u32, &'static str> {
        let mut place = &raw const STACK_END;
        // SAFETY: as above.
        while (place as usize) < self.pointer && unsafe { place.read_volatile() } == PATTERN {
            place = unsafe { place.add(1) };
        }
        if core::ptr::eq(place, &raw const STACK_END) {
            return Err("the stack was used to its end: expected a smaller scene or picture, or more memory");
        }
        Ok((self.pointer - place as usize) as u32)
    }
}
