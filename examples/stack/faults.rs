//! Programs with a known fault, to show that each fault would be found.

use crate::build::Toolchain;
use crate::image::Image;
use crate::measure;

struct Fault {
    name: &'static str,
    source: &'static str,
    /// The beginning of what must be said of it.
    found: &'static [&'static str],
}

const HEAD: &str = r#"#![no_std]
#![no_main]
#![allow(dead_code)]
use core::{arch::asm, hint::black_box};
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! { loop {} }
#[unsafe(no_mangle)]
fn reset() -> ! { loop { black_box(step(black_box(1))); } }
#[inline(never)]
fn add(n: usize) -> usize { black_box(n) + 1 }
#[unsafe(no_mangle)]
#[inline(never)]
"#;

const FAULTS: [Fault; 6] = [
    Fault {
        name: "panic",
        source: "fn step(n: usize) -> usize { black_box([1, 2, 3])[n] }",
        found: &["panic: core::panicking::panic_bounds_check is linked in, called by reset → step → "],
    },
    Fault {
        name: "recursion",
        source: "fn step(n: usize) -> usize { if n < 2 { n } else { black_box(other(n - 1)) + n } }
            #[inline(never)] fn other(n: usize) -> usize { step(black_box(n)) + add(n) }",
        found: &["recursion: step → "],
    },
    Fault {
        name: "pointer",
        source: "fn step(n: usize) -> usize { black_box(&FUNCTIONS)[n & 1](n) }
            static FUNCTIONS: [fn(usize) -> usize; 2] = [add, add];",
        found: &["function pointer: step calls what a register holds", "function pointer: the address of "],
    },
    Fault {
        name: "trap",
        source: "fn step(n: usize) -> usize { if n == 7 { unsafe { asm!(\"udf #0\") } }; n }",
        found: &["trap: step "],
    },
    Fault {
        name: "unbounded",
        source: "fn step(n: usize) -> usize { unsafe { asm!(\"mov r1, sp\", \"subs r1, r1, {0}\", \"mov sp, r1\", in(reg) n, \
                 out(\"r1\") _) }; add(n) }",
        found: &["unclear: step, at "],
    },
    Fault {
        name: "hidden",
        source: "fn step(n: usize) -> usize { unsafe { asm!(\"sub sp, #16\", \"add sp, #16\") }; add(n) }",
        found: &["stack frame of step: "],
    },
];

/// Fails unless each fault is found, and what a program without one has is found too.
pub fn are_found(toolchain: &Toolchain) -> Result<(), String> {
    for Fault { name, source, found } in FAULTS {
        let said = look_into(toolchain, name, source)?.err().unwrap_or_default();
        for beginning in found {
            if !said.iter().any(|line| line.starts_with(beginning)) {
                return Err(format!("\"{beginning}\" is not said of the program `{name}`, but only: {said:#?}"));
            }
        }
    }
    let source = "fn step(n: usize) -> usize { add(n) + add(n) }";
    look_into(toolchain, "sound", source)?.map_err(|said| format!("a sound program is refused: {said:#?}"))
}

fn look_into(toolchain: &Toolchain, name: &str, source: &str) -> Result<Result<(), Vec<String>>, String> {
    let file = toolchain.link(&format!("fault_{name}"), &format!("{HEAD}{source}\n"))?;
    let bytes = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let found = measure::look_into(&Image::read(&bytes)?);
    Ok(found.map(|_| ()).map_err(|problems| problems.iter().map(ToString::to_string).collect()))
}
