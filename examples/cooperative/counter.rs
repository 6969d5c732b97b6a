//! A counter of 32 bits among the devices of a board, at the frequency of its processor's clock.

/// In Hz.
pub const FREQUENCY: u32 = if IS_MICROBIT { 16_000_000 } else { 25_000_000 };

/// Of the boards here it is the one whose processor has no atomic swap.
const IS_MICROBIT: bool = !cfg!(target_has_atomic = "32");

/// The counter: on the micro:bit TIMER0 of its nRF51, and on Arm's MPS2 boards the first of the CMSDK timers, which counts
/// down from the largest number.
pub struct Counter(());

impl Counter {
    /// Starts it.
    pub fn start() -> Self {
        if IS_MICROBIT {
            write(0x4000_8508, 3); // 32 bits.
            write(0x4000_8510, 0); // Every cycle.
            write(0x4000_8000, 1); // Start.
        } else {
            write(0x4000_0008, u32::MAX); // What it begins anew with.
            write(0x4000_0004, u32::MAX); // What it begins with.
            write(0x4000_0000, 1); // Start.
        }
        Self(())
    }

    /// How many ticks it has counted; after 2³² of them it begins anew.
    #[inline]
    pub fn ticks(&self) -> u32 {
        if IS_MICROBIT {
            write(0x4000_8040, 1); // Takes a copy of the number.
            read(0x4000_8540)
        } else {
            !read(0x4000_0004)
        }
    }
}

#[inline]
fn read(register: u32) -> u32 {
    // SAFETY: the addresses above are those of registers, and reading them has no effect on memory.
    unsafe { (register as *const u32).read_volatile() }
}

#[inline]
fn write(register: u32, value: u32) {
    // SAFETY: as above.
    unsafe { (register as *mut u32).write_volatile(value) }
}
