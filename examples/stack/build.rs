//! Compiles and links programs for bare metal.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::library::{self, Library, Options};

/// A processor without an operating system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    pub name: &'static str,
    pub processor: &'static str,
    /// QEMU's board that has one.
    pub machine: &'static str,
}

pub const TARGETS: [Target; 2] = [
    Target { name: "thumbv7em-none-eabihf", processor: "Cortex-M4F, single-precision FPU", machine: "mps2-an386" },
    Target { name: "thumbv6m-none-eabi", processor: "Cortex-M0, no FPU and no division", machine: "microbit" },
];

/// The compiler's levels of optimisation that are measured.
pub const LEVELS: [&str; 2] = ["3", "s"];

/// Sizes of stack frames, and names of symbols as a stable compiler makes them: their order has a say in the code, and
/// these flags leave not a byte of it changed.
const FLAGS: [&str; 3] = ["-Zemit-stack-sizes", "-Zunstable-options", "-Csymbol-mangling-version=legacy"];

/// For the number types.
const FEATURES: [&str; 2] = ["fixed", "micromath"];

/// The library for one processor at one level of optimisation.
pub struct Toolchain {
    pub target: Target,
    pub level: &'static str,
    library: Library,
    /// Where the compiler has no linker of its own.
    linker: Option<&'static str>,
}

impl Toolchain {
    pub fn new(target: Target, level: &'static str) -> Result<Self, String> {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/target/stack")).join(level);
        let options = Options { target: Some(target.name), level: Some(level), flags: &FLAGS, features: &FEATURES };
        let library = Library::build_with(&folder, options)
            .map_err(|error| format!("is {0} installed? `rustup target add {0}`\n{error}", target.name))?;
        let linker = if has_linker()? { None } else { Some("ld.lld") };
        Ok(Self { target, level, library, linker })
    }

    /// Compiles and links a program as a release would be, except for what the compiler and the linker add to be read.
    pub fn link(&self, name: &str, source: &str) -> Result<PathBuf, String> {
        let script = concat!("-Clink-arg=-T", env!("CARGO_MANIFEST_DIR"), "/examples/stack/firmware.x");
        let level = format!("-Copt-level={}", self.level);
        let mut arguments = vec!["--crate-type", "bin", "-Ccodegen-units=1", &level, script];
        arguments.extend(["-Clink-arg=--gc-sections", "-Clink-arg=--emit-relocs"]);
        arguments.extend(FLAGS);
        let linker = self.linker.map(|linker| format!("-Clinker={linker}"));
        arguments.extend(linker.as_deref());
        self.library.compile(name, source, &arguments)
    }
}

/// Whether the compiler comes with a linker for bare metal.
fn has_linker() -> Result<bool, String> {
    let version = rustc(&["-vV"])?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or_default();
    let sysroot = rustc(&["--print", "sysroot"])?;
    let programs = Path::new(sysroot.trim()).join("lib/rustlib").join(host).join("bin");
    Ok(programs.join(format!("rust-lld{}", std::env::consts::EXE_SUFFIX)).exists())
}

/// The compiler's name and version.
pub fn compiler() -> Result<String, String> {
    Ok(rustc(&["--version"])?.trim().to_owned())
}

fn rustc(arguments: &[&str]) -> Result<String, String> {
    library::run(Command::new(std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned())).args(arguments))
}
