//! Renders in the time that a more urgent job leaves: an interrupt every millisecond, and in the main loop one step of a
//! picture after the other.
//!
//!     cargo cooperative
//!     WHIT_SCENE=glass WHIT_SIZE=64x48 WHIT_DEPTH=8 cargo cooperative
//!
//! which is short for
//!
//!     CARGO_TARGET_THUMBV7EM_NONE_EABIHF_RUNNER='qemu-system-arm -M mps2-an386 -nographic -semihosting-config enable=on,target=native -icount shift=3 -kernel' \
//!     cargo run --release --example cooperative --target thumbv7em-none-eabihf
//!
//! In this emulation every instruction takes 8 ns (2³), as on a processor of 125 MHz that executes one each cycle. The
//! program works on `thumbv7m-none-eabi` and `thumbv6m-none-eabi` as well, and at any such speed. For steps of 1, 10 and
//! 100 rays it prints
//!
//! - how many steps there were, and the instructions of the longest and of all on average, interrupts included;
//! - how many interrupts were served, and how many milliseconds a timer counted that has nothing to do with them;
//! - the longest that an interrupt had to wait, in instructions, to within one tick of the timer (5 at that speed);
//! - the checksum of the picture, which is the one that `firmware` prints.
//!
//! Without `--target` it renders in the same steps on the machine at hand, and measures nothing.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![allow(unsafe_code, clippy::indexing_slicing, clippy::panic)] // In constants, which the compiler evaluates.

#[path = "../board/mod.rs"]
mod board;
#[path = "../board/checksum.rs"]
mod checksum;
#[path = "../firmware/choice.rs"]
mod choice;
#[cfg(all(target_arch = "arm", target_os = "none"))]
mod counter;
mod picture;
#[cfg(all(target_arch = "arm", target_os = "none"))]
mod timer;

use core::fmt::Write;

use board::{Console, Outcome};
use picture::Picture;
use whit::render::Progress;

#[cfg(all(target_arch = "arm", target_os = "none"))]
board::start!(measure_all, timer::tick);
#[cfg(not(all(target_arch = "arm", target_os = "none")))]
board::start!(render_all);

/// The rays of a step.
const RAYS: [u32; 3] = [1, 10, 100];

fn print_choice() {
    let (name, [width, height], depth) = (choice::NAME, choice::SIZE, choice::DEPTH);
    let _ = writeln!(Console, "scene {name}, {width} x {height}, depth {depth}");
}

#[cfg(all(target_arch = "arm", target_os = "none"))]
fn measure_all() -> Outcome {
    let mut timer = timer::Timer::new().ok_or("the timer is in use")?;
    print_choice();
    board::print("rays    steps  longest  average  interrupts  milliseconds  longest wait          checksum\n");
    RAYS.iter().try_for_each(|&rays| measure(rays, &mut timer))
}

#[cfg(all(target_arch = "arm", target_os = "none"))]
fn measure(rays: u32, timer: &mut timer::Timer) -> Outcome {
    let mut picture = Picture::new()?;
    let (mut steps, mut longest) = (0, 0);
    let start = timer.start();
    let mut progress = Progress::More;
    while progress == Progress::More {
        let before = timer.now();
        progress = picture.step(rays)?;
        longest = timer.now().wrapping_sub(before).max(longest);
        steps += 1;
    }
    let timer::Interrupts { served, ticks, milliseconds, longest_wait } = timer.stop(start);
    let longest = timer.instructions(longest.into());
    let average = timer.instructions(ticks.into()) / steps;
    let checksum = picture.checksum();
    let _ = writeln!(
        Console,
        "{rays:4}{steps:9}{longest:9}{average:9}{served:12}{milliseconds:14}{longest_wait:14}  {checksum:016x}"
    );
    Ok(())
}

#[cfg(not(all(target_arch = "arm", target_os = "none")))]
fn render_all() -> Outcome {
    print_choice();
    board::print("rays    steps          checksum\n");
    for rays in RAYS {
        let mut picture = Picture::new()?;
        let mut steps = 1;
        while picture.step(rays)? == Progress::More {
            steps += 1;
        }
        let checksum = picture.checksum();
        let _ = writeln!(Console, "{rays:4}{steps:9}  {checksum:016x}");
    }
    Ok(())
}
