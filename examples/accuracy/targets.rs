//! The costs of settings on other targets: instructions a pixel, as columns of the records.

use std::collections::BTreeMap;

use whit::Termination;
use whit::render::Sampling;
use whit::scene::Fresnel;

use crate::boards::{self, MACHINES, Machine, Model, Program, Run};
use crate::number_name::NumberName;
use crate::record::Record;
use crate::setting::{Path, Setting, SpectrumName};

/// The name of a machine's column, and of `--target`.
pub const fn column(machine: Machine) -> &'static str {
    match machine {
        Machine::M4F => "m4f",
        Machine::M0 => "m0",
        Machine::RV32 => "rv32",
        Machine::Wasm => "wasm",
    }
}

/// Measures what can be measured there, and writes it into the records.
///
/// # Errors
/// Why a program cannot be built or run, and where machines give other pictures.
pub fn measure(records: &mut [Record]) -> Result<(), String> {
    let mut places: BTreeMap<String, (Program, Vec<usize>)> = BTreeMap::new();
    for (place, record) in records.iter().enumerate().filter(|(_, record)| is_measured(&record.setting)) {
        let key = format!("{} {}", record.scene, Setting { depth: 0, cutoff: 0.0, ..record.setting });
        let (program, of_program) = places.entry(key).or_insert_with(|| (program(record), Vec::new()));
        program.runs.push(run(&record.setting));
        of_program.push(place);
    }
    let (programs, places): (Vec<_>, Vec<_>) = places.into_values().unzip();
    let wanted: Vec<_> =
        programs.iter().flat_map(|program| MACHINES.map(|machine| (machine, program.clone()))).collect();
    let measured = boards::measure_all(&wanted)?;
    for (of_program, measured) in places.iter().zip(measured.chunks(MACHINES.len())) {
        for measured in measured {
            let costs = measured.costs.as_ref().map_err(|error| {
                let (program, machine) = (&measured.program, measured.machine);
                format!("{} in {} on {machine:?}: {error}", program.scene, program.number)
            })?;
            for (place, cost) in of_program.iter().zip(costs) {
                if let Some(record) = records.get_mut(*place) {
                    record.costs.insert(column(measured.machine).to_owned(), cost.per_pixel);
                }
            }
        }
    }
    Ok(())
}

/// One sample a pixel, and the number types that firmware is written in.
fn is_measured(setting: &Setting) -> bool {
    let has_number = matches!(setting.number, NumberName::F32 | NumberName::Fast | NumberName::Q16 | NumberName::Q20);
    has_number
        && setting.sampling == Sampling::Grid(1)
        && setting.termination == Termination::Background
        && [1, 2, 3, 5, 8].contains(&setting.depth)
        && (setting.cutoff == 0.0 || setting.cutoff == 1.0 / 255.0)
}

fn program(record: &Record) -> Program {
    let setting = &record.setting;
    let mut models = Vec::new();
    if setting.fresnel == Fresnel::Schlick {
        models.push(Model::SchlickFresnel);
    }
    match setting.spectrum {
        SpectrumName::Own => {}
        SpectrumName::Wavelengths => models.push(Model::Wavelengths),
        SpectrumName::Bands(count) => models.push(Model::Bands(count)),
        SpectrumName::Table => models.push(Model::Table),
    }
    match setting.path {
        Path::Own => {}
        Path::Fixed(length) => models.push(Model::StepLength(length)),
        Path::Controlled(tolerance) => models.push(Model::Tolerance(tolerance)),
    }
    // A slow processor takes some seconds for as many pixels.
    let size = match record.scene.as_str() {
        "mirage" | "ship" | "sunset" | "lenses" | "hole" => [8, 6],
        _ => [16, 12],
    };
    Program { scene: record.scene.clone(), number: setting.number.to_string(), models, size, runs: Vec::new() }
}

fn run(setting: &Setting) -> Run {
    Run { depth: setting.depth, cutoff: setting.cutoff, termination: "background".to_owned(), samples: 1 }
}
