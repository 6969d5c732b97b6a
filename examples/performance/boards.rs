//! Scenes that other ray tracers for microcontrollers are measured by, on an emulated Cortex-M4F.

#[path = "../peers/checksum.rs"]
mod checksum;
mod emulator;
mod firmware;
mod here;
mod original;
#[path = "../peers/scenes/mod.rs"]
mod scenes;
mod text;

use std::path::{Path, PathBuf};

pub use text::section;

/// What one program took for one scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    pub scene: &'static str,
    pub program: &'static str,
    pub instructions: u64,
    /// Shadow rays included.
    pub rays: u64,
    pub pixels: u64,
    /// Bytes of code and constants.
    pub text: u64,
}

impl Row {
    pub fn per_ray(&self) -> u64 {
        self.instructions / self.rays.max(1)
    }

    pub fn per_pixel(&self) -> u64 {
        self.instructions / self.pixels.max(1)
    }
}

const WHIT: &str = "`whit`";
const ORIGINAL: &str = "C++";

/// Builds and runs all programs that this machine has a compiler and an emulator for.
pub fn measure() -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    if !emulator::is_there(emulator::QEMU) {
        return Ok(rows);
    }
    std::fs::create_dir_all(folder().join("target")).map_err(|error| format!("{}: {error}", folder().display()))?;
    for peer in &scenes::ALL {
        rows.push(firmware::measure(peer)?);
        if peer.name == original::SCENE && emulator::is_there(original::COMPILER) {
            rows.push(original::measure(peer.size[0])?);
        }
    }
    Ok(rows)
}

fn package() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where programs are built and run, and where pictures are written.
fn folder() -> PathBuf {
    package().join("target/performance")
}
