//! What the examples need of the machine that they run on: a start, text for the user, a file, a count of instructions and
//! the stack that was used. The same programs run on boards, on the machine at hand and, if they write no file, in a
//! WebAssembly engine.
#![allow(unsafe_code)] // Registers, the bounds of the stack and calls of the debugger.
#![allow(dead_code, unused_imports)] // None of the programs needs all of it.

#[cfg(all(target_arch = "arm", target_os = "none"))]
mod cortex_m;
#[cfg(not(any(target_os = "none", target_arch = "wasm32")))]
mod host;
#[cfg(all(target_arch = "riscv32", target_os = "none"))]
mod riscv;
#[cfg(target_os = "none")]
mod semihosting;
#[cfg(target_os = "none")]
mod stack;
mod text;
#[cfg(target_arch = "wasm32")]
mod wasm;

#[cfg(all(target_arch = "arm", target_os = "none"))]
pub use cortex_m::{Clock, wrap};
#[cfg(not(any(target_os = "none", target_arch = "wasm32")))]
use host::write;
#[cfg(not(any(target_os = "none", target_arch = "wasm32")))]
pub use host::{Clock, File, finish, paint_stack, read_file, rename, write_error};
#[cfg(all(target_arch = "riscv32", target_os = "none"))]
pub use riscv::Clock;
#[cfg(target_os = "none")]
use semihosting::write;
#[cfg(target_os = "none")]
pub use semihosting::{File, finish, read_file, rename, write_error};
#[cfg(target_os = "none")]
pub use stack::paint_stack;
pub use text::{Console, print, print_hexadecimal, print_number};
#[cfg(target_arch = "wasm32")]
use wasm::write;

/// How a program ends: well, or with what was wrong.
pub type Outcome = Result<(), &'static str>;

/// Makes a function that gives an [`Outcome`] the one with which the program starts.
///
/// On a Cortex-M, another function may be called in each interrupt of the timer SysTick; there is no [`Clock`] then.
macro_rules! start {
    ($main:ident) => {
        board::start!($main, board::wrap);
    };
    ($main:ident, $tick:path) => {
        #[cfg(all(target_arch = "arm", target_os = "none"))]
        #[cortex_m_rt::entry]
        fn start() -> ! {
            board::finish($main())
        }

        #[cfg(all(target_arch = "arm", target_os = "none"))]
        #[cortex_m_rt::exception]
        fn SysTick() {
            $tick();
        }

        #[cfg(all(target_arch = "riscv32", target_os = "none"))]
        #[riscv_rt::entry]
        fn start() -> ! {
            board::finish($main())
        }

        /// Whether it ended well.
        #[cfg(target_arch = "wasm32")]
        #[unsafe(no_mangle)]
        extern "C" fn start() -> bool {
            $main().is_ok()
        }

        #[cfg(not(any(target_os = "none", target_arch = "wasm32")))]
        fn main() -> std::process::ExitCode {
            board::finish($main())
        }
    };
}
pub(crate) use start;
