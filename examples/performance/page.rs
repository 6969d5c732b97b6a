//! The page docs/performance.md.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::povray;
use crate::section::Section;

/// Where the page and its pictures are written.
pub struct Page {
    path: PathBuf,
    pub images: PathBuf,
}

const HEAD: &str = "\
# How fast it is

Speed comes second to the other promises, and this page says what is left of it. All programs of a table ran in turn in
one run, each many times; numbers are medians, and with a ratio, which is taken in each round, come its quartiles. Times
are processor time on one thread, unless they are about threads.

    apt-get install g++ povray libembree-dev valgrind
    apt-get install qemu-system-arm gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib
    rustup target add thumbv7em-none-eabihf
    cargo run --release --example performance

writes this page; a peer that is not there is left out. whit is built in two ways, with the same bits in its pictures: plain, for
any processor of the architecture, and native, with `-C target-cpu=native`, for all that the one at hand can do.
";

impl Page {
    pub fn new(path: &Path) -> Result<Self, String> {
        let images = path.parent().unwrap_or(Path::new("")).join("images/performance");
        fs::create_dir_all(&images).map_err(|error| format!("{}: {error}", images.display()))?;
        Ok(Self { path: path.to_owned(), images })
    }

    pub fn write(&self, sections: &[Section]) -> Result<(), String> {
        let mut text = HEAD.to_owned();
        let _ = writeln!(text, "\nHere: {}.", tools().join("; "));
        text += "\n| aim | | measured | reached |\n|---|---|---|---|\n";
        for aim in sections.iter().flat_map(|section| &section.aims) {
            let _ = writeln!(text, "{aim}");
        }
        sections.iter().for_each(|section| text += &section.text);
        fs::write(&self.path, text).map_err(|error| format!("{}: {error}", self.path.display()))
    }
}

/// What was measured with.
fn tools() -> Vec<String> {
    let version = |program: &str, argument: &str| {
        let output = Command::new(program).arg(argument).output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).lines().next()?.trim().to_owned())
    };
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let rustc = version(&rustc, "--version").map(|text| text.split(" (").next().unwrap_or_default().to_owned());
    let gcc = version("g++", "-dumpfullversion").map(|version| format!("g++ {version}"));
    [Some(processor()), rustc, gcc, povray::version()].into_iter().flatten().collect()
}

/// The architecture, and the widest vectors that it has.
fn processor() -> String {
    #[cfg(target_arch = "x86_64")]
    let vectors = match () {
        () if is_x86_feature_detected!("avx512f") => " with AVX-512",
        () if is_x86_feature_detected!("avx2") => " with AVX2",
        () => "",
    };
    #[cfg(not(target_arch = "x86_64"))]
    let vectors = "";
    format!("a processor of {}{vectors}", std::env::consts::ARCH)
}
