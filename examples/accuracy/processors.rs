//! The part of the page on small processors and WebAssembly.

use std::fmt::Write;

use crate::boards::{MACHINES, Machine};
use crate::frontier::frontier;
use crate::measure::{Measured, TOLERANCE};
use crate::number_name::NumberName;
use crate::record::Record;
use crate::setting::Setting;
use crate::targets::column;

/// What number types cost there, by default.
pub fn section(page: &mut String, scenes: &[Measured]) {
    if !scenes.iter().any(are_known) {
        return;
    }
    page.push_str(include_str!("text/processors.md"));
    page.push_str("| scene | number type |");
    MACHINES.iter().for_each(|machine| page.push_str(&format!(" {} |", name(*machine))));
    page.push_str(" error of light |\n|---|---|");
    page.push_str(&"--:|".repeat(MACHINES.len()));
    page.push_str("--:|\n");
    for measured in scenes {
        for number in NumberName::FIRMWARE {
            row(page, measured, number);
        }
    }
}

fn row(page: &mut String, measured: &Measured, number: NumberName) {
    let by_default = |number| {
        let setting = Setting { number, ..Setting::DEFAULT };
        measured.records.iter().find(|record| record.setting == setting && !record.costs.is_empty())
    };
    let Some(record) = by_default(number) else { return };
    let plain = by_default(NumberName::F32);
    let _ = write!(page, "| {} | `{number}` |", measured.name);
    for machine in MACHINES {
        let _ = write!(page, " {} |", cost(record, plain, column(machine)));
    }
    let light = record.light.map_or(String::new(), |light| format!("{:.1e}", light.rmse));
    let _ = writeln!(page, " {light} |");
}

/// Whether anything of a scene was measured there.
pub fn are_known(measured: &Measured) -> bool {
    measured.records.iter().any(|record| !record.costs.is_empty())
}

/// The places of the records that are on the frontier of a processor.
fn places(measured: &Measured, machine: Machine) -> Vec<usize> {
    let known = measured.records.iter().enumerate();
    let known = known.filter_map(|(place, record)| Some((place, *record.costs.get(column(machine))?)));
    let (places, costs): (Vec<_>, Vec<_>) = known.unzip();
    let error = |place: &usize| measured.records[*place].picture.rmse;
    let points: Vec<_> = costs.into_iter().zip(places.iter().map(error)).collect();
    frontier(&points, TOLERANCE).into_iter().map(|i| places[i]).collect()
}

/// The frontiers of all processors.
pub fn lines(measured: &Measured) -> Vec<(&'static str, Vec<(f64, f64)>)> {
    let line = |machine: Machine| {
        let records = places(measured, machine).into_iter().map(|place| &measured.records[place]);
        (name(machine), records.map(|record| (record.costs[column(machine)], record.picture.rmse)).collect())
    };
    MACHINES.map(line).to_vec()
}

/// The settings that are on a frontier.
pub fn frontiers(page: &mut String, measured: &Measured) {
    if !are_known(measured) {
        return;
    }
    let _ = writeln!(page, "\n![Error over instructions](images/accuracy/{}-processors.svg)\n", measured.name);
    let frontiers = MACHINES.map(|machine| places(measured, machine));
    let mut all: Vec<usize> = frontiers.concat();
    let error = |place: usize| measured.records[place].picture.rmse;
    all.sort_by(|&a, &b| error(b).total_cmp(&error(a)).then(a.cmp(&b)));
    all.dedup();
    page.push_str("| setting |");
    MACHINES.iter().for_each(|machine| page.push_str(&format!(" {} |", name(*machine))));
    page.push_str(" RMSE | RMSE of light |\n|---|");
    page.push_str(&"--:|".repeat(MACHINES.len() + 2));
    page.push('\n');
    for place in all {
        let record = &measured.records[place];
        let _ = write!(page, "| `{}` |", record.setting.other_than(&Setting::DEFAULT));
        for (machine, frontier) in MACHINES.iter().zip(&frontiers) {
            let cost = record.costs.get(column(*machine)).map_or(String::new(), |cost| format!("{cost:.0}"));
            let _ = if frontier.contains(&place) { write!(page, " **{cost}** |") } else { write!(page, " {cost} |") };
        }
        let light = record.light.map_or(String::new(), |light| format!("{:.1e}", light.rmse));
        let _ = writeln!(page, " {:.4} | {light} |", record.picture.rmse);
    }
}

/// Instructions, and as a share of those of `f32`.
fn cost(record: &Record, plain: Option<&Record>, column: &str) -> String {
    let Some(cost) = record.costs.get(column) else { return String::new() };
    let plain = plain.and_then(|plain| plain.costs.get(column));
    match plain {
        Some(plain) if plain != cost => format!("{cost:.0} ({:.2}×)", cost / plain),
        _ => format!("{cost:.0}"),
    }
}

const fn name(machine: Machine) -> &'static str {
    match machine {
        Machine::M4F => "Cortex-M4F",
        Machine::M0 => "Cortex-M0",
        Machine::RV32 => "RV32IMAC",
        Machine::Wasm => "WebAssembly",
    }
}
