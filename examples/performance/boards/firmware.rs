//! The example `peers` on the board.

use std::process::Command;

use super::emulator::emulate;
use super::scenes::Peer;
use super::{Row, WHIT, folder, here, package};
use crate::clock::run;

const TARGET: &str = "thumbv7em-none-eabihf";

/// Builds and runs it for a scene, and compares its picture with that of this machine, which is written as a PNG file. As in the
/// other tracers, no branch is cut for its weight.
pub fn measure(peer: &Peer) -> Result<Row, String> {
    let rendered = here::render(peer)?;
    rendered.save(&folder().join(peer.name).with_extension("png"))?;
    let build = folder().join("build");
    let mut cargo = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    cargo.args(["build", "--quiet", "--release", "--example", "peers", "--target", TARGET, "--target-dir"]).arg(&build);
    cargo.env("WHIT_SCENE", peer.name).env("WHIT_CUTOFF", "0").env_remove("WHIT_COUNT").current_dir(package());
    // Flags are for the program at hand, and would replace those of the configuration.
    run(cargo.env_remove("CARGO_ENCODED_RUSTFLAGS").env_remove("RUSTFLAGS"))?;
    let said = emulate(&build.join(TARGET).join("release/examples/peers"))?;
    if said.checksum()? != rendered.checksum() {
        return Err(format!("{}: the board's picture differs from the one rendered here", peer.name));
    }
    Ok(Row {
        scene: peer.name,
        program: WHIT,
        instructions: said.number("instructions")?,
        rays: rendered.rays,
        pixels: said.number("pixels")?,
        text: said.text,
    })
}
