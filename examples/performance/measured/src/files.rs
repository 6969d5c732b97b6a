//! What is written.

use std::fs;
use std::path::Path;

pub fn write(file: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(file, bytes).map_err(|error| format!("{}: {error}", file.display()))
}

/// A square picture of three bytes a pixel, as PPM.
pub fn write_picture(file: &Path, side: u32, bytes: &[u8]) -> Result<(), String> {
    let mut whole = format!("P6\n{side} {side}\n255\n").into_bytes();
    whole.extend(bytes);
    write(file, &whole)
}
