//! Writes docs/accuracy.md, what accuracy costs in time, with its charts and all numbers; or picks a setting from them.
//!
//!     cargo run --release --example accuracy
//!     cargo run --release --example accuracy -- --scene glass --max-error 1/64
//!     cargo run --release --example accuracy -- --scene glass --target m4f --max-instructions 100M --size 64x48
#![allow(clippy::indexing_slicing)] // Places are those of the same lists.

#[macro_use]
mod list;

mod agreement;
mod ask;
mod boards;
mod charts;
mod code;
mod conversion;
mod curves;
mod difference;
mod dispatch;
mod formats;
mod frontier;
mod measure;
mod number;
mod number_name;
mod page;
mod picture;
mod processors;
mod record;
#[path = "../../tests/reference/mod.rs"]
mod reference;
mod setting;
mod sweep;
mod targets;
mod tuner;
mod variant;
mod web_json;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use whit::render::{Encoding, Size};
use whit::scenes;

use ask::Question;
use boards::target;
use charts::Cloud;
use measure::{Bench, Measured};
use page::Findings;
use picture::Subject;

/// Writes a page of what accuracy costs in time.
#[derive(Debug, Parser)]
#[command(name = "accuracy")]
struct Arguments {
    /// The page; numbers go into a file of the same name that ends in .csv, charts into `images/accuracy` beside it.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/accuracy.md"))]
    page: PathBuf,
    /// Only these scenes.
    #[arg(long, value_name = "NAME")]
    scene: Vec<String>,
    /// Count no instructions on other targets, but keep those that were counted before.
    #[arg(long)]
    host_only: bool,
    #[command(flatten)]
    question: Question,
}

const SIZE: Size = Size::new(64, 48);

/// The vertical axis of charts.
const ERROR: &str = "error of the picture (RMSE)";

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let numbers = arguments.page.with_extension("csv");
    let done = match arguments.question.wish() {
        Ok(Some(wish)) => arguments.question.answer(wish, &numbers, &arguments.scene),
        Ok(None) => write(&arguments),
        Err(message) => Err(message),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("accuracy: {message}");
            ExitCode::FAILURE
        }
    }
}

fn write(Arguments { page, scene, host_only, .. }: &Arguments) -> Result<(), String> {
    let numbers = page.with_extension("csv");
    let before = if numbers.exists() { record::read(&numbers)? } else { Vec::new() };
    let wanted = |name: &str| scene.is_empty() || scene.iter().any(|wanted| wanted == name);
    let mut findings = Findings { scenes: vec![], depths: vec![], agreements: vec![], formats: vec![], size: SIZE };
    let mut pictures = Vec::new();
    for (name, scene) in scenes::ALL.into_iter().filter(|(name, _)| wanted(name)) {
        findings.agreements.push(agreement::of(name, scene)?);
        let mut bench = Bench::new(Subject::new(name, scene, SIZE))?;
        let depths = bench.depths()?;
        // Of those in which light goes on after one bounce.
        if depths.iter().any(|errors| errors[1] != errors[2]) {
            findings.depths.push((name, depths));
        }
        let mut measured = bench.measure(true)?;
        record::keep_costs(&mut measured.records, &before);
        eprintln!("{name}: {} settings, times within {:.1} %", measured.records.len(), 100.0 * measured.noise);
        if Encoding::of(&scene) == Encoding::Srgb {
            pictures.push(measured.converged.clone());
        }
        findings.scenes.push(measured);
    }
    findings.formats = formats::measure(SIZE, &pictures);
    keep(page, findings, *host_only)
}

fn keep(page: &Path, mut findings: Findings, host_only: bool) -> Result<(), String> {
    let images = page.with_file_name("images").join("accuracy");
    std::fs::create_dir_all(&images).map_err(|error| format!("{}: {error}", images.display()))?;
    for measured in &findings.scenes {
        draw(&images, measured)?;
    }
    charts::depths(&images.join("depth.svg"), &findings.depths)?;
    charts::curves(&images.join("schlick.svg"))?;
    let numbers = page.with_extension("csv");
    write_numbers(&numbers, &findings.scenes)?;
    let mut failures = Vec::new();
    for place in 0..if host_only { 0 } else { findings.scenes.len() } {
        failures.extend(targets::measure(&mut findings.scenes[place].records)?);
        // What takes long to measure is written at once.
        write_numbers(&numbers, &findings.scenes)?;
    }
    for measured in findings.scenes.iter().filter(|measured| processors::are_known(measured)) {
        let chart = images.join(format!("{}-processors.svg", measured.name));
        charts::frontiers(&chart, &processors::lines(measured), "instructions a pixel", ERROR)?;
    }
    web_json::write(&frontier_of_web_page(page), &findings.scenes)?;
    std::fs::write(page, page::page(&findings)).map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", page.display());
    if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
}

fn write_numbers(path: &Path, scenes: &[Measured]) -> Result<(), String> {
    let records: Vec<_> = scenes.iter().flat_map(|measured| measured.records.clone()).collect();
    record::write(path, &records)
}

/// Where the web page looks for it; of another page than the repository's, beside that.
fn frontier_of_web_page(page: &Path) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    if page == root.join("docs/accuracy.md") {
        root.join("examples/web/frontier.json")
    } else {
        page.with_file_name("frontier.json")
    }
}

fn draw(images: &Path, measured: &Measured) -> Result<(), String> {
    let (points, frontier) = (measured.points(), measured.frontier());
    let x = "time, as a ratio to the default";
    let cloud = Cloud { points: &points, frontier: &frontier, default: 0, x, y: ERROR };
    charts::cloud(&images.join(measured.name).with_extension("svg"), &cloud)
}
