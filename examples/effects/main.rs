//! Writes docs/effects.md: what each effect costs in code, memory and time.
//!
//!     rustup target add thumbv7em-none-eabihf
//!     cargo run --release --example effects
//!
//! It compiles a small program for each of some fifty scenes, which takes a few minutes.

mod scenes;
mod size;
mod speed;
mod table;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use rayon::prelude::*;
use size::{Library, Probe};
use table::Row;

const TARGET: &str = "thumbv7em-none-eabihf";
const LEVELS: [&str; 2] = ["s", "3"];

macro_rules! rows {
    ($($with:ident, $without:ident, $function:literal;)*) => {
        vec![$(Row {
            effects: scenes::$with.effects().without(scenes::$without.effects()),
            with: stringify!($with),
            without: stringify!($without),
            speed: speed::compare(&whit::tracer!(scenes::$with), &whit::tracer!(scenes::$without)),
        }),*]
    };
}

/// Writes a page of what each effect costs in code, memory and time.
#[derive(Debug, Parser)]
#[command(name = "effects")]
struct Arguments {
    /// The page.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/effects.md"))]
    page: PathBuf,
}

fn main() -> ExitCode {
    match write(&Arguments::parse().page) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("effects: {message}");
            ExitCode::FAILURE
        }
    }
}

fn write(page: &Path) -> Result<(), String> {
    // Times first, while nothing else runs.
    let rows = scenes::pairs!(rows);
    let library = Library::build(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/target/effects")), Some(TARGET))
        .map_err(|error| format!("is {TARGET} installed? `rustup target add {TARGET}`\n{error}"))?;
    let mut names: Vec<&str> = rows.iter().flat_map(|row| [row.with, row.without]).collect();
    names.sort_unstable();
    names.dedup();
    let probe = |&name: &&'static str| {
        let [small, fast] = LEVELS.map(|level| library.probe(name, level));
        Ok((name, [small?, fast?]))
    };
    let probes: HashMap<&str, [Probe; 2]> = names.par_iter().map(probe).collect::<Result<_, String>>()?;
    if let Some((name, _)) = probes.iter().find(|(_, levels)| levels.iter().any(Probe::can_panic)) {
        return Err(format!("the program for {name} can panic"));
    }
    std::fs::write(page, table::page(&rows, &probes)).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", page.display());
    Ok(())
}
