//! How many instructions the machine has executed.

pub use machine::{instructions, start};

/// A timer of the boards with an emulated Cortex-M3 or M4, in an emulator that takes a nanosecond of its own time for an instruction.
/// Unlike SysTick it counts for minutes without an interrupt.
#[cfg(all(target_arch = "arm", target_os = "none"))]
mod machine {
    /// Of Arm's Cortex-M System Design Kit: the registers of the first timer.
    const CONTROL: *mut u32 = 0x4000_0000 as *mut u32;
    const VALUE: *mut u32 = 0x4000_0004 as *mut u32;
    const RELOAD: *mut u32 = 0x4000_0008 as *mut u32;
    /// At 25 MHz.
    const NANOSECONDS: u64 = 40;

    pub fn start() {
        // SAFETY: these registers are the timer's, and nothing else uses them.
        unsafe {
            RELOAD.write_volatile(u32::MAX);
            VALUE.write_volatile(u32::MAX);
            CONTROL.write_volatile(1);
        }
    }

    /// To within a tick of the timer, 40 instructions; for 2³² ticks.
    pub fn instructions() -> Option<u64> {
        // SAFETY: as above.
        let left = unsafe { VALUE.read_volatile() };
        Some(u64::from(u32::MAX - left) * NANOSECONDS)
    }
}

#[cfg(all(target_arch = "riscv32", target_os = "none"))]
mod machine {
    pub fn start() {}

    pub fn instructions() -> Option<u64> {
        Some(riscv::register::minstret::read64())
    }
}

/// The engine counts.
#[cfg(target_arch = "wasm32")]
mod machine {
    #[link(wasm_import_module = "board")]
    unsafe extern "C" {
        #[link_name = "instructions"]
        safe fn executed() -> u64;
    }

    pub fn start() {}

    pub fn instructions() -> Option<u64> {
        Some(executed())
    }
}

/// Nothing is counted.
#[cfg(not(any(target_os = "none", target_arch = "wasm32")))]
mod machine {
    pub fn start() {}

    pub fn instructions() -> Option<u64> {
        None
    }
}
