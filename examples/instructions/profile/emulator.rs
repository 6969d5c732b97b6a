//! Runs firmware an instruction at a time.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use super::BOARD;
use crate::library;

const EMULATOR: &str = "qemu-system-arm";
/// Bytes of the instruction that calls a function by its place.
const CALL: u32 = 4;

/// How often the instruction at each address is executed, from each call of the function at `start` to its return.
pub fn run(program: &Path, start: u32) -> Result<BTreeMap<u32, u64>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    std::fs::create_dir(folder.path().join("target")).map_err(|error| error.to_string())?; // For the picture.
    let mut emulator = Command::new(EMULATOR);
    emulator.args(["-M", BOARD, "-nographic", "-monitor", "none", "-serial", "none", "-icount", "shift=0"]);
    emulator.args(["-semihosting-config", "enable=on,target=native", "-d", "exec,nochain"]);
    emulator.args(one_at_a_time()?).arg("-kernel").arg(program).current_dir(folder.path());
    emulator.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut emulator = emulator.spawn().map_err(|error| format!("{EMULATOR}: {error}"))?;
    let log = emulator.stderr.take().ok_or("the emulator writes no log")?;
    let log = read(BufReader::with_capacity(1 << 20, log), start);
    if log.is_err() {
        let _ = emulator.kill();
    }
    // What the firmware prints is a few lines, for which the pipe has room.
    let output = emulator.wait_with_output().map_err(|error| error.to_string())?;
    let (Log { executed, all }, said) = (log?, String::from_utf8_lossy(&output.stdout));
    if !output.status.success() {
        return Err(format!("the firmware failed ({}): {said}", output.status));
    }
    all_counted(all, &said)?;
    Ok(executed)
}

/// What makes QEMU translate each instruction by itself: since version 8.1, a property.
fn one_at_a_time() -> Result<&'static [&'static str], String> {
    let text = library::run(Command::new(EMULATOR).arg("--version"))?;
    let version = text.split("version ").nth(1).unwrap_or_default();
    let mut numbers =
        version.split(|letter: char| !letter.is_ascii_digit()).map_while(|number| number.parse::<u32>().ok());
    let version = numbers.next().zip(numbers.next()).ok_or_else(|| format!("{EMULATOR} has no version: {text}"))?;
    Ok(if version >= (8, 1) { &["-accel", "tcg,one-insn-per-tb=on"] } else { &["-singlestep"] })
}

#[derive(Default)]
struct Log {
    executed: BTreeMap<u32, u64>,
    /// Instructions of the whole program.
    all: u64,
}

/// The beginnings of lines that say that the instruction of the line before was not executed after all; it comes again.
const UNDONE: [&str; 2] = ["Stopped execution of TB chain before ", "cpu_io_recompile: rewound execution of TB to "];

fn read(mut lines: impl BufRead, start: u32) -> Result<Log, String> {
    let mut log = Log::default();
    let (mut line, mut before, mut return_to) = (Vec::new(), 0, None);
    while lines.read_until(b'\n', &mut line).map_err(|error| error.to_string())? > 0 {
        let text = String::from_utf8_lossy(&line);
        if let Some(rest) = text.strip_prefix("Trace ") {
            let address = address(rest).ok_or_else(|| format!("the emulator's log has the line `{}`", text.trim()))?;
            log.all += 1;
            match return_to {
                None if address == start => return_to = Some(before + CALL),
                Some(place) if address == place => return_to = None,
                _ => {}
            }
            if return_to.is_some() {
                *log.executed.entry(address).or_default() += 1;
            }
            before = address;
        } else if UNDONE.iter().any(|undone| text.starts_with(undone)) {
            log.all -= 1;
            if return_to.is_some() {
                log.executed.entry(before).and_modify(|count| *count -= 1);
            }
        }
        line.clear();
    }
    Ok(log)
}

/// Of `0: 0x7f5c88000100 [00000000/00000a54/00000110/ff000000] draw_row` the second in brackets.
fn address(line: &str) -> Option<u32> {
    let (_, state) = line.split_once('[')?;
    u32::from_str_radix(state.split('/').nth(1)?, 16).ok()
}

/// That the log is of all instructions: the firmware's own clock counts nearly as many, all but a start and an end.
fn all_counted(all: u64, said: &str) -> Result<(), String> {
    let clock = said.lines().find_map(|line| line.strip_prefix("instructions ")?.parse::<u64>().ok());
    let clock = clock.ok_or_else(|| format!("the firmware printed no count of instructions: {said}"))?;
    if all < clock || all > clock + clock / 20 {
        return Err(format!("the emulator's log is of {all} instructions, and the firmware counts {clock}"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_called_is_counted() {
        let line = |address: u32| format!("Trace 0: 0x7f00 [00000000/{address:08x}/00000110/ff000000] name\n");
        let undone = "Stopped execution of TB chain before 0x7f00 [00000066] name\n";
        let once = [10, 14, 100, 200, 102].map(line).concat() + undone + &[102, 18].map(line).concat();
        let log = read(format!("{once}{once}").as_bytes(), 100).unwrap();
        assert_eq!(log.executed, BTreeMap::from([(100, 2), (102, 2), (200, 2)]));
        assert_eq!(log.all, 12);
        assert!(read("Trace nothing\n".as_bytes(), 100).is_err());
    }

    #[test]
    fn a_log_agrees_with_a_clock() {
        let said = "checksum 0\ninstructions 100\n";
        assert!(all_counted(100, said).is_ok() && all_counted(105, said).is_ok());
        assert!(all_counted(99, said).is_err() && all_counted(106, said).is_err() && all_counted(100, "").is_err());
    }
}
