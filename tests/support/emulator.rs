//! Examples on emulated boards.
//!
//! Where QEMU or the compiler's library for a board is not installed, the tests that need them say so and do nothing;
//! with WHIT_BOARDS=required they fail.

use std::io::{BufRead, BufReader, PipeReader, Write};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// For a board that is emulated on a machine with much else to do.
const PATIENCE: Duration = Duration::from_secs(300);

/// Whether programs for a target can be built, and run in that QEMU.
pub fn is_installed(target: &str, qemu: &str) -> bool {
    let missing = if !has_library(target) {
        format!("the compiler's library for {target} is not installed; `rustup target add {target}`")
    } else if Command::new(qemu).arg("--version").output().is_err() {
        format!("{qemu} is not installed")
    } else {
        return true;
    };
    assert!(std::env::var("WHIT_BOARDS").is_err(), "{missing}, and WHIT_BOARDS says that it is required");
    // Not held back, as `eprintln!` is while a test passes.
    std::io::stderr().write_all(format!("not tested: {missing}\n").as_bytes()).unwrap();
    false
}

fn has_library(target: &str) -> bool {
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let output = Command::new(compiler).args(["--print", "target-libdir", "--target", target]).output().unwrap();
    let folder = String::from_utf8(output.stdout).unwrap();
    let mut files = std::fs::read_dir(folder.trim()).into_iter().flatten();
    files.any(|file| file.unwrap().file_name().to_string_lossy().starts_with("libcore-"))
}

/// An example, built for a target.
pub fn build(example: &str, target: &str, more: &[&str]) -> PathBuf {
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--message-format=json-render-diagnostics"])
        .args(["--example", example, "--target", target])
        .args(more)
        .env_remove("RUSTFLAGS") // They are meant for the machine at hand, and would be in place of those for the board.
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .stderr(Stdio::inherit())
        .output()
        .unwrap();
    assert!(output.status.success(), "{example} cannot be built for {target}");
    let messages = output.stdout.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
    let mut files = messages.filter_map(|line| {
        let message: serde_json::Value = serde_json::from_slice(line).unwrap();
        message["executable"].as_str().map(PathBuf::from)
    });
    files.next_back().expect("cargo names the file that it built")
}

/// A running QEMU, which ends with this value.
pub struct Emulator {
    process: Child,
    lines: Receiver<String>,
}

impl Emulator {
    /// Starts QEMU.
    pub fn start(command: &mut Command) -> Self {
        let (reader, writer) = std::io::pipe().unwrap();
        // Versions differ in where the text from a board goes.
        let command = command.stdin(Stdio::null()).stdout(writer.try_clone().unwrap()).stderr(writer);
        let process = command.spawn().unwrap();
        command.stdout(Stdio::null()).stderr(Stdio::null()); // Closes this side's ends of the pipe.
        Self { process, lines: lines_of(reader) }
    }

    /// The lines of text up to and with the first that `is_last`, or up to the end of QEMU.
    pub fn lines_until(&self, is_last: impl Fn(&str) -> bool) -> Vec<String> {
        let mut lines = Vec::new();
        loop {
            match self.lines.recv_timeout(PATIENCE) {
                Ok(line) => lines.push(line),
                Err(RecvTimeoutError::Disconnected) => return lines,
                Err(RecvTimeoutError::Timeout) => panic!("nothing more came after {lines:#?}"),
            }
            if lines.last().is_some_and(|line| is_last(line)) {
                return lines;
            }
        }
    }
}

impl Drop for Emulator {
    fn drop(&mut self) {
        let _ = self.process.kill(); // It may have ended.
        let _ = self.process.wait();
    }
}

fn lines_of(reader: PipeReader) -> Receiver<String> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        for line in BufReader::new(reader).lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                return; // Nobody listens any more.
            }
        }
    });
    receiver
}
