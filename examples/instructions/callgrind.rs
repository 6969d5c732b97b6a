//! Counts by Valgrind's Callgrind, which executes a program an instruction at a time.
//!
//! This file is part of two programs: `instructions` and `performance`.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::process::Command;

/// Instructions executed by place in the program, an address or a line as Callgrind is told to note; `None` is all that lies in
/// the libraries of the system.
pub type Counts = BTreeMap<Option<u64>, u64>;

/// Whether Valgrind is there.
#[allow(dead_code)] // The other program cannot do without.
pub fn is_there() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok()
}

/// Runs a program in Callgrind with these options.
pub fn count(options: &[&str], program: &Path, arguments: &[&str]) -> Result<Counts, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let file = folder.path().join("callgrind");
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--quiet", "--tool=callgrind"]).args(options);
    valgrind.arg(format!("--callgrind-out-file={}", file.display())).arg(program).args(arguments);
    let output = valgrind.output().map_err(|error| format!("is Valgrind installed? {error}"))?;
    if !output.status.success() {
        return Err(format!("{valgrind:?}: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let text = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    read(&String::from_utf8_lossy(&text), program)
}

/// The format is in Valgrind's manual, "Callgrind Format Specification": a place, maybe relative to the last one, and a count;
/// after `calls=` comes what the called function took, which is listed elsewhere.
fn read(text: &str, program: &Path) -> Result<Counts, String> {
    if !text.lines().any(|line| line == "events: Ir") {
        return Err("Callgrind counted something else than instructions".to_owned());
    }
    let (mut counts, mut names) = (Counts::new(), HashMap::new());
    let (mut is_own, mut place) = (false, 0);
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let wrong = || format!("Callgrind's file has the line `{line}`");
        let mut cost = |line: &str| {
            let (words, cost) = line.split_once(' ')?;
            place = place_of(words, place)?;
            cost.parse::<u64>().ok()
        };
        if let Some(object) = line.strip_prefix("ob=") {
            is_own = Path::new(name(object, &mut names)) == program;
        } else if let Some(object) = line.strip_prefix("cob=") {
            name(object, &mut names);
        } else if line.starts_with("calls=") {
            lines.next().and_then(cost).ok_or_else(wrong)?;
        } else if line.starts_with(|first: char| first.is_ascii_digit() || "+-*".contains(first)) {
            let cost = cost(line).ok_or_else(wrong)?;
            *counts.entry(is_own.then_some(place)).or_default() += cost;
        }
    }
    Ok(counts)
}

/// `(1) name` gives a name a number, which stands for it from then on.
fn name<'t>(text: &'t str, names: &mut HashMap<&'t str, &'t str>) -> &'t str {
    match text.split_once(' ') {
        Some((number, name)) if number.starts_with('(') => {
            names.insert(number, name);
            name
        }
        _ => names.get(text).copied().unwrap_or(text),
    }
}

fn place_of(text: &str, last: u64) -> Option<u64> {
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
        assert_eq!(counts, Ok(Counts::from([(None, 30), (Some(0x10), 5), (Some(0x14), 105), (Some(0x16), 1)])));
    }

    #[test]
    fn what_cannot_be_read_is_refused() {
        assert!(read("events: Dr\n", Path::new("x")).is_err());
        assert!(read("events: Ir\nob=(1) x\n3 y\n", Path::new("x")).is_err());
    }
}
