//! The example `firmware` for a scene.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::{DEPTH, SIZE, TARGET};
use crate::library::run;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Tells the linker to note of functions that it leaves out that they are nowhere. Else they are at address 0 in the tables
/// of lines, on top of those that are there.
const LINKER: &str = "-Clink-arg=-zdead-reloc-in-nonalloc=.debug_*=0xffffffff";

/// Builds it as a release; gives the program.
pub fn build(scene: &str) -> Result<PathBuf, String> {
    let folder = Path::new(ROOT).join("target/instructions");
    let mut cargo = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    cargo
        .args(["build", "--quiet", "--release", "--example", "firmware", "--target", TARGET, "--target-dir"])
        .arg(&folder);
    cargo.arg("--config").arg(format!("target.{TARGET}.rustflags=['{LINKER}']"));
    // Flags are for the program at hand, and would replace those of the configuration, which is found from the package on.
    cargo.current_dir(ROOT).env_remove("CARGO_ENCODED_RUSTFLAGS").env_remove("RUSTFLAGS");
    cargo.env("WHIT_SCENE", scene).env("WHIT_SIZE", format!("{}x{}", SIZE[0], SIZE[1]));
    cargo.env("WHIT_DEPTH", DEPTH.to_string());
    run(&mut cargo).map_err(|error| format!("is {TARGET} installed? `rustup target add {TARGET}`\n{error}"))?;
    Ok(folder.join(TARGET).join("release/examples/firmware"))
}
