//! RISC-V: the clock.

use riscv::register::minstret;

/// Counts instructions.
pub struct Clock {
    start: u64,
}

impl Clock {
    /// Starts to count. `None` where there is nothing to count with.
    pub fn start() -> Option<Self> {
        Some(Self { start: minstret::read64() })
    }

    /// The instructions since the start.
    pub fn instructions(&self) -> u64 {
        minstret::read64() - self.start
    }
}
