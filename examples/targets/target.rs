//! The machines that the firmware runs on.

/// A processor, and the board in the emulator that has one (`.cargo/config.toml` says how it is run).
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// As the compiler calls it.
    pub name: &'static str,
    /// In short.
    pub short: &'static str,
    pub processor: &'static str,
    pub board: &'static str,
    /// Whether it is an Arm processor: the worst case of the stack is worked out from its machine code.
    pub is_arm: bool,
}

pub const TARGETS: [Target; 4] = [
    Target {
        name: "thumbv7em-none-eabihf",
        short: "M4F",
        processor: "Cortex-M4F, with an FPU for `f32`",
        board: "mps2-an386",
        is_arm: true,
    },
    Target {
        name: "thumbv7m-none-eabi",
        short: "M3",
        processor: "Cortex-M3, without an FPU",
        board: "mps2-an385",
        is_arm: true,
    },
    Target {
        name: "thumbv6m-none-eabi",
        short: "M0",
        processor: "Cortex-M0, without FPU and division",
        board: "microbit",
        is_arm: true,
    },
    Target {
        name: "riscv32imac-unknown-none-elf",
        short: "RV32",
        processor: "RV32IMAC, without an FPU",
        board: "virt",
        is_arm: false,
    },
];

/// The target whose programs run in a WebAssembly engine.
pub const WASM: &str = "wasm32-unknown-unknown";
