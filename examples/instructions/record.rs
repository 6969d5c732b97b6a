//! The counts, as a table of comma-separated values.

use std::path::Path;

/// What was counted of a subject.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    pub scene: String,
    pub instructions: u64,
    /// None where it is no picture.
    pub rays: Option<u64>,
    pub machine: Machine,
}

/// What made the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Machine {
    /// The compiler's name and version.
    pub compiler: String,
    /// What the program is for.
    pub host: String,
}

const COLUMNS: [&str; 5] = ["scene", "instructions", "rays", "compiler", "host"];

/// Writes all records.
pub fn write(file: &Path, records: &[Record]) -> Result<(), String> {
    let failed = |error: csv::Error| format!("{}: {error}", file.display());
    let mut writer = csv::Writer::from_path(file).map_err(failed)?;
    writer.write_record(COLUMNS).map_err(failed)?;
    for Record { scene, instructions, rays, machine } in records {
        let rays = rays.map_or(String::new(), |rays| rays.to_string());
        let cells = [scene, &instructions.to_string(), &rays, &machine.compiler, &machine.host];
        writer.write_record(cells).map_err(failed)?;
    }
    writer.flush().map_err(|error| format!("{}: {error}", file.display()))
}

/// Reads records.
pub fn read(file: &Path) -> Result<Vec<Record>, String> {
    let failed = |error: csv::Error| format!("{}: {error}", file.display());
    let mut reader = csv::Reader::from_path(file).map_err(failed)?;
    if reader.headers().map_err(failed)? != COLUMNS.as_slice() {
        return Err(format!("{}: expected the columns {}", file.display(), COLUMNS.join(", ")));
    }
    let rows = reader.deserialize::<(String, u64, Option<u64>, String, String)>();
    let record = |(scene, instructions, rays, compiler, host)| Record {
        scene,
        instructions,
        rays,
        machine: Machine { compiler, host },
    };
    rows.map(|row| row.map(record).map_err(failed)).collect()
}
