//! The program `scene_file` on the smallest board: the same picture as on this machine, and what it says of other files.

use std::path::PathBuf;
use std::process::Command;

use crate::cargo::{ROOT, example, example_here, folder};
use crate::library::run;
use crate::refusals::refused;

const TARGET: &str = "thumbv6m-none-eabi";
const TOO_LARGE: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\nf 1 1 1 1 0 1 0 0\n";

/// Fails where the picture differs, or an error is not told.
pub fn check() -> Result<(), String> {
    let scene = read(PathBuf::from(ROOT).join("examples/scene_file/scene.nff"))?;
    let here = run(&mut on_this_machine(&scene)?)?;
    let there = run(&mut on_board(&scene)?)?;
    if !there.starts_with(&here) {
        return Err(format!("scene_file on {TARGET} printed\n{there}and here\n{here}"));
    }
    refused(&mut on_board(&scene.replace("angle", "angel"))?, "target/scene.nff: line 5: ")?;
    let spheres = format!("{TOO_LARGE}{}", "s 0 0 0 1\n".repeat(9));
    refused(&mut on_board(&spheres)?, "line 17: 9 objects, but there is room for 8")?;
    refused(&mut on_board(&" ".repeat(513))?, "the file is larger than the memory for it")
}

fn read(file: PathBuf) -> Result<String, String> {
    std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))
}

fn on_board(text: &str) -> Result<Command, String> {
    store(text)?;
    Ok(example("run", "scene_file", TARGET, "release"))
}

fn on_this_machine(text: &str) -> Result<Command, String> {
    store(text)?;
    let mut program = example_here("scene_file");
    program.current_dir(folder(TARGET));
    Ok(program)
}

fn store(text: &str) -> Result<(), String> {
    let file = folder(TARGET).join("target/scene.nff");
    std::fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))
}
