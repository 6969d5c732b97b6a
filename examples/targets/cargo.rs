//! Builds and runs examples by cargo, as a user would.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::target::Target;

/// The package.
pub const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// How a program is compiled: the profile, and the level of optimisation that it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Profile {
    pub name: &'static str,
    pub level: &'static str,
}

/// The profiles that are measured: the fast one and the small one.
pub const PROFILES: [Profile; 2] = [Profile { name: "release", level: "3" }, Profile { name: "small", level: "s" }];

/// Where the programs for a target are built and run; the files that they write are in `target/` in there.
pub fn folder(target: &str) -> PathBuf {
    Path::new(ROOT).join("target/targets").join(target)
}

/// `cargo run --example EXAMPLE` for this machine.
pub fn example_here(example: &str) -> Command {
    let mut cargo = cargo("run");
    cargo.args(["--release", "--example", example]);
    cargo.env_remove("CARGO_UNSTABLE_BUILD_STD"); // This machine's library comes with the compiler.
    cargo
}

/// `cargo COMMAND --example EXAMPLE`, in the target's folder. There cargo finds the package's configuration.
pub fn example(command: &str, example: &str, target: &str, profile: &str) -> Command {
    let mut cargo = cargo(command);
    cargo.args(["--example", example, "--target", target, "--profile", profile]);
    cargo.arg("--target-dir").arg(folder(target).join("build"));
    cargo.current_dir(folder(target));
    // Flags are for the program at hand, and would replace those of the configuration.
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS").env_remove("RUSTFLAGS");
    cargo
}

fn cargo(command: &str) -> Command {
    let mut cargo = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    cargo.args([command, "--quiet", "--manifest-path"]).arg(Path::new(ROOT).join("Cargo.toml"));
    cargo
}

/// What tells how much stack a program takes: the sizes of the functions' frames, the calls, and names. They leave the code
/// as it is. The first is unstable.
pub fn with_stack_sizes(cargo: &mut Command, target: &Target) {
    if target.is_arm {
        let flags = r#"["-Zunstable-options", "-Zemit-stack-sizes", "-Csymbol-mangling-version=legacy", "-Clink-arg=--emit-relocs"]"#;
        cargo.arg("--config").arg(format!("target.{}.rustflags={flags}", target.name));
        cargo.args(["--config", "profile.small.strip='none'"]);
        cargo.env("RUSTC_BOOTSTRAP", "1");
    }
}

/// The program that cargo built.
pub fn program(example: &str, target: &str, profile: &str) -> PathBuf {
    folder(target).join("build").join(target).join(profile).join("examples").join(example)
}

/// Makes the folders that programs are run in.
pub fn make_folder(target: &str) -> Result<(), String> {
    let folder = folder(target).join("target");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))
}
