//! The part of the page on small processors and WebAssembly.

use std::fmt::Write;

use crate::boards::{MACHINES, Machine};
use crate::measure::Measured;
use crate::number_name::NumberName;
use crate::record::Record;
use crate::setting::Setting;
use crate::targets::column;

/// What number types cost there, by default.
pub fn section(page: &mut String, scenes: &[Measured]) {
    if scenes.iter().flat_map(|measured| &measured.records).all(|record| record.costs.is_empty()) {
        return;
    }
    page.push_str(include_str!("text/processors.md"));
    page.push_str("| scene | number type |");
    MACHINES.iter().for_each(|machine| page.push_str(&format!(" {} |", name(*machine))));
    page.push_str(" error of light |\n|---|---|");
    page.push_str(&"--:|".repeat(MACHINES.len()));
    page.push_str("--:|\n");
    for measured in scenes {
        for number in [NumberName::F32, NumberName::Fast, NumberName::Q20, NumberName::Q16] {
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
