//! Writes docs/targets.md, what rendering takes on each processor, and a picture from each beside it; or checks that it takes no more. Both fail where a picture
//! on any of them differs in a bit from the one rendered here, and where firmware does not refuse what it must.
//!
//!     cargo run --release --example targets
//!     cargo run --release --example targets -- --check

mod cargo;
#[path = "../board/checksum.rs"]
mod checksum;
mod conformance;
mod engine;
mod firmware;
#[path = "../stack/function.rs"]
mod function;
#[allow(dead_code)] // Of these the stack's own tool uses more.
#[path = "../stack/graph.rs"]
mod graph;
#[allow(dead_code)]
#[path = "../stack/image.rs"]
mod image;
#[path = "../stack/instruction.rs"]
mod instruction;
#[path = "../effects/library.rs"]
mod library;
#[allow(dead_code)]
#[path = "../stack/names.rs"]
mod names;
mod page;
mod pictures;
#[allow(dead_code)]
#[path = "../stack/problem.rs"]
mod problem;
mod refusals;
mod scene;
mod scene_file;
mod target;
#[path = "../stack/wide.rs"]
mod wide;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Parser;
use firmware::Measure;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use target::{TARGETS, Target, WASM};
use whit::scenes;

/// Writes a page of what rendering takes on each processor, or checks that it takes no more than the page says.
#[derive(Debug, Parser)]
#[command(name = "targets")]
struct Arguments {
    /// The page.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/targets.md"))]
    page: PathBuf,
    /// Compare with the page, and write nothing.
    #[arg(long)]
    check: bool,
}

fn main() -> ExitCode {
    let Arguments { page, check } = Arguments::parse();
    let done = check_all().and_then(|measures| if check { compare(&page, &measures) } else { write(&page, &measures) });
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("targets: {message}");
            ExitCode::FAILURE
        }
    }
}

fn check_all() -> Result<Vec<Measure>, String> {
    check_conformance()?;
    refusals::check()?;
    scene_file::check()?;
    measure_all()
}

/// The program `conformance` prints the same on all machines.
fn check_conformance() -> Result<(), String> {
    let expected = conformance::here()?;
    print!("{expected}");
    let all = TARGETS.iter().map(|target| target.name).chain([WASM]).collect::<Vec<_>>();
    all.into_par_iter().try_for_each(|target| {
        cargo::make_folder(target)?;
        let printed = if target == WASM { conformance::on_wasm()? } else { conformance::on_board(target)? };
        if printed != expected {
            return Err(format!("on {target} the pictures differ from those rendered here; it printed\n{printed}"));
        }
        println!("{target}: the same");
        Ok(())
    })
}

fn measure_all() -> Result<Vec<Measure>, String> {
    let scenes = scenes::ALL.iter().map(|(name, scene)| scene::render(name, scene)).collect::<Result<Vec<_>, _>>()?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}").map_err(|error| error.to_string())?;
    let count = TARGETS.len() * cargo::PROFILES.len() * scenes.len();
    let progress = ProgressBar::new(count as u64).with_style(style);
    // The programs for one target are built in one folder, one after the other.
    let of_target = |target: &Target| -> Result<Vec<Measure>, String> {
        let mut measures = Vec::new();
        for profile in cargo::PROFILES {
            for scene in &scenes {
                progress.set_message(format!("{} on {}", scene.scene, target.short));
                measures.push(firmware::measure(target, profile, scene)?);
                progress.inc(1);
            }
        }
        Ok(measures)
    };
    let measures = TARGETS.par_iter().map(of_target).collect::<Result<Vec<_>, String>>()?;
    progress.finish_and_clear();
    Ok(measures.concat())
}

fn write(page: &Path, measures: &[Measure]) -> Result<(), String> {
    let text = page::page(measures, &compiler()?);
    std::fs::write(page, text).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", page.display());
    pictures::write(&page.with_file_name("images/targets"))
}

fn compare(page: &Path, measures: &[Measure]) -> Result<(), String> {
    let text = std::fs::read_to_string(page).map_err(|error| format!("{}: {error}", page.display()))?;
    let compiler = compiler()?;
    println!("{compiler}");
    let problems = page::compare(&text, measures, &compiler);
    if problems.is_empty() {
        println!("no figure is larger than {} says", page.display());
        return Ok(());
    }
    Err(format!("more than {} says:\n{}", page.display(), problems.join("\n")))
}

/// The compiler's name and version.
fn compiler() -> Result<String, String> {
    let program = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    Ok(library::run(Command::new(program).arg("--version"))?.trim().to_owned())
}
