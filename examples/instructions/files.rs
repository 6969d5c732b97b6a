//! Scene files.

use std::fmt::Display;
use std::path::Path;

use whit::SceneBuf;
use whit::scene::nff;

/// Those of the Standard Procedural Databases in their smaller sizes, in tests/data/nff.
pub const FILES: [&str; 6] =
    ["gears_s1.nff", "mount_s4.nff", "rings_s1.nff", "teapot_s1.nff", "tetra_s3.nff", "tree_s2.nff"];

/// Room for the largest of them.
pub type Stored = SceneBuf<f32, 2048, 8>;

/// Reads a scene file.
pub fn read(path: &Path) -> Result<Box<Stored>, String> {
    let failed = |error: &dyn Display| format!("{}: {error}", path.display());
    let text = std::fs::read(path).map_err(|error| failed(&error))?;
    let mut stored = Box::new(Stored::EMPTY);
    nff::read_bytes(&text, &mut *stored).map_err(|error| failed(&error))?;
    Ok(stored)
}
