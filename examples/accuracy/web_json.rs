//! The frontiers for the web page: of the settings that it has, as JSON.

use std::path::Path;

use serde_json::{Map, Value, json};
use whit::Termination;
use whit::render::Sampling;

use crate::frontier::frontier;
use crate::measure::{Measured, TOLERANCE};
use crate::number_name::NumberName;
use crate::record::Record;
use crate::setting::Setting;

/// Writes the frontier of each scene, the cheapest setting first.
///
/// # Errors
/// Why the file cannot be written.
pub fn write(path: &Path, scenes: &[Measured]) -> Result<(), String> {
    let of = |measured: &Measured| (measured.name.to_owned(), of_scene(&measured.records));
    let all: Map<String, Value> = scenes.iter().map(of).collect();
    let text = serde_json::to_string_pretty(&Value::Object(all)).map_err(|error| error.to_string())?;
    std::fs::write(path, text + "\n").map_err(|error| format!("{}: {error}", path.display()))
}

fn of_scene(records: &[Record]) -> Value {
    let had: Vec<&Record> = records.iter().filter(|record| samples(&record.setting).is_some()).collect();
    let points: Vec<_> = had.iter().map(|record| (record.time.unwrap_or(f64::NAN), record.picture.rmse)).collect();
    let places = frontier(&points, TOLERANCE);
    places.into_iter().filter_map(|place| entry(had.get(place)?)).collect()
}

fn entry(record: &Record) -> Option<Value> {
    let Setting { number, depth, cutoff, .. } = record.setting;
    Some(json!({
        "number": number.name(),
        "depth": depth,
        "cutoff": cutoff,
        "samples": samples(&record.setting)?,
        "termination": "background",
        "error": record.picture.rmse,
        "time": record.time?,
    }))
}

/// The samples of a setting that the page has: of a scene as it is, in a number type that there is a module of.
fn samples(setting: &Setting) -> Option<Value> {
    let has_module = matches!(setting.number, NumberName::F32 | NumberName::F64 | NumberName::Fast | NumberName::Q20);
    if !has_module || !setting.has_own_scene() || setting.termination != Termination::Background {
        return None;
    }
    match setting.sampling {
        Sampling::Grid(1) => Some(json!(1)),
        Sampling::Grid(2) => Some(json!("2x2")),
        Sampling::Sequence(count) => Some(json!(count)),
        _ => None,
    }
}
