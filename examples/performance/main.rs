//! Writes docs/performance.md: how fast whit is beside other programs, by the number of objects and by threads.
//!
//!     apt-get install g++ povray libembree-dev valgrind
//!     apt-get install qemu-system-arm gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib
//!     rustup target add thumbv7em-none-eabihf
//!     cargo run --release --example performance
//!
//! takes about half an hour, on a machine that does nothing else. `-- --quick PAGE` takes two minutes, and shows only that
//! everything works.

#![allow(clippy::indexing_slicing)] // Places are those of the same lists.

mod agreement;
mod aim;
mod boards;
#[path = "../instructions/callgrind.rs"]
mod callgrind;
mod card;
mod chart;
mod clock;
mod contest;
mod crossing;
mod curve;
mod databases;
mod effort;
#[path = "../instructions/files.rs"]
mod files;
mod flake;
mod page;
mod picture;
#[allow(dead_code)] // It finds more than is asked for here.
#[path = "../instructions/profile/places.rs"]
mod places;
mod povray;
mod povray_scene;
mod profile;
mod programs;
mod rays;
mod replay;
mod rounds;
mod section;
mod threads;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use effort::Effort;
use page::Page;
use programs::Programs;
use section::Section;

/// Writes a page of how fast whit is.
#[derive(Debug, Parser)]
#[command(name = "performance")]
struct Arguments {
    /// The page; its pictures go into `images/performance` beside it.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/performance.md"))]
    page: PathBuf,
    /// Small jobs that show only whether everything works.
    #[arg(long)]
    quick: bool,
}

fn main() -> ExitCode {
    let Arguments { page, quick } = Arguments::parse();
    match write(&page, &if quick { Effort::QUICK } else { Effort::FULL }) {
        Ok(()) => {
            println!("{}", page.display());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("performance: {message}");
            ExitCode::FAILURE
        }
    }
}

fn write(path: &std::path::Path, effort: &Effort) -> Result<(), String> {
    let page = Page::new(path)?;
    let programs = Programs::build()?;
    page.write(&[
        card::measure(&programs, effort)?,
        flake::measure(&programs, effort)?,
        databases::measure(&programs, effort)?,
        replay::measure(&programs, effort)?,
        curve::measure(&programs, effort, &page.images)?,
        threads::measure(effort)?,
        profile::measure(&programs)?,
        on_boards()?,
    ])
}

fn on_boards() -> Result<Section, String> {
    eprintln!("scenes on a board");
    let hint = "is thumbv7em-none-eabihf installed? `rustup target add thumbv7em-none-eabihf`";
    let rows = boards::measure().map_err(|error| format!("{hint}\n{error}"))?;
    Ok(Section { text: format!("\n{}", boards::section(&rows)), aims: Vec::new() })
}
