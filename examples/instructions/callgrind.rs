//! Counts by Valgrind's Callgrind, which executes a program an instruction at a time.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

use crate::counted::FUNCTION;
use crate::library::run;

/// What is counted of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// In the program itself.
    pub instructions: u64,
    /// In the libraries of the system, which has other copies of `memcpy` for other processors.
    pub elsewhere: u64,
}

/// Runs a program on a subject, and counts from where [`FUNCTION`] begins to where it ends.
pub fn count(program: &Path, subject: &str) -> Result<Count, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let file = folder.path().join("callgrind");
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--quiet", "--tool=callgrind", "--collect-atstart=no"]);
    valgrind.arg(format!("--toggle-collect={FUNCTION}"));
    valgrind.arg(format!("--callgrind-out-file={}", file.display()));
    valgrind.arg(program).args(["--run", subject]);
    run(&mut valgrind).map_err(|error| format!("is Valgrind installed? {error}"))?;
    let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let count = read(&text, &program.display().to_string()).map_err(|error| format!("`{subject}`: {error}"))?;
    if count.instructions == 0 { Err(format!("`{subject}`: nothing was counted")) } else { Ok(count) }
}

/// Sums what each function took itself. The format is in Valgrind's manual, "Callgrind Format Specification".
fn read(text: &str, program: &str) -> Result<Count, String> {
    if !text.lines().any(|line| line == "events: Ir") {
        return Err("Callgrind counted something else than instructions".to_owned());
    }
    let mut names = HashMap::new();
    let mut count = Count { instructions: 0, elsewhere: 0 };
    let mut is_own = false;
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if let Some(object) = line.strip_prefix("ob=") {
            is_own = name(object, &mut names) == program;
        } else if let Some(object) = line.strip_prefix("cob=") {
            name(object, &mut names);
        } else if line.starts_with("calls=") {
            lines.next(); // What the called function took.
        } else if line.starts_with(|first: char| first.is_ascii_digit() || "+-*".contains(first)) {
            let cost = line.rsplit(' ').next().and_then(|cost| cost.parse::<u64>().ok());
            let cost = cost.ok_or_else(|| format!("Callgrind's file has the line `{line}`"))?;
            *if is_own { &mut count.instructions } else { &mut count.elsewhere } += cost;
        }
    }
    Ok(count)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_a_program_and_of_libraries() {
        let text = "version: 1\nevents: Ir\n\nob=(1) /a/program\nfl=(1) one.rs\nfn=(1) counted\n3 4\ncob=(2) /lib/c.so\n\
                    cfn=(2) memcpy\ncalls=1 0\n+1 30\n* 5\n\nob=(2)\nfn=(2)\n0 30\n\nob=(1)\nfn=(3) other\n-7 100\n";
        assert_eq!(read(text, "/a/program"), Ok(Count { instructions: 109, elsewhere: 30 }));
        assert!(read("events: Dr\n", "/a/program").is_err());
        assert!(read("events: Ir\nob=(1) x\n3 y\n", "x").is_err());
    }
}
