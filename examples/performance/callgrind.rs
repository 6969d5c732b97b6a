//! How often each instruction of a program is executed, by valgrind's callgrind.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::clock::run;

/// By address in the program; `None` for all that lies in shared libraries.
pub type Counts = BTreeMap<Option<u32>, u64>;

/// Runs a program with arguments, the last of which is a file; `None` where there is no valgrind.
pub fn count(program: &Path, arguments: &[&str], last: &Path, listing: &Path) -> Result<Option<Counts>, String> {
    if Command::new("valgrind").arg("--version").output().is_err() {
        return Ok(None);
    }
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--dump-instr=yes", "--dump-line=no"]);
    valgrind.arg(format!("--callgrind-out-file={}", listing.display()));
    run(valgrind.arg(program).args(arguments).arg(last))?;
    let text = fs::read(listing).map_err(|error| format!("{}: {error}", listing.display()))?;
    Ok(Some(read(&String::from_utf8_lossy(&text), program)))
}

/// The format is in valgrind's manual, "Callgrind Format Specification": an address, maybe relative to the last one, and a
/// count; after `calls=` comes what the callee took, which is listed elsewhere.
fn read(text: &str, program: &Path) -> Counts {
    let mut counts = Counts::new();
    let (mut objects, mut is_own) = (BTreeMap::new(), false);
    let (mut address, mut is_call) = (0_u64, false);
    for line in text.lines() {
        if let Some(object) = line.strip_prefix("ob=") {
            // A number, with the name where it is first used.
            let (number, name) = object.split_once(' ').unwrap_or((object, ""));
            let is_program = objects.entry(number.to_owned()).or_insert(Path::new(name) == program);
            is_own = *is_program;
            continue;
        }
        if let Some(object) = line.strip_prefix("cob=").and_then(|object| object.split_once(' ')) {
            objects.entry(object.0.to_owned()).or_insert(Path::new(object.1) == program);
            continue;
        }
        if line.starts_with("calls=") {
            is_call = true;
            continue;
        }
        let Some((place, count)) = line.split_once(' ') else { continue };
        let (Some(place), Ok(count)) = (address_of(place, address), count.parse::<u64>()) else { continue };
        address = place;
        if !std::mem::take(&mut is_call) {
            *counts.entry(is_own.then_some(address as u32)).or_default() += count;
        }
    }
    counts
}

fn address_of(text: &str, last: u64) -> Option<u64> {
    let number = |text: &str| match text.strip_prefix("0x") {
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    match text.as_bytes().first()? {
        b'*' => Some(last),
        b'+' => Some(last.wrapping_add(number(&text[1..])?)),
        b'-' => Some(last.wrapping_sub(number(&text[1..])?)),
        _ => number(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_called_is_counted_once() {
        let text = "version: 1\npositions: instr\nevents: Ir\nsummary: 99\n\nob=(1) /a/program\nfn=(1) one\n0x10 4\n+4 5\n\
                    cob=(2) /lib/c.so\ncfn=(2) two\ncalls=1 0x30\n* 30\n+2 1\n\nob=(2)\nfn=(2)\n0x30 30\n\nob=(1)\n\
                    fn=(3) three\n0x14 100\n-4 1\n";
        let counts = read(text, Path::new("/a/program"));
        assert_eq!(counts, Counts::from([(None, 30), (Some(0x10), 5), (Some(0x14), 105), (Some(0x16), 1)]));
    }
}
