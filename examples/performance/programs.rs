//! The programs that are measured.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::clock::run;

/// The ways in which the library is compiled: a name, flags, and what the page calls it.
pub const BUILDS: [(&str, &str, &str); 2] = [("any", "", "plain"), ("native", "-Ctarget-cpu=native", "native")];

/// The folder for what is built and written, with the library's programs in it.
pub struct Programs {
    folder: PathBuf,
}

const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/performance");

impl Programs {
    /// Builds the library's programs in all ways.
    pub fn build() -> Result<Self, String> {
        let programs = Self { folder: Path::new(env!("CARGO_MANIFEST_DIR")).join("target/performance") };
        for (build, flags, _) in BUILDS {
            eprintln!("building whit: {build}");
            let mut cargo = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
            let manifest = format!("{SOURCES}/measured/Cargo.toml");
            cargo.args(["build", "--quiet", "--release", "--manifest-path", &manifest]);
            cargo.arg("--target-dir").arg(programs.file(build));
            // Flags are for the example, not for what it measures.
            run(cargo.env_remove("RUSTFLAGS").env("CARGO_ENCODED_RUSTFLAGS", flags))?;
        }
        Ok(programs)
    }

    /// A file to write to.
    pub fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The library's programs of a build, to be run with arguments.
    pub fn measured(&self, build: &str) -> Command {
        Command::new(self.file(build).join("release/measured"))
    }

    /// Compiles some of this example's files in C++; `None` where what that needs is not installed.
    pub fn compile(&self, name: &str, sources: &[&str], flags: &[&str]) -> Result<Option<PathBuf>, String> {
        if Command::new("g++").arg("--version").output().is_err() {
            return Ok(None);
        }
        let program = self.file(name);
        let mut compiler = Command::new("g++");
        compiler.args(sources.iter().map(|source| format!("{SOURCES}/{source}"))).arg("-o").arg(&program).args(flags);
        match run(&mut compiler) {
            Ok(_) => Ok(Some(program)),
            Err(problem) if problem.contains("No such file or directory") => Ok(None),
            Err(problem) => Err(problem),
        }
    }
}

/// The numbers that a program prints.
pub fn numbers<const N: usize>(command: &mut Command) -> Result<[f64; N], String> {
    let (output, _) = run(command)?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    numbers.try_into().map_err(|_| format!("{command:?}: expected {N} numbers, not {text}"))
}
