//! What one program is found to be.

use crate::build::Toolchain;
use crate::claims;
use crate::graph::{Graph, Link, Sources};
use crate::image::Image;
use crate::problem::Problem;
use crate::programs::Program;
use crate::qemu;

/// The name of the function that is measured, and of the one with which a program begins.
pub const MEASURED: &str = "step";
const BEGINNING: &str = "reset";

/// What is found of a program.
#[derive(Clone, Debug)]
pub struct Measure {
    pub program: String,
    pub bounces: usize,
    pub target: &'static str,
    pub level: &'static str,
    /// Bytes of the frame, a variable.
    pub frame: u64,
    /// Bytes of stack in the worst case.
    pub stack: u32,
    /// The calls that have it.
    pub chain: Vec<Link>,
    /// Bytes of stack that were used when it ran; `None` where there is no emulator.
    pub seen: Option<u32>,
    pub sources: Sources,
}

/// Builds a program, looks into it, and runs it if that can be done.
pub fn measure(toolchain: &Toolchain, program: &Program) -> Result<Measure, String> {
    let (target, level) = (toolchain.target, toolchain.level);
    let Program { name, bounces, source } = program;
    let place = format!("{name}, {bounces} bounces, {}, opt-level {level}", target.name);
    let letters: String = name.chars().filter(|letter| letter.is_alphanumeric()).collect();
    let file = toolchain.link(&format!("{letters}_{bounces}"), source)?;
    let bytes = std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let image = Image::read(&bytes)?;
    let (stack, chain, sources) = look_into(&image).map_err(|problems| {
        let lines: Vec<String> = problems.iter().map(|problem| format!("\n  {problem}")).collect();
        format!("{place}:{}", lines.concat())
    })?;
    let seen = qemu::run(target.machine, &file)?;
    if let Some(seen) = seen.filter(|&seen| seen > stack) {
        return Err(format!("{place}: {seen} bytes of stack were used, and {stack} are what was computed"));
    }
    let frame = image.variables.get("FRAME").copied().ok_or("there is no frame")?;
    let (program, bounces) = (name.clone(), *bounces);
    Ok(Measure { program, bounces, target: target.name, level, frame, stack, chain, seen, sources })
}

/// The most stack that the measured function takes, the calls that take it, and how the frames of functions are known; or
/// all that is wrong with a program.
pub fn look_into(image: &Image) -> Result<(u32, Vec<Link>, Sources), Vec<Problem>> {
    let unclear = |what| vec![Problem::Unclear { function: MEASURED.to_owned(), address: 0, what }];
    let panics = claims::panics(image, BEGINNING).map_err(unclear)?;
    if !panics.is_empty() {
        return Err(panics); // What comes after the call of one is not to be followed.
    }
    let (mut graph, start) = Graph::from(image, MEASURED).map_err(unclear)?;
    let (stack, chain) = graph.worst(start);
    let mut problems = std::mem::take(&mut graph.problems);
    problems.extend(claims::addresses(image));
    problems.extend(claims::unconfirmed(image, &graph));
    if problems.is_empty() { Ok((stack, chain, graph.sources)) } else { Err(problems) }
}
