//! What the firmware refuses, and says so: what does not fit, what does not exist, and a file that cannot be written.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::cargo::{example, folder};
use crate::library::run;

const TARGET: &str = "thumbv6m-none-eabi";
const OLD_PICTURE: &str = "an older picture";

/// Fails where anything is not refused, or not for its fault.
pub fn check() -> Result<(), String> {
    refused(firmware("build").env("WHIT_SIZE", "5000x100"), "less than 4 KiB of RAM are left for the stack")?;
    refused(firmware("build").env("WHIT_SIZE", "900000x2"), "will not fit in region 'RAM'")?;
    refused(firmware("build").env("WHIT_SIZE", "96"), "WHIT_SIZE: expected for example 64x48")?;
    refused(firmware("build").env("WHIT_DEPTH", "255"), "WHIT_DEPTH: expected at most 254 bounces")?;
    refused(firmware("build").env("WHIT_SCENE", "nothing"), "WHIT_SCENE: there is no built-in scene of that name")?;
    keeps_an_older_picture()
}

/// When the new one cannot be written.
fn keeps_an_older_picture() -> Result<(), String> {
    let files = folder(TARGET).join("target");
    let (picture, unfinished) = (files.join("firmware.ppm"), files.join("firmware.ppm.part"));
    in_the_way(&picture, &unfinished).map_err(|error| format!("{}: {error}", files.display()))?;
    refused(&mut firmware("run"), "error: the file cannot be created")?;
    let kept = fs::read_to_string(&picture).unwrap_or_default() == OLD_PICTURE;
    fs::remove_dir(&unfinished).map_err(|error| format!("{}: {error}", unfinished.display()))?;
    if kept { Ok(()) } else { Err(format!("{} was changed by firmware that failed", picture.display())) }
}

fn in_the_way(picture: &Path, unfinished: &Path) -> std::io::Result<()> {
    fs::write(picture, OLD_PICTURE)?;
    fs::create_dir_all(unfinished)
}

fn firmware(command: &str) -> Command {
    let mut command = example(command, "firmware", TARGET, "release");
    command.env_remove("WHIT_SCENE").env_remove("WHIT_SIZE").env_remove("WHIT_DEPTH");
    command
}

/// Fails unless a command does, and says why.
pub fn refused(command: &mut Command, why: &str) -> Result<(), String> {
    match run(command) {
        Ok(_) => Err(format!("{command:?} ended well; expected: {why}")),
        Err(message) if message.contains(why) => Ok(()),
        Err(message) => Err(format!("expected: {why}; it said:\n{message}")),
    }
}
