//! Any bytes as a file, and files that look like ones.
#![no_main]

#[path = "../../tests/anything/check/mod.rs"]
#[allow(dead_code)] // Scenes are another target.
mod check;
#[path = "../../tests/anything/generator/mod.rs"]
#[allow(dead_code)]
mod generator;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    // The first byte says whether the others are the file, or the numbers and choices that make one.
    let result = match bytes.split_first() {
        Some((0..128, choices)) => check::check_text(choices),
        Some((_, file)) => check::check_file(file),
        None => check::check_file(bytes),
    };
    if let Err(fault) = result {
        panic!("{fault}");
    }
});
