//! Processor time of other programs.

use std::process::{Command, Output};

/// Runs a program to its end. What it printed, and the nanoseconds of processor time that it took.
pub fn run(command: &mut Command) -> Result<(Output, f64), String> {
    let before = of_children()?;
    let output = command.output().map_err(|error| format!("{}: {error}", command.get_program().display()))?;
    let time = of_children()? - before;
    if output.status.success() {
        return Ok((output, time));
    }
    let [said, complained] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
    Err(format!("{command:?}: {}\n{said}{complained}", output.status))
}

/// Of all that have ended.
#[cfg(unix)]
fn of_children() -> Result<f64, String> {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN).map_err(|error| error.to_string())?;
    Ok((usage.user_time() + usage.system_time()).num_nanoseconds() as f64)
}

/// Where there is no such clock, that on the wall.
#[cfg(not(unix))]
fn of_children() -> Result<f64, String> {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    Ok(START.elapsed().as_secs_f64() * 1e9)
}
