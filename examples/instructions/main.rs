//! Counts the instructions that rendering takes, and says where they go: writes docs/instructions.md and
//! docs/instructions.csv; or checks that no scene takes more than recorded.
//!
//!     cargo run --release --example instructions
//!     cargo run --release --example instructions -- --check
//!     cargo run --release --example instructions -- --lines card
//!
//! The first two need Valgrind. The first and the third need QEMU for Arm, and `rustup target add thumbv7em-none-eabihf`;
//! the third prints the lines of the library on which a Cortex-M4F spends most instructions.

#[macro_use]
#[path = "../accuracy/list.rs"]
mod list;

mod callgrind;
mod compare;
mod count;
mod counted;
mod files;
#[path = "../effects/library.rs"]
mod library;
mod page;
mod profile;
mod record;
mod subject;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Parser;
use count::Count;
use rayon::prelude::*;
use record::{Machine, Record};
use subject::Subject;

/// Counts the instructions that rendering takes, and says where they go.
#[derive(Debug, Parser)]
#[command(name = "instructions")]
struct Arguments {
    /// The page; the counts are in a file of the same name that ends in .csv.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/instructions.md"))]
    page: PathBuf,
    /// Compare with the counts, and write nothing.
    #[arg(long)]
    check: bool,
    /// Print the lines on which the firmware for a built-in scene spends most instructions.
    #[arg(long, value_name = "SCENE", conflicts_with = "check")]
    lines: Option<String>,
    /// Do what is counted of a subject: for the program itself, which it runs in Valgrind.
    #[arg(long, value_name = "SUBJECT", hide = true)]
    run: Option<String>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let done = match &arguments {
        Arguments { run: Some(name), .. } => Subject::find(name).and_then(counted::run),
        Arguments { lines: Some(scene), .. } => print_lines(scene),
        Arguments { check: true, page, .. } => check(&page.with_extension("csv")),
        Arguments { page, .. } => write(page),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("instructions: {message}");
            ExitCode::FAILURE
        }
    }
}

fn write(page: &Path) -> Result<(), String> {
    let counts = count_all()?;
    let records = records(&machine()?, &counts)?;
    let profiles = page::PROFILED.into_iter().map(profile::profile).collect::<Result<Vec<_>, _>>()?;
    let text = page::page(&records, &counts, &profiles)?;
    record::write(&page.with_extension("csv"), &records)?;
    std::fs::write(page, text).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", page.display());
    Ok(())
}

fn check(file: &Path) -> Result<(), String> {
    let recorded = record::read(file)?;
    let machine = machine()?;
    println!("{}, {}", machine.compiler, machine.host);
    if let Some(other) = recorded.iter().find(|record| record.machine.compiler != machine.compiler) {
        println!(
            "the counts are of {}: at most {} % more are let through",
            other.machine.compiler,
            compare::SLACK_ELSEWHERE
        );
    }
    if let Some(other) = recorded.iter().find(|record| record.machine.host != machine.host) {
        println!("the counts in {} are of {}: not checked", file.display(), other.machine.host);
        return Ok(());
    }
    let (lines, worse) = compare::compare(&recorded, &records(&machine, &count_all()?)?);
    lines.iter().for_each(|line| println!("{line}"));
    if worse.is_empty() {
        return Ok(());
    }
    Err(format!(
        "more than {} says; if that is meant, write it anew without --check:\n{}",
        file.display(),
        worse.join("\n")
    ))
}

/// What is counted of each subject, in their order.
fn count_all() -> Result<Vec<Count>, String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    Subject::all().into_par_iter().map(|subject| Count::take(&program, &subject.name())).collect()
}

fn records(machine: &Machine, counts: &[Count]) -> Result<Vec<Record>, String> {
    let record = |(subject, count): (Subject, &Count)| {
        let (machine, rays) = (machine.clone(), counted::rays(subject)?);
        Ok(Record { scene: subject.name(), instructions: count.instructions, rays, machine })
    };
    Subject::all().into_iter().zip(counts).map(record).collect()
}

/// The compiler, and what it compiles for.
fn machine() -> Result<Machine, String> {
    let program = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let text = library::run(Command::new(program).arg("-vV"))?;
    let host =
        text.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc does not say what its host is")?;
    Ok(Machine { compiler: text.lines().next().unwrap_or_default().to_owned(), host: host.to_owned() })
}

fn print_lines(scene: &str) -> Result<(), String> {
    let profile = profile::profile(scene)?;
    for (line, count) in profile.lines().into_iter().take(60) {
        println!("{count:9} {:5.1} %  {line}", 100.0 * count as f64 / profile.instructions() as f64);
    }
    Ok(())
}
