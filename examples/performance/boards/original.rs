//! The business card's own program, `card.cpp`, on the board.

use std::path::PathBuf;
use std::process::Command;

use super::emulator::emulate;
use super::{ORIGINAL, Row, folder, package};
use crate::clock::run;

pub const COMPILER: &str = "arm-none-eabi-g++";

/// The scene that it renders.
pub const SCENE: &str = "card";

/// The flags that the numbers depend on.
pub const FLAGS: [&str; 6] =
    ["-O3", "-fsingle-precision-constant", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"];

const OTHER_FLAGS: [&str; 9] = [
    "-DSINGLE",
    "-DBOARD",
    "-fno-exceptions",
    "-fno-rtti",
    "-ffunction-sections",
    "-fdata-sections",
    "-nostartfiles",
    "--specs=nosys.specs",
    "-Wl,--gc-sections",
];

/// Builds and runs it at a size, one sample a pixel: once to count instructions, and once to count rays, which takes some.
pub fn measure(size: u32) -> Result<Row, String> {
    let said = emulate(&build(size, "card", None)?)?;
    let counted = emulate(&build(size, "card-counted", Some("-DCOUNTED"))?)?;
    if said.checksum()? != counted.checksum()? {
        return Err("card.cpp: the picture differs where rays are counted".to_owned());
    }
    Ok(Row {
        scene: SCENE,
        program: ORIGINAL,
        instructions: said.number("instructions")?,
        rays: counted.number("rays")?,
        pixels: said.number("pixels")?,
        text: said.text,
    })
}

fn build(size: u32, name: &str, flag: Option<&str>) -> Result<PathBuf, String> {
    let program = folder().join(name).with_extension("elf");
    let sources = package().join("examples/performance");
    let mut compiler = Command::new(COMPILER);
    compiler.args(FLAGS).args(OTHER_FLAGS).arg(format!("-DSIZE={size}")).args(["-DSAMPLES=1"]).args(flag);
    compiler.args(["-T", "boards/board.ld", "card.cpp", "boards/start.cpp", "-lm", "-o"]).arg(&program);
    run(compiler.current_dir(sources))?;
    Ok(program)
}
