//! Runs a program for a Cortex-M4F, and reads what it says.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

use object::{Object, ObjectSection, SectionKind};

use super::folder;
use crate::clock::run;

pub const QEMU: &str = "qemu-system-arm";

/// What a program said of itself, and its bytes of code and constants.
pub struct Said {
    words: HashMap<String, String>,
    pub text: u64,
}

impl Said {
    pub fn number(&self, name: &str) -> Result<u64, String> {
        self.read(name, 10)
    }

    pub fn checksum(&self) -> Result<u64, String> {
        self.read("checksum", 16)
    }

    fn read(&self, name: &str, base: u32) -> Result<u64, String> {
        let word = self.words.get(name).ok_or_else(|| format!("the program said no {name}: {:?}", self.words))?;
        u64::from_str_radix(word, base).map_err(|error| format!("{name} {word}: {error}"))
    }
}

/// Whether there is a program of this name.
pub fn is_there(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok()
}

/// Runs a program; its virtual clock counts instructions.
pub fn emulate(program: &Path) -> Result<Said, String> {
    let mut qemu = Command::new(QEMU);
    qemu.args(["-M", "mps2-an386", "-nographic", "-icount", "shift=0"]);
    qemu.args(["-semihosting-config", "enable=on,target=native", "-kernel"]);
    let (output, _) = run(qemu.arg(program).current_dir(folder()))?;
    let printed = String::from_utf8_lossy(&output.stdout);
    let words = printed.lines().filter_map(|line| line.split_once(' '));
    let words = words.map(|(name, word)| (name.trim_end_matches(':').to_owned(), word.trim().to_owned())).collect();
    let bytes = std::fs::read(program).map_err(|error| format!("{}: {error}", program.display()))?;
    Ok(Said { words, text: text(&bytes).map_err(|error| format!("{}: {error}", program.display()))? })
}

/// Bytes of what is kept in flash.
fn text(bytes: &[u8]) -> object::Result<u64> {
    let in_flash = |kind| {
        matches!(kind, SectionKind::Text | SectionKind::ReadOnlyData | SectionKind::ReadOnlyString | SectionKind::Data)
    };
    let file = object::File::parse(bytes)?;
    Ok(file.sections().filter(|section| in_flash(section.kind())).map(|section| section.size()).sum())
}
