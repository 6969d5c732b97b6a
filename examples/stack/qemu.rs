//! Runs a program on an emulated processor.

use std::io::{ErrorKind, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The program that emulates both processors.
pub const EMULATOR: &str = "qemu-system-arm";
const PATIENCE: Duration = Duration::from_secs(120);

/// The number that a program prints; `None` where there is no emulator.
pub fn run(machine: &str, program: &Path) -> Result<Option<u32>, String> {
    let mut command = Command::new(EMULATOR);
    command.args(["-M", machine, "-nographic", "-monitor", "none", "-serial", "none"]);
    command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(program);
    let spawned = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut emulator = match spawned {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        spawned => spawned.map_err(|error| format!("{EMULATOR}: {error}"))?,
    };
    let started = Instant::now();
    let status = loop {
        match emulator.try_wait().map_err(|error| error.to_string())? {
            Some(status) => break status,
            None if started.elapsed() > PATIENCE => {
                let _ = emulator.kill();
                return Err(format!("{} has not ended after {} s", program.display(), PATIENCE.as_secs()));
            }
            None => std::thread::sleep(Duration::from_millis(10)),
        }
    };
    let mut text = String::new();
    if let Some(mut output) = emulator.stderr.take() {
        output.read_to_string(&mut text).map_err(|error| error.to_string())?;
    }
    match text.trim().parse() {
        Ok(number) if status.success() => Ok(Some(number)),
        _ => Err(format!("{} failed in the emulator ({status}): {}", program.display(), text.trim())),
    }
}
