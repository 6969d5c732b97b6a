//! Writes docs/stack.md: how much stack rendering takes at most on bare metal; or checks that it takes no more.
//!
//!     rustup target add thumbv6m-none-eabi thumbv7em-none-eabihf
//!     cargo run --release --example stack
//!     cargo run --release --example stack -- --check
//!
//! Both fail where a program that renders a scene has a panic, recursion or a call by pointer in it.

mod build;
mod claims;
mod faults;
mod function;
mod graph;
mod image;
mod instruction;
#[path = "../effects/library.rs"]
mod library;
mod measure;
mod names;
mod page;
mod problem;
mod programs;
mod qemu;
mod wide;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use build::{LEVELS, TARGETS, Toolchain};
use clap::Parser;
use measure::{Measure, measure};
use rayon::prelude::*;

/// By how many bytes the stack may differ with the number of bounces, because of how the compiler lays it out.
const MOST_SPREAD: u64 = 96;

/// Writes a page of how much stack rendering takes at most, or checks that it takes no more than the page says.
#[derive(Debug, Parser)]
#[command(name = "stack")]
struct Arguments {
    /// The page.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/stack.md"))]
    page: PathBuf,
    /// Compare with the page, and write nothing.
    #[arg(long)]
    check: bool,
}

fn main() -> ExitCode {
    let Arguments { page, check } = Arguments::parse();
    let done =
        measure_all().and_then(|measures| if check { compare(&page, &measures) } else { write(&page, &measures) });
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("stack: {message}");
            ExitCode::FAILURE
        }
    }
}

fn measure_all() -> Result<Vec<Measure>, String> {
    let programs = programs::all();
    let mut measures = Vec::new();
    for target in TARGETS {
        for level in LEVELS {
            let toolchain = Toolchain::new(target, level)?;
            faults::are_found(&toolchain)?;
            let all = programs.par_iter().map(|program| measure(&toolchain, program));
            measures.extend(all.collect::<Result<Vec<_>, String>>()?);
        }
    }
    let spread = page::spread(&measures, |measure| u64::from(measure.stack));
    if spread > MOST_SPREAD {
        return Err(format!("between programs that differ by their bounces alone, stacks differ by {spread} bytes"));
    }
    Ok(measures)
}

fn write(page: &Path, measures: &[Measure]) -> Result<(), String> {
    let text = page::page(measures, &build::compiler()?);
    std::fs::write(page, text).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", page.display());
    Ok(())
}

fn compare(page: &Path, measures: &[Measure]) -> Result<(), String> {
    let text = std::fs::read_to_string(page).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", build::compiler()?);
    if measures.iter().any(|measure| measure.seen.is_none()) {
        println!("{} is not installed: no program was run", qemu::EMULATOR);
    }
    let (lines, grown) = page::compare(&text, measures);
    lines.iter().for_each(|line| println!("{line}"));
    if grown.is_empty() { Ok(()) } else { Err(format!("more than {} says:\n{}", page.display(), grown.join("\n"))) }
}
