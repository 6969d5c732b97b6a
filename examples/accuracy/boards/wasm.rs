//! The example `sweep` in a WebAssembly engine.

use super::cargo;
use super::counted::counted;
use super::engine::interpret;
use super::library;
use super::machine::Machine;
use super::program::Program;

/// What the program prints.
pub fn run(program: &Program) -> Result<String, String> {
    library::run(&mut Machine::Wasm.command("build", program))?;
    let file = cargo::program("sweep.wasm", Machine::Wasm.target(), "release");
    let bytes = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let bytes = counted(&bytes).map_err(|error| format!("{}: {error}", file.display()))?;
    interpret(&bytes).map_err(|error| format!("{}: {error}", file.display()))
}
