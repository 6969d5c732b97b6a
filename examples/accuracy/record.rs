//! What was measured, as a table of comma-separated values.

use std::collections::BTreeMap;
use std::path::Path;

use crate::difference::Difference;
use crate::setting::Setting;

/// A setting on a scene.
#[derive(Clone, Debug)]
pub struct Record {
    pub scene: String,
    pub setting: Setting,
    /// Rays a pixel.
    pub rays: f64,
    /// How many times as long as by default; none where it was not measured.
    pub time: Option<f64>,
    /// Against the converged picture.
    pub picture: Difference,
    /// Against the light at the same sample; none where there are more samples than one.
    pub light: Option<Difference>,
    /// What it costs on other targets, by the name of the column.
    pub costs: BTreeMap<String, f64>,
}

const KNOBS: [&str; 9] = ["number", "fresnel", "depth", "cutoff", "termination", "samples", "film", "path", "offset"];
const ERRORS: [&str; 5] = ["rmse", "max", "share", "delta_e", "delta_e_max"];

/// The name of a column of errors.
fn column(of: &str, error: &str) -> String {
    format!("{of}_{error}")
}

fn columns() -> Vec<String> {
    let mut columns = vec!["scene".to_owned()];
    columns.extend(KNOBS.map(str::to_owned));
    columns.extend(["rays".to_owned(), "time".to_owned()]);
    columns.extend(ERRORS.map(|error| column("picture", error)));
    columns.extend(ERRORS.map(|error| column("light", error)));
    columns
}

/// Writes all records, with the costs on other targets in columns of their own.
///
/// # Errors
/// Why the file cannot be written.
pub fn write(path: &Path, records: &[Record]) -> Result<(), String> {
    let mut others: Vec<&String> = records.iter().flat_map(|record| record.costs.keys()).collect();
    others.sort();
    others.dedup();
    let failed = |error: csv::Error| format!("{}: {error}", path.display());
    let mut writer = csv::Writer::from_path(path).map_err(failed)?;
    writer.write_record(columns().iter().chain(others.iter().copied())).map_err(failed)?;
    for record in records {
        let cost = |name: &&String| record.costs.get(*name).map_or(String::new(), |cost| short(*cost));
        writer.write_record(record.cells().into_iter().chain(others.iter().map(cost))).map_err(failed)?;
    }
    writer.flush().map_err(|error| format!("{}: {error}", path.display()))
}

/// Reads records; columns that are not this program's are costs on other targets.
///
/// # Errors
/// Why the file cannot be read, and where.
pub fn read(path: &Path) -> Result<Vec<Record>, String> {
    let failed = |error: csv::Error| format!("{}: {error}", path.display());
    let mut reader = csv::Reader::from_path(path).map_err(failed)?;
    reader
        .deserialize::<BTreeMap<String, String>>()
        .enumerate()
        .map(|(i, row)| {
            let row = row.map_err(failed)?;
            Record::from_cells(&row).map_err(|error| format!("{}: record {}: {error}", path.display(), i + 1))
        })
        .collect()
}

/// Takes over the costs on other targets from records that were there before.
pub fn keep_costs(records: &mut [Record], before: &[Record]) {
    let mut known = BTreeMap::new();
    for record in before {
        known.insert((record.scene.clone(), record.setting.to_string()), &record.costs);
    }
    for record in records {
        if let Some(costs) = known.get(&(record.scene.clone(), record.setting.to_string())) {
            record.costs = (*costs).clone();
        }
    }
}

impl Record {
    fn cells(&self) -> Vec<String> {
        let mut cells = vec![self.scene.clone()];
        let text = self.setting.to_string();
        let mut words = text.split(' ');
        for (i, knob) in KNOBS.iter().enumerate() {
            let value = match i {
                0 | 1 => words.next(),
                _ => text.split(' ').find_map(|word| word.strip_prefix(knob)?.strip_prefix('=')),
            };
            cells.push(value.unwrap_or("own").to_owned());
        }
        cells.push(short(self.rays));
        cells.push(self.time.map_or(String::new(), short));
        for difference in [Some(self.picture), self.light] {
            cells.extend(difference.map_or(ERRORS.map(|_| String::new()), |difference| errors(difference).map(short)));
        }
        cells
    }

    fn from_cells(row: &BTreeMap<String, String>) -> Result<Self, String> {
        let cell = |name: &str| row.get(name).map(String::as_str).ok_or_else(|| format!("there is no column {name}"));
        let parse =
            |name: &str, text: &str| text.parse().map_err(|_| format!("{name}: expected a number, found `{text}`"));
        let number = |name: &str| parse(name, cell(name)?);
        let mut text = format!("{} {}", cell("number")?, cell("fresnel")?);
        for knob in KNOBS.into_iter().skip(2) {
            text += &format!(" {knob}={}", cell(knob)?);
        }
        let difference = |of: &str| {
            let error = |name| number(&column(of, name));
            let (rmse, max, share) = (error("rmse")?, error("max")?, error("share")?);
            Ok::<_, String>(Difference {
                rmse,
                max,
                share,
                delta_e: error("delta_e")?,
                delta_e_max: error("delta_e_max")?,
            })
        };
        let known = columns();
        let others = row.iter().filter(|(name, text)| !known.contains(name) && !text.is_empty());
        Ok(Self {
            scene: cell("scene")?.to_owned(),
            setting: text.parse()?,
            rays: number("rays")?,
            time: if cell("time")?.is_empty() { None } else { Some(number("time")?) },
            picture: difference("picture")?,
            light: if cell("light_rmse")?.is_empty() { None } else { Some(difference("light")?) },
            costs: others.map(|(name, text)| Ok((name.clone(), parse(name, text)?))).collect::<Result<_, String>>()?,
        })
    }
}

const fn errors(difference: Difference) -> [f64; ERRORS.len()] {
    let Difference { rmse, max, share, delta_e, delta_e_max } = difference;
    [rmse, max, share, delta_e, delta_e_max]
}

/// Four digits.
fn short(x: f64) -> String {
    let text = format!("{x:.3e}");
    match text.parse::<f64>() {
        Ok(rounded) if rounded == 0.0 || rounded.abs() >= 1e-3 => rounded.to_string(),
        _ => text,
    }
}
