//! Pictures by POV-Ray.

use std::path::Path;
use std::process::Command;

use crate::clock::run;

/// The version, where there is the program.
pub fn version() -> Option<String> {
    let output = Command::new("povray").arg("--version").output().ok()?;
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    text.lines().find(|line| line.starts_with("POV-Ray ")).map(str::to_owned)
}

/// Traces a scene on one thread, one ray through the middle of each pixel. How many rays there were, and the nanoseconds of
/// processor time that tracing took without reading the scene, both by POV-Ray's own statistics.
pub fn trace(scene: &Path, picture: &Path, size: u32) -> Result<(f64, f64), String> {
    let mut povray = Command::new("povray");
    povray.arg(format!("+I{}", scene.display())).arg(format!("+O{}", picture.display()));
    povray.args([format!("+W{size}"), format!("+H{size}")]);
    let (output, _) = run(povray.args(["+FP", "-A", "-D", "+WT1", "+MB1"]))?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let after = |what: &str| -> Option<f64> {
        let (_, rest) = text.rsplit_once(what)?;
        rest.split_whitespace().next()?.parse().ok()
    };
    let traced = || {
        let (_, times) = text.rsplit_once("Trace Time:")?;
        let seconds: f64 = times.split_once("thread(s) with")?.1.split_whitespace().next()?.parse().ok()?;
        Some((after("\nRays:")? + after("Shadow Ray Tests:")?, seconds * 1e9))
    };
    traced().ok_or_else(|| format!("POV-Ray's statistics were not understood: {text}"))
}
