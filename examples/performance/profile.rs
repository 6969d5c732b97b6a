//! Where the instructions go.

use std::collections::BTreeMap;
use std::path::Path;

use crate::callgrind::{self, Counts};
use crate::places::Places;
use crate::programs::Programs;
use crate::section::Section;

/// What is looked into: a name, and the arguments of a measured program but for the size of the picture, which is the difference of
/// a large one and a small one.
const PICTURES: [(&str, &[&str]); 3] = [
    ("card", &["card", "SIZE", "16"]),
    ("flake of 91, packed list", &["render", "flake", "91", "packed", "SIZE"]),
    ("flake of 7381, hierarchy", &["render", "flake", "7381", "boxes", "SIZE"]),
];
const SIZES: [&str; 2] = ["16", "96"];
/// Rows with less than this of everything are summed up.
const LEAST: f64 = 0.02;
const REST: &str = "the rest";

/// Shares of instructions by where they come from.
type Shares = BTreeMap<String, f64>;

pub fn measure(programs: &Programs) -> Result<Section, String> {
    let mut section = Section::new("Where the time goes");
    let mut columns = Vec::new();
    if !callgrind::is_there() {
        section.lacks("Valgrind", "valgrind");
        return Ok(section);
    }
    for (name, arguments) in PICTURES {
        eprintln!("instructions of {name}");
        columns.push(shares(programs, arguments)?);
    }
    section.line(
        "Shares of the instructions of a picture, of the plain build, by the file of the library that they come from; what is inlined \
         there from `math` counts there. Instructions are not time, but show where it goes.",
    );
    let names = PICTURES.map(|(name, _)| name);
    section.table(&[&["file"], names.as_slice()].concat(), "lrrr");
    let mut files: Vec<&String> = columns.iter().flat_map(BTreeMap::keys).collect();
    files.sort();
    files.dedup();
    let share = |shares: &Shares, file: &String| shares.get(file).copied().unwrap_or_default();
    let (mut shown, rare): (Vec<_>, Vec<_>) =
        files.into_iter().partition(|file| columns.iter().any(|shares| share(shares, file) >= LEAST));
    let total = |file: &String| columns.iter().map(|shares| share(shares, file)).sum::<f64>();
    shown.sort_by(|one, other| total(other).total_cmp(&total(one)));
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    for file in shown {
        let cells = columns.iter().map(|shares| percent(share(shares, file)));
        section.row(&std::iter::once(title(file)).chain(cells).collect::<Vec<_>>());
    }
    let rest = columns.iter().map(|shares| percent(rare.iter().map(|file| share(shares, file)).sum()));
    section.row(&std::iter::once(REST.to_owned()).chain(rest).collect::<Vec<_>>());
    Ok(section)
}

fn title(file: &str) -> String {
    match file {
        "the firmware" => "the measured program".to_owned(),
        _ if file.contains('.') => format!("[`{file}`](../src/{file})"),
        _ => file.to_owned(),
    }
}

/// Of what a large picture takes more than a small one.
fn shares(programs: &Programs, arguments: &[&str]) -> Result<Shares, String> {
    let program = programs.measured("any");
    let program = Path::new(program.get_program());
    let picture = programs.file("profile.ppm");
    let picture = picture.to_str().ok_or_else(|| format!("{}: expected a name in UTF-8", picture.display()))?;
    let count = |size| {
        let sized = arguments.iter().map(|&word| if word == "SIZE" { size } else { word });
        let arguments: Vec<&str> = sized.chain([picture]).collect();
        callgrind::count(&["--dump-instr=yes", "--dump-line=no"], program, &arguments)
    };
    let [small, large] = SIZES.map(count);
    by_file(program, &small?, &large?)
}

fn by_file(program: &Path, small: &Counts, large: &Counts) -> Result<Shares, String> {
    let bytes = std::fs::read(program).map_err(|error| format!("{}: {error}", program.display()))?;
    let places = Places::of(&bytes)?;
    let mut shares = Shares::new();
    let mut total = 0.0;
    for (address, count) in large {
        let count = count.saturating_sub(small.get(address).copied().unwrap_or_default()) as f64;
        let file = address
            .map_or_else(|| Ok("the C library".to_owned()), |address| places.find(address as u32).map(|at| at.user))?;
        *shares.entry(file).or_default() += count;
        total += count;
    }
    shares.values_mut().for_each(|share| *share /= total);
    Ok(shares)
}
