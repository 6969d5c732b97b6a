//! The program `conformance` on every machine.

use crate::cargo;
use crate::engine::interpret;
use crate::library::run;
use crate::target::WASM;

/// What the program prints on a board.
pub fn on_board(target: &str) -> Result<String, String> {
    run(&mut cargo::example("run", "conformance", target, "release"))
}

/// What the program prints on this machine.
pub fn here() -> Result<String, String> {
    run(&mut cargo::example_here("conformance"))
}

/// What the program prints in a WebAssembly engine.
pub fn on_wasm() -> Result<String, String> {
    run(&mut cargo::example("build", "conformance", WASM, "release"))?;
    let file = cargo::program("conformance.wasm", WASM, "release");
    let bytes = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    interpret(&bytes).map_err(|error| format!("{}: {error}", file.display()))
}
