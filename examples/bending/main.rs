//! Writes docs/bending.md, what accuracy costs where light is bent, with pictures of paths; or checks that its errors and steps
//! are still the same.
//!
//!     cargo run --release --example bending
//!     cargo run --release --example bending -- --check

#[allow(dead_code)] // The tests use more of it.
mod exact;
mod measure;
mod page;
mod pictures;
mod plot;
mod systems;
mod way;
mod world;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;

/// Writes a page of what accuracy costs where light is bent, or checks that it is still true.
#[derive(Debug, Parser)]
#[command(name = "bending")]
struct Arguments {
    /// The page; its pictures go into `images/bending` beside it.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/bending.md"))]
    page: PathBuf,
    /// Compare with the page, all but times, and write nothing.
    #[arg(long)]
    check: bool,
}

fn main() -> ExitCode {
    let Arguments { page, check } = Arguments::parse();
    match if check { compare(&page) } else { write(&page) } {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("bending: {message}");
            ExitCode::FAILURE
        }
    }
}

fn measure_all(timed: bool) -> Vec<page::Section> {
    let systems = systems::all().into_iter();
    systems.map(|system| page::Section { rows: measure::rows(&system, timed), system }).collect()
}

fn write(page: &Path) -> Result<(), String> {
    let sections = measure_all(true);
    pictures::write(&page.with_file_name("images").join("bending"), &sections)?;
    std::fs::write(page, page::page(&sections)).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", page.display());
    Ok(())
}

fn compare(page: &Path) -> Result<(), String> {
    let text = std::fs::read_to_string(page).map_err(|error| format!("{}: {error}", page.display()))?;
    let problems = page::compare(&text, &page::page(&measure_all(false)));
    if problems.is_empty() {
        println!("errors and steps are those of {}", page.display());
        return Ok(());
    }
    Err(format!("other than {} says:\n{}", page.display(), problems.join("\n")))
}
