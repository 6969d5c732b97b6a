//! Anything: whatever is asked for is refused with an error or renders finite pixels within its budget.
//!
//! Bytes become a scene, a camera, settings and rays ([`generator`]), and what must hold for all of them is checked
//! ([`check`]) in `f32` and `f64`. The fuzzer in `fuzz/` looks on for hours with the same two.
#![cfg(feature = "nff")]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod check;
mod deep;
mod generator;

use std::cell::Cell;

use check::{check_bytes, check_file, check_text};
use generator::Outcome;
use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, any};
use proptest::test_runner::{RngSeed, TestCaseError, TestError, TestRunner};

/// The same cases each time, and no file of failures: a failure that is found goes into `seeds/` by hand.
fn runner(cases: u32) -> TestRunner {
    TestRunner::new(ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1),
        ..Default::default()
    })
}

/// Runs a check over many sequences of bytes and gives the number of those that were rendered.
fn run(name: &str, cases: u32, longest: usize, check: impl Fn(&[u8]) -> Result<Outcome, String>) -> u32 {
    let rendered = Cell::new(0);
    let result = runner(cases).run(&vec(any::<u8>(), 0..longest), |bytes| {
        let outcome = check(&bytes).map_err(TestCaseError::fail)?;
        rendered.set(rendered.get() + u32::from(outcome == Outcome::Rendered));
        Ok(())
    });
    match result {
        Ok(()) => rendered.get(),
        Err(TestError::Fail(fault, bytes)) => {
            let path = format!("{}/{name}", env!("CARGO_TARGET_TMPDIR"));
            std::fs::write(&path, bytes).unwrap();
            panic!("{fault}\nThe bytes are in {path}");
        }
        Err(TestError::Abort(reason)) => panic!("{reason}"),
    }
}

#[test]
fn any_scene_renders_finite_pixels_or_is_refused() {
    let rendered = run("scene", 12_000, 900, check_bytes);
    assert!(rendered > 500, "only {rendered} were rendered");
}

#[test]
fn any_file_renders_finite_pixels_or_is_refused() {
    let rendered = run("file.text", 4000, 400, check_text);
    assert!(rendered > 50, "only {rendered} were rendered");
}

#[test]
fn any_bytes_are_a_file_or_refused() {
    run("file.nff", 8000, 300, check_file);
}

/// Bytes that once showed something wrong; their names say what.
#[test]
fn regressions() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/anything/seeds");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let bytes = std::fs::read(&path).unwrap();
        let check = match path.extension().and_then(|extension| extension.to_str()) {
            Some("nff") => check_file,
            Some("text") => check_text,
            _ => check_bytes,
        };
        if let Err(fault) = check(&bytes) {
            panic!("{}: {fault}", path.display());
        }
        count += 1;
    }
    assert!(count > 0);
}
