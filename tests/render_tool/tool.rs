//! The tool and the folders it is run in.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The tool, built in the profile of the test if it is not there yet.
pub fn tool() -> &'static Path {
    static TOOL: OnceLock<PathBuf> = OnceLock::new();
    TOOL.get_or_init(|| {
        let test = std::env::current_exe().unwrap();
        let folder = test.ancestors().nth(2).unwrap();
        // The profile `dev` is the only one whose folder has another name.
        let profile = if folder.ends_with("debug") { "dev".as_ref() } else { folder.file_name().unwrap() };
        let arguments = ["build", "--example", "render", "--profile"];
        let built = Command::new(env!("CARGO")).args(arguments).arg(profile).status().unwrap();
        assert!(built.success());
        folder.join("examples/render")
    })
}

pub fn run(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(tool()).current_dir(folder).args(arguments).output().unwrap()
}

/// Runs the tool on the words of a line, which has to succeed.
pub fn make_line(folder: &Path, line: &str) {
    let output = run(folder, &line.split(' ').collect::<Vec<_>>());
    assert!(output.status.success(), "{line}: {output:?}");
}

/// A folder of its own with a file from the tests' data.
pub fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/nff/balls_s1.nff");
    std::fs::copy(data, folder.path().join("balls.nff")).unwrap();
    folder
}

pub fn files(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}
