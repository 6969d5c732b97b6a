//! The library, built for a target, and programs that are compiled with it.
//!
//! This file is part of several programs: the tools that look into what the compiler makes of the library, and a test.
#![allow(dead_code)] // None of them needs all of it.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// How the library is compiled.
#[derive(Clone, Copy, Default)]
pub struct Options<'a> {
    /// `None` for the machine at hand.
    pub target: Option<&'static str>,
    /// The compiler's `opt-level`; `None` for that of a release.
    pub level: Option<&'a str>,
    /// Flags of the compiler. Those that begin with `-Z` are unstable, and let through all the same.
    pub flags: &'a [&'a str],
    /// The library's features.
    pub features: &'a [&'a str],
}

/// The library, built for a target, and a folder to work in.
pub struct Library {
    folder: PathBuf,
    /// `None` for the machine at hand.
    pub target: Option<&'static str>,
    /// The crates that a program names, by path: the library, and `core` where cargo has built that too.
    crates: Vec<(String, PathBuf)>,
}

impl Library {
    pub fn build(folder: &Path, target: Option<&'static str>) -> Result<Self, String> {
        Self::build_with(folder, Options { target, ..Options::default() })
    }

    pub fn build_with(folder: &Path, options: Options<'_>) -> Result<Self, String> {
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
        let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
        let mut build = Command::new(cargo);
        build.args(["build", "--quiet", "--release", "--lib", "--no-default-features", "--manifest-path", manifest]);
        build.arg("--message-format=json-render-diagnostics").arg("--target-dir").arg(folder);
        // Flags are for the program at hand, not for the probes.
        build.env_remove("CARGO_ENCODED_RUSTFLAGS").env_remove("RUSTFLAGS");
        if !options.flags.is_empty() {
            build.env("CARGO_ENCODED_RUSTFLAGS", options.flags.join("\x1f"));
        }
        if is_unstable(options.flags) {
            build.env("RUSTC_BOOTSTRAP", "1");
        }
        if let Some(level) = options.level {
            build.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level);
        }
        if let Some(target) = options.target {
            build.args(["--target", target]);
        }
        build.args(options.features.iter().flat_map(|feature| ["--features", *feature]));
        let crates = named_crates(&run(&mut build)?);
        if !crates.iter().any(|(name, _)| name == "whit") {
            return Err("cargo built no library".to_owned());
        }
        Ok(Self { folder: folder.to_owned(), target: options.target, crates })
    }

    /// Compiles a program of one file.
    pub fn compile(&self, name: &str, source: &str, arguments: &[impl AsRef<OsStr>]) -> Result<PathBuf, String> {
        let file = self.folder.join(self.target.unwrap_or_default()).join(name).with_extension("rs");
        let output = file.with_extension("o");
        fs::write(&file, source).map_err(|error| format!("{}: {error}", file.display()))?;
        let mut compile = Command::new(std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned()));
        compile.args(["--edition", "2024", "-C", "panic=abort"]).args(arguments);
        if is_unstable(arguments) {
            compile.env("RUSTC_BOOTSTRAP", "1");
        }
        if let Some(target) = self.target {
            compile.args(["--target", target]);
        }
        for (name, path) in &self.crates {
            compile.arg("--extern").arg(format!("{name}={}", path.display()));
            for folder in [path.parent(), path.parent().map(|folder| folder.join("deps")).as_deref()] {
                compile.arg("-L").arg(format!("dependency={}", folder.unwrap_or(path).display()));
            }
        }
        // Macros that the library's dependencies are compiled with.
        compile.arg("-L").arg(format!("dependency={}", self.folder.join("release/deps").display()));
        run(compile.arg(&file).arg("-o").arg(&output))?;
        Ok(output)
    }
}

fn is_unstable(flags: &[impl AsRef<OsStr>]) -> bool {
    flags.iter().any(|flag| flag.as_ref().to_string_lossy().starts_with("-Z"))
}

/// From cargo's messages, one JSON object a line.
fn named_crates(messages: &str) -> Vec<(String, PathBuf)> {
    let mut crates = Vec::new();
    for message in messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok()) {
        let name = message.pointer("/target/name").and_then(Value::as_str).unwrap_or_default();
        if ["whit", "core", "compiler_builtins"].contains(&name) {
            let files = message.get("filenames").and_then(Value::as_array).into_iter().flatten();
            let libraries = files.filter_map(Value::as_str).filter(|file| file.ends_with(".rlib"));
            crates.extend(libraries.map(|file| (name.to_owned(), file.into())));
        }
    }
    crates
}

/// Runs a command to its end; gives what it printed.
pub fn run(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{:?}: {error}", command.get_program()))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr)))
}
