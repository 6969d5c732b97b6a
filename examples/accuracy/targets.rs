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

/// Measures what can be measured there, and writes it into the records. Tells which programs could not be built or run, and why.
///
/// # Errors
/// Where machines give other pictures.
pub fn measure(records: &mut [Record]) -> Result<Vec<String>, String> {
    let mut places: BTreeMap<String, (Program, Vec<usize>)> = BTreeMap::new();
    for (place, record) in records.iter().enumerate().filter(|(_, record)| is_measured(&record.setting)) {
        let of_one_sample = record.setting.sampling == Sampling::Grid(1);
        let sampling = if of_one_sample { Sampling::Grid(1) } else { Sampling::Sequence(4) };
        let key = Setting { depth: 0, cutoff: 0.0, sampling, ..record.setting };
        let key = format!("{} {key}", record.scene);
        let (program, of_program) = places.entry(key).or_insert_with(|| (program(record), Vec::new()));
        program.runs.push(run(&record.setting));
        of_program.push(place);
    }
    let (programs, places): (Vec<_>, Vec<_>) = places.into_values().unzip();
    let wanted: Vec<_> =
        programs.iter().flat_map(|program| MACHINES.map(|machine| (machine, program.clone()))).collect();
    let measured = boards::measure_all(&wanted)?;
    let mut failures = Vec::new();
    for (of_program, measured) in places.iter().zip(measured.chunks(MACHINES.len())) {
        for measured in measured {
            let costs = match &measured.costs {
                Ok(costs) => costs,
                Err(error) => {
                    let Program { scene, number, .. } = &measured.program;
                    failures.push(format!("{scene} in {number} on {:?}: {error}", measured.machine));
                    continue;
                }
            };
            for (place, cost) in of_program.iter().zip(costs) {
                if let Some(record) = records.get_mut(*place) {
                    record.costs.insert(column(measured.machine).to_owned(), cost.per_pixel);
                }
            }
        }
    }
    Ok(failures)
}

/// Few samples, the number types that firmware is written in, and at most one model that is not the scene's.
fn is_measured(setting: &Setting) -> bool {
    let is_other = [
        setting.fresnel != Setting::DEFAULT.fresnel,
        setting.spectrum != Setting::DEFAULT.spectrum,
        setting.path != Setting::DEFAULT.path,
        setting.offset != Setting::DEFAULT.offset,
    ];
    NumberName::FIRMWARE.contains(&setting.number)
        && matches!(setting.sampling, Sampling::Grid(1) | Sampling::Sequence(4 | 16))
        && is_other.into_iter().filter(|is_other| *is_other).count() <= 1
        && matches!(setting.path, Path::Own | Path::Controlled(_))
        && matches!(setting.offset, None | Some(1e-3))
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
        Path::Layers(thickness) => models.push(Model::Layers(thickness)),
    }
    models.extend(setting.offset.map(Model::Offset));
    // A slow processor takes some seconds for as many pixels.
    let size = match (record.scene.as_str(), setting.sampling) {
        ("mirage" | "ship" | "sunset" | "lenses" | "hole", _) | (_, Sampling::Sequence(_)) => [8, 6],
        _ => [16, 12],
    };
    Program { scene: record.scene.clone(), number: setting.number.to_string(), models, size, runs: Vec::new() }
}

fn run(setting: &Setting) -> Run {
    let samples = setting.sampling.most();
    Run { depth: setting.depth, cutoff: setting.cutoff, termination: "background".to_owned(), samples }
}
