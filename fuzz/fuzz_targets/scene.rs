//! Any scene, any camera, any settings.
#![no_main]

#[path = "../../tests/anything/check/mod.rs"]
#[allow(dead_code)] // Files are another target.
mod check;
#[path = "../../tests/anything/generator/mod.rs"]
#[allow(dead_code)]
mod generator;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Err(fault) = check::check_bytes(bytes) {
        panic!("{fault}");
    }
});
