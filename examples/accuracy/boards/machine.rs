//! The machines whose instructions are counted.

use std::process::Command;

use super::cargo;
use super::program::Program;
use super::target::WASM;

/// A processor, emulated so that each instruction is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Machine {
    /// Cortex-M4F, with an FPU for `f32`.
    M4F,
    /// Cortex-M0: its instructions, executed by a Cortex-M3, which has them all. Without FPU and division.
    M0,
    /// RV32IMAC, without an FPU.
    RV32,
    /// WebAssembly; with the instructions of a stack machine, of which many only put a value on the stack.
    Wasm,
}

/// All of them, the slow ones first.
pub const MACHINES: [Machine; 4] = [Machine::M0, Machine::RV32, Machine::M4F, Machine::Wasm];

/// The board with more memory than a micro:bit.
const M0_RUNNER: &str = "target.thumbv6m-none-eabi.runner = 'qemu-system-arm -M mps2-an385 -nographic \
                         -semihosting-config enable=on,target=native -icount shift=0 -kernel'";

impl Machine {
    /// As the compiler calls it.
    pub const fn target(self) -> &'static str {
        match self {
            Self::M4F => "thumbv7em-none-eabihf",
            Self::M0 => "thumbv6m-none-eabi",
            Self::RV32 => "riscv32imac-unknown-none-elf",
            Self::Wasm => WASM,
        }
    }

    /// `cargo build` or `cargo run` of a program for this machine.
    pub fn command(self, command: &str, program: &Program) -> Command {
        let mut cargo = cargo::example(command, "sweep", self.target(), "release");
        if self == Self::M0 {
            cargo.args(["--config", M0_RUNNER]);
        }
        program.choose(&mut cargo);
        cargo
    }
}
