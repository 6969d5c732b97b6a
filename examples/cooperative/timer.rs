//! Two timers of a board: SysTick, with an interrupt every millisecond, and a counter that has nothing to do with it and
//! says whether one was lost.

use core::arch::asm;
use core::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{Peripherals, SYST};

use crate::counter::Counter;

/// Of both timers, in a millisecond.
const TICKS: u32 = crate::counter::FREQUENCY / 1000;

static INTERRUPTS: AtomicU32 = AtomicU32::new(0);
static LONGEST_WAIT: AtomicU32 = AtomicU32::new(0);
/// What a lamp's pin would be set to.
static LAMP: AtomicBool = AtomicBool::new(false);

/// The interrupt. Its job is to dim a lamp by turning it off early in each period of 20 ms; every period is another level.
pub fn tick() {
    // The timer counts down, asks for the interrupt when it reaches 0, and begins anew in the next tick.
    let wait = (TICKS - SYST::get_current()) % TICKS;
    // Nothing else writes to these, and the smallest processors cannot add in one step.
    LONGEST_WAIT.store(LONGEST_WAIT.load(Relaxed).max(wait), Relaxed);
    let interrupts = INTERRUPTS.load(Relaxed);
    INTERRUPTS.store(interrupts + 1, Relaxed);
    LAMP.store(interrupts % 20 < interrupts / 20 % 20, Relaxed);
}

/// What there was while the timers ran.
pub struct Interrupts {
    pub served: u32,
    /// How long it was, by the other timer.
    pub ticks: u32,
    /// The whole ones in that time.
    pub milliseconds: u32,
    /// From a request to the measurement at the start of the handler, in instructions.
    pub longest_wait: u64,
}

/// The timers.
pub struct Timer {
    systick: SYST,
    counter: Counter,
    /// How many instructions this emulator executes in how many ticks.
    speed: (u32, u32),
}

impl Timer {
    /// The only one. Nothing counts yet.
    pub fn new() -> Option<Self> {
        let mut systick = Peripherals::take()?.SYST;
        systick.set_clock_source(SystClkSource::Core);
        systick.set_reload(TICKS - 1);
        systick.enable_interrupt();
        let counter = Counter::start();
        let start = counter.ticks();
        let instructions = take_time();
        let speed = (instructions, counter.ticks().wrapping_sub(start));
        Some(Self { systick, counter, speed })
    }

    /// Starts the interrupts. Gives the time.
    pub fn start(&mut self) -> u32 {
        INTERRUPTS.store(0, Relaxed);
        LONGEST_WAIT.store(0, Relaxed);
        self.systick.clear_current();
        self.systick.enable_counter();
        self.now()
    }

    /// The time in ticks.
    pub fn now(&self) -> u32 {
        self.counter.ticks()
    }

    /// Stops the interrupts that began at a time.
    pub fn stop(&mut self, start: u32) -> Interrupts {
        let ticks = self.now().wrapping_sub(start);
        self.systick.disable_counter();
        Interrupts {
            served: INTERRUPTS.load(Relaxed),
            ticks,
            milliseconds: ticks / TICKS,
            longest_wait: self.instructions(LONGEST_WAIT.load(Relaxed).into()),
        }
    }

    /// How many instructions are executed in a number of ticks.
    pub fn instructions(&self, ticks: u64) -> u64 {
        ticks * u64::from(self.speed.0) / u64::from(self.speed.1)
    }
}

/// Executes a number of instructions and gives it.
fn take_time() -> u32 {
    const ROUNDS: u32 = 1_000_000;
    // SAFETY: it changes a register that it has for itself.
    unsafe {
        asm!("2: subs {rounds}, #1", "bne 2b", rounds = inout(reg) ROUNDS => _, options(nomem, nostack));
    }
    2 * ROUNDS
}
