//! One picture from the parts of it that were rendered apart.

use std::ops::Range;
use std::path::{Path, PathBuf};

use whit::Rgb;

use crate::output::Target;
use crate::part::{Part, read_pixels};
use crate::work::black;

/// Writes the whole picture, with the bits that it has when it is rendered at once.
///
/// # Errors
/// Where a file is no part, parts are not of one picture, or rows are missing or doubled. Nothing is written then.
pub fn join(paths: &[PathBuf], output: &Path) -> Result<(), String> {
    let target = Target::new(output)?;
    if let Some(path) = paths.iter().find(|path| is_same_file(path, output)) {
        return Err(format!("{}: is a part, and would be overwritten", path.display()));
    }
    let mut parts = Vec::new();
    for path in paths {
        parts.push((path.as_path(), Part::open(path)?));
    }
    parts.sort_by_key(|(_, part)| part.rows.start);
    check_one_picture(&parts)?;
    check_rows(&parts)?;
    let Some((_, first)) = parts.first() else { return Err("--join: expected parts".to_owned()) };
    let whole = Part { rows: 0..first.size.height, ..first.clone() };
    let mut pixels = black(whole.pixels())?;
    let mut rest: &mut [Rgb<f32>] = &mut pixels;
    for (path, part) in &parts {
        let values = read_pixels(path)?;
        let (place, others) = rest.split_at_mut_checked(part.pixels()).unwrap_or_default();
        if place.len() != values.len() {
            return Err(format!("{}: changed while it was read", path.display()));
        }
        place.copy_from_slice(&values);
        rest = others;
    }
    target.write(&whole, &pixels)
}

fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// All parts agree with the topmost one.
fn check_one_picture(parts: &[(&Path, Part)]) -> Result<(), String> {
    let Some(((first_path, first), others)) = parts.split_first() else { return Ok(()) };
    for (path, part) in others {
        let mut differences = part.description.differences(&first.description);
        if part.size != first.size {
            let in_words = |part: &Part| format!("{}x{}", part.size.width, part.size.height);
            differences.insert(0, format!("size {}, not {}", in_words(part), in_words(first)));
        }
        if !differences.is_empty() {
            let (path, first_path) = (path.display(), first_path.display());
            return Err(format!("{path}: is of another picture than {first_path}: {}", differences.join("; ")));
        }
    }
    Ok(())
}

/// Each row is in one part. The parts come in the order of their first rows.
fn check_rows(parts: &[(&Path, Part)]) -> Result<(), String> {
    let height = parts.first().map_or(0, |(_, part)| part.size.height);
    let (mut end, mut last) = (0, Path::new(""));
    let mut missing = Vec::new();
    for (path, part) in parts {
        let rows = &part.rows;
        if rows.start < end {
            let doubled = in_words(rows.start..rows.end.min(end));
            return Err(format!("{doubled} are in both {} and {}", last.display(), path.display()));
        }
        if rows.start > end {
            missing.push(in_words(end..rows.start));
        }
        (end, last) = (rows.end, path);
    }
    if end < height {
        missing.push(in_words(end..height));
    }
    if missing.is_empty() { Ok(()) } else { Err(format!("{} are in no part", missing.join(", "))) }
}

fn in_words(rows: Range<u32>) -> String {
    format!("rows {}..{}", rows.start, rows.end)
}
