//! What settings cost on small processors: the instructions a pixel that the example `sweep` takes on each of them.
//!
//! The program that this is a part of has `use boards::target;` beside `mod boards;`.

#[allow(dead_code)] // The page of targets uses more of it.
#[path = "../../targets/cargo.rs"]
mod cargo;
mod counted;
#[path = "../../targets/engine.rs"]
mod engine;
#[path = "../../effects/library.rs"]
mod library;
mod machine;
mod program;
mod said;
#[allow(dead_code)]
#[path = "../../targets/target.rs"]
pub mod target;
mod wasm;

pub use machine::{MACHINES, Machine};
pub use program::{Model, Program};
pub use said::{Cost, Run};

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

/// What one program took on one machine, run by run; or why it cannot be had, as where a scene is out of a number type's range.
pub struct Measured {
    pub machine: Machine,
    pub program: Program,
    pub costs: Result<Vec<Cost>, String>,
}

/// Builds a program for a machine and runs it there.
pub fn measure(machine: Machine, program: &Program) -> Result<Vec<Cost>, String> {
    cargo::make_folder(machine.target())?;
    let text = match machine {
        Machine::Wasm => wasm::run(program)?,
        _ => library::run(&mut machine.command("run", program))?,
    };
    said::read(&text, program)
}

/// Measures programs on machines, in order, and fails where the pictures of a program differ between machines. The programs for a
/// machine are built in one folder, one after the other, and those of different machines at the same time.
pub fn measure_all(programs: &[(Machine, Program)]) -> Result<Vec<Measured>, String> {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}").map_err(|error| error.to_string())?;
    let progress = ProgressBar::new(programs.len() as u64).with_style(style);
    let on = |machine: &Machine| -> Vec<(usize, Measured)> {
        let of_machine = programs.iter().enumerate().filter(|(_, (its, _))| its == machine);
        of_machine
            .map(|(place, (machine, program))| {
                progress.set_message(format!("{} in {} on {machine:?}", program.scene, program.number));
                let costs = measure(*machine, program);
                progress.inc(1);
                (place, Measured { machine: *machine, program: program.clone(), costs })
            })
            .collect()
    };
    let mut measured: Vec<_> = MACHINES.par_iter().with_max_len(1).flat_map_iter(on).collect();
    progress.finish_and_clear();
    measured.sort_by_key(|(place, _)| *place);
    let measured: Vec<Measured> = measured.into_iter().map(|(_, measured)| measured).collect();
    agree(&measured)?;
    Ok(measured)
}

/// Fails where two machines give other pictures of one program.
fn agree(measured: &[Measured]) -> Result<(), String> {
    for (place, one) in measured.iter().enumerate() {
        let others = measured.iter().skip(place + 1).filter(|other| other.program == one.program);
        for other in others {
            let (Ok(one_costs), Ok(other_costs)) = (&one.costs, &other.costs) else { continue };
            if let Some((cost, _)) = one_costs.iter().zip(other_costs).find(|(a, b)| a.checksum != b.checksum) {
                let Program { scene, number, .. } = &one.program;
                let (one, other) = (one.machine, other.machine);
                return Err(format!("{scene} in {number}, {}: {one:?} and {other:?} give other pictures", cost.run));
            }
        }
    }
    Ok(())
}
