//! The standard output.

use std::io::{ErrorKind, Write, stdout};

/// Prints a line. Whoever stopped reading wants no more of it, and that is no fault.
pub fn print(line: &str) -> Result<(), String> {
    let mut out = stdout().lock();
    match writeln!(out, "{line}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("the standard output: {error}")),
        _ => Ok(()),
    }
}
