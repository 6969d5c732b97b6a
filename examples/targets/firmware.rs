//! One scene on one processor: what its firmware takes, and what it renders.

use std::collections::HashMap;
use std::path::Path;

use object::{Object, ObjectSection, SectionKind};

use crate::cargo::{self, Profile};
use crate::graph::Graph;
use crate::image::Image;
use crate::library::run;
use crate::problem::Problem;
use crate::scene::{DEPTH, Rendered, SIZE};
use crate::target::Target;

/// What was measured of the firmware for one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    pub scene: String,
    /// As the compiler calls it.
    pub target: &'static str,
    /// The level of optimisation.
    pub level: &'static str,
    /// Bytes of code and constants.
    pub flash: u64,
    /// Bytes of variables, the state of the picture among them.
    pub memory: u64,
    /// Bytes of stack that rendering used.
    pub stack: u64,
    /// Bytes of stack in the worst case, where that can be worked out.
    pub most_stack: Option<u64>,
    pub instructions: u64,
    pub rays: u64,
}

impl Measure {
    /// Instructions a ray.
    pub fn per_ray(&self) -> u64 {
        self.instructions / self.rays.max(1)
    }

    /// Instructions a pixel.
    pub fn per_pixel(&self) -> u64 {
        self.instructions / SIZE.pixels()
    }
}

/// Builds the firmware for a scene, runs it and compares its picture with the library's on this machine.
pub fn measure(target: &Target, profile: Profile, expected: &Rendered) -> Result<Measure, String> {
    let place = format!("{}, {}, {}", expected.scene, target.name, profile.name);
    let mut command = cargo::example("run", "firmware", target.name, profile.name);
    command.env("WHIT_SCENE", expected.scene).env("WHIT_DEPTH", DEPTH.to_string());
    command.env("WHIT_SIZE", format!("{}x{}", SIZE.width, SIZE.height));
    cargo::with_stack_sizes(&mut command, target);
    let text = run(&mut command).map_err(|error| format!("{place}: {error}"))?;
    let said = Said::read(&text).map_err(|error| format!("{place}: {error}"))?;
    if said.checksum != expected.checksum {
        return Err(format!("{place}: the checksum is {:016x}; expected {:016x}", said.checksum, expected.checksum));
    }
    let picture = cargo::folder(target.name).join("target/firmware.ppm");
    if read(&picture)? != expected.file {
        return Err(format!("{place}: {} differs from the picture rendered here", picture.display()));
    }
    let bytes = read(&cargo::program("firmware", target.name, profile.name))?;
    let (flash, memory) = sizes(&bytes).map_err(|error| format!("{place}: {error}"))?;
    let most_stack =
        if target.is_arm { Some(most_stack(&bytes).map_err(|error| format!("{place}: {error}"))?) } else { None };
    if most_stack.is_some_and(|most| said.stack > most) {
        return Err(format!("{place}: {} bytes of stack were used, and at most {most_stack:?} expected", said.stack));
    }
    Ok(Measure {
        scene: expected.scene.to_owned(),
        target: target.name,
        level: profile.level,
        flash,
        memory,
        stack: said.stack,
        most_stack,
        instructions: said.instructions,
        rays: expected.rays,
    })
}

fn read(file: &Path) -> Result<Vec<u8>, String> {
    std::fs::read(file).map_err(|error| format!("{}: {error}", file.display()))
}

/// What the firmware prints.
struct Said {
    checksum: u64,
    stack: u64,
    instructions: u64,
}

impl Said {
    fn read(text: &str) -> Result<Self, String> {
        let words: HashMap<&str, &str> = text.lines().filter_map(|line| line.split_once(' ')).collect();
        let number = |name, base| {
            let word = words.get(name).ok_or_else(|| format!("it printed no {name}: {text:?}"))?;
            u64::from_str_radix(word.trim(), base).map_err(|error| format!("{name} {word}: {error}"))
        };
        Ok(Self {
            checksum: number("checksum", 16)?,
            stack: number("stack", 10)?,
            instructions: number("instructions", 10)?,
        })
    }
}

/// Bytes of flash and of memory. The stack's memory is no section on Arm, and one of its own on RISC-V.
fn sizes(bytes: &[u8]) -> object::Result<(u64, u64)> {
    let file = object::File::parse(bytes)?;
    let (mut flash, mut memory) = (0, 0);
    for section in file.sections() {
        match section.kind() {
            SectionKind::Text | SectionKind::ReadOnlyData | SectionKind::ReadOnlyString => flash += section.size(),
            SectionKind::Data => {
                flash += section.size(); // Its first contents.
                memory += section.size();
            }
            SectionKind::UninitializedData if section.name() != Ok(".stack") => memory += section.size(),
            _ => {}
        }
    }
    Ok((flash, memory))
}

/// The most stack that the function `draw_row` takes, by the same reading of the machine code as in docs/stack.md.
fn most_stack(bytes: &[u8]) -> Result<u64, String> {
    let image = Image::read(bytes)?;
    let (mut graph, start) = Graph::from(&image, "draw_row")?;
    let (most, _) = graph.worst(start);
    // What stops the processor takes no more stack; that nothing of the library does so is shown elsewhere.
    let unclear = graph.problems.iter().filter(|problem| !matches!(problem, Problem::Trap { .. }));
    let unclear: Vec<String> = unclear.map(ToString::to_string).collect();
    if unclear.is_empty() { Ok(u64::from(most)) } else { Err(unclear.join("\n")) }
}
