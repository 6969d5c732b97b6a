//! The `cooperative` example on an emulated board: whether rendering leaves interrupts alone, and how long its steps are.
#![cfg(any(unix, windows))]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../examples/board/checksum.rs"]
mod checksum;
#[path = "../examples/firmware/choice.rs"]
mod choice;
#[path = "support/emulator.rs"]
mod emulator;
#[path = "../examples/cooperative/picture.rs"]
mod picture;

use std::process::Command;

use emulator::Emulator;
use picture::Picture;
use whit::render::Progress;

const TARGET: &str = "thumbv7em-none-eabihf";
const QEMU: &str = "qemu-system-arm";

/// The instructions of the timer's tick at 8 ns an instruction, to which everything is measured.
const TICK: u64 = 5;
/// What is allowed for one ray of `showcase`, which tests 6 objects and shades at most one surface: about twice what the
/// longest takes, so that it is the kind of work that is tested and not the compiler.
const LONGEST_RAY: u64 = 4400;

/// A line of the table.
#[derive(Debug)]
struct Measured {
    rays: u64,
    steps: u64,
    longest: u64,
    average: u64,
    interrupts: u64,
    milliseconds: u64,
    longest_wait: u64,
    checksum: u64,
}

impl Measured {
    fn parse(line: &str) -> Self {
        let (numbers, checksum) = line.rsplit_once(' ').unwrap();
        let numbers: Vec<u64> = numbers.split_whitespace().map(|number| number.parse().unwrap()).collect();
        let [rays, steps, longest, average, interrupts, milliseconds, longest_wait] = numbers[..] else {
            panic!("{line}");
        };
        let checksum = u64::from_str_radix(checksum, 16).unwrap();
        Self { rays, steps, longest, average, interrupts, milliseconds, longest_wait, checksum }
    }
}

fn run() -> Vec<Measured> {
    let firmware = emulator::build("cooperative", TARGET, &[]);
    let qemu = Emulator::start(
        Command::new(QEMU)
            .args(["-M", "mps2-an386", "-nographic", "-icount", "shift=3"])
            .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
            .arg(firmware),
    );
    let lines = qemu.lines_until(|_| false);
    let table = lines.iter().skip_while(|line| !line.starts_with("rays")).skip(1);
    table.map(|line| Measured::parse(line)).collect()
}

/// The steps and the checksum here.
fn expected(rays: u64) -> (u64, u64) {
    let mut picture = Picture::new().unwrap();
    let mut steps = 1;
    while picture.step(rays as u32).unwrap() == Progress::More {
        steps += 1;
    }
    (steps, picture.checksum())
}

#[test]
fn steps_are_short_and_no_interrupt_is_lost() {
    if !emulator::is_installed(TARGET, QEMU) {
        return;
    }
    let table = run();
    assert_eq!(table.iter().map(|line| line.rays).collect::<Vec<_>>(), [1, 10, 100]);
    for line in &table {
        assert!(line.milliseconds > 100 && line.interrupts == line.milliseconds, "{line:?}");
        assert!(line.longest_wait <= 2 * TICK, "{line:?}");
        assert_eq!((line.steps, line.checksum), expected(line.rays), "{line:?}");
        // A step of many rays is as many steps of one ray.
        assert!(line.longest <= line.rays * table[0].longest && line.average <= line.longest, "{line:?}");
    }
    if choice::NAME == "showcase" {
        assert!(table[0].longest <= LONGEST_RAY, "{:?}", table[0]);
    }
}
