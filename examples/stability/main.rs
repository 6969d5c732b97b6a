//! Writes docs/stability.md: what breaks ray tracers, with pictures of it, and what is done instead.
//!
//!     cargo run --release --example stability

mod cases;
mod leaving;
mod naive;
mod page;
mod picture;
mod seen;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use page::Page;

/// Writes a page of hard cases and how they are met.
#[derive(Debug, Parser)]
#[command(name = "stability")]
struct Arguments {
    /// The page; its pictures go into `images/stability` beside it.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/stability.md"))]
    page: PathBuf,
}

fn main() -> ExitCode {
    let path = Arguments::parse().page;
    match Page::new(&path).and_then(|mut page| cases::write(&mut page).and_then(|()| page.write())) {
        Ok(()) => {
            println!("{}", path.display());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("stability: {message}");
            ExitCode::FAILURE
        }
    }
}
