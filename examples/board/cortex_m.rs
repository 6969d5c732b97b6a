//! Cortex-M: interrupts and the clock.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{Peripherals, SYST};
use cortex_m_rt::{ExceptionFrame, exception};

/// The table of the interrupts of a board's own devices ends after the first: none is turned on.
#[unsafe(link_section = ".vector_table.interrupts")]
#[unsafe(no_mangle)]
static __INTERRUPTS: [unsafe extern "C" fn(); 1] = [DefaultHandler];

unsafe extern "C" {
    fn DefaultHandler();
}

/// The processor found an instruction or an address that is none.
#[exception]
unsafe fn HardFault(_: &ExceptionFrame) -> ! {
    super::finish(Err("fault of the processor; was there too little memory for the stack?"))
}

/// The largest value of the timer, SysTick.
const LONGEST: u32 = 0x00FF_FFFF;

static WRAPS: AtomicU32 = AtomicU32::new(0);

/// What the clock does when its timer begins anew.
pub fn wrap() {
    // Nothing else writes to it, and the smallest processors cannot add in one step.
    WRAPS.store(WRAPS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

/// Counts instructions, in an emulator that takes a nanosecond of its own time for each.
pub struct Clock {
    timer: SYST,
}

impl Clock {
    /// Starts to count. `None` where there is nothing to count with.
    pub fn start() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(LONGEST);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        Some(Self { timer })
    }

    /// The instructions since the start, to within a tick of the timer.
    pub fn instructions(&self) -> u64 {
        loop {
            let wraps = WRAPS.load(Ordering::Relaxed);
            let left = SYST::get_current();
            if WRAPS.load(Ordering::Relaxed) == wraps {
                let ticks = u64::from(wraps) * u64::from(LONGEST + 1) + u64::from(LONGEST - left);
                return ticks * HALF_NANOSECONDS / 2;
            }
        }
    }
}

/// The duration of a tick. Of the boards here the one whose processor has no atomic swap, the micro:bit, has a clock of 16 MHz, and
/// the others one of 25 MHz.
const HALF_NANOSECONDS: u64 = if cfg!(target_has_atomic = "32") { 80 } else { 125 };
