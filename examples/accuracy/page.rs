//! The page docs/accuracy.md.

use std::fmt::Write;

use crate::code;
use crate::curves::PAIRS;
use crate::formats::Format;
use crate::frontier::{Tolerance, dominating, frontier};
use crate::measure::{Measured, TOLERANCE};
use crate::processors;
use crate::record::Record;
use crate::setting::Setting;
use crate::sweep::SAMPLES;

/// How far the library's `f64` is from an independent tracer, at one sample a pixel.
pub struct Agreement {
    pub name: &'static str,
    /// The share of pixels off by more than 1/255.
    pub share: f64,
    /// RMSE of the other pixels.
    pub rmse: f64,
}

/// All that the page tells.
pub struct Findings {
    pub scenes: Vec<Measured>,
    pub depths: Vec<(&'static str, [Vec<f64>; 2])>,
    pub agreements: Vec<Agreement>,
    pub formats: Vec<Format>,
    pub size: whit::render::Size,
}

impl Measured {
    /// What counts as equal in this run.
    pub fn tolerance(&self) -> Tolerance {
        Tolerance { cost: TOLERANCE.cost.max(self.noise), ..TOLERANCE }
    }

    /// Time and error of all pictures.
    pub fn points(&self) -> Vec<(f64, f64)> {
        self.records.iter().map(|record| (record.time.unwrap_or(record.rays), record.picture.rmse)).collect()
    }

    pub fn frontier(&self) -> Vec<usize> {
        frontier(&self.points(), self.tolerance())
    }

    /// What of the default setting's kind, with one sample a pixel, is faster and no worse.
    pub fn better_than_default(&self, error: fn(&Record) -> Option<f64>) -> Option<&Record> {
        let default = &self.records[0];
        let cost = |record: &Record| record.time.unwrap_or(record.rays);
        let known: Vec<_> = self.records.iter().filter_map(|record| Some((record, error(record)?))).collect();
        let points: Vec<_> = known.iter().map(|&(record, error)| (cost(record), error)).collect();
        dominating(&points, (cost(default), error(default)?), self.tolerance()).map(|place| known[place].0)
    }
}

pub fn page(findings: &Findings) -> String {
    let mut page = include_str!("text/head.md")
        .replace("{size}", &format!("{}×{}", findings.size.width, findings.size.height))
        .replace("{samples}", &SAMPLES.most().to_string())
        .replace("{default}", &Setting::DEFAULT.to_string());
    summary(&mut page, &findings.scenes);
    default(&mut page, &findings.scenes);
    page.push_str(include_str!("text/knobs.md"));
    knobs(&mut page, &findings.scenes);
    page.push_str(include_str!("text/depth.md"));
    depths(&mut page, &findings.depths);
    page.push_str(include_str!("text/schlick.md"));
    curves(&mut page);
    processors::section(&mut page, &findings.scenes);
    page.push_str(include_str!("text/formats.md"));
    formats(&mut page, &findings.formats);
    page.push_str("\n## The scenes\n");
    findings.scenes.iter().for_each(|measured| section(&mut page, measured));
    reference(&mut page, findings);
    page
}

fn summary(page: &mut String, scenes: &[Measured]) {
    page.push_str("| scene | default: error | 1/64 | 1/255 | the most exact |\n|---|--:|---|---|---|\n");
    for measured in scenes {
        let cheapest = |most: f64| {
            let good = measured.records.iter().filter(|record| record.picture.rmse <= most);
            let best = good.min_by(|a, b| a.time.partial_cmp(&b.time).unwrap_or(std::cmp::Ordering::Equal));
            best.map_or("–".to_owned(), cell)
        };
        let exact = measured.records.iter().min_by(|a, b| a.picture.rmse.total_cmp(&b.picture.rmse));
        let _ = writeln!(
            page,
            "| [{0}](#{0}) | {1:.4} | {2} | {3} | {4} |",
            measured.name,
            measured.records[0].picture.rmse,
            cheapest(1.0 / 64.0),
            cheapest(1.0 / 255.0),
            exact.map_or(String::new(), |record| format!("{}: {:.4}", cell(record), record.picture.rmse))
        );
    }
}

fn times(record: &Record) -> String {
    record.time.map_or(String::new(), |time| if time < 10.0 { format!("{time:.2}×") } else { format!("{time:.0}×") })
}

fn cell(record: &Record) -> String {
    format!("{} `{}`", times(record), record.setting.other_than(&Setting::DEFAULT))
}

/// Whether the default is worth its time.
fn default(page: &mut String, scenes: &[Measured]) {
    page.push_str(include_str!("text/default.md"));
    for measured in scenes {
        let answer = |error: fn(&Record) -> Option<f64>| match measured.better_than_default(error) {
            Some(better) => format!("{}, error {:.2e}", cell(better), error(better).unwrap_or(0.0)),
            None => "–".to_owned(),
        };
        let default = &measured.records[0];
        let _ = writeln!(
            page,
            "| {} | {:.2e} | {} | {:.2e} | {} |",
            measured.name,
            default.picture.rmse,
            answer(|record| Some(record.picture.rmse)),
            light(default).unwrap_or(0.0),
            answer(light)
        );
    }
}

fn light(record: &Record) -> Option<f64> {
    Some(record.light?.rmse)
}

/// Time, error of light, and error of the picture as a ratio to that of the default.
type Change = (f64, Option<f64>, f64);

/// What each knob changes alone, in the middle and at most over all scenes.
fn knobs(page: &mut String, scenes: &[Measured]) {
    let default = Setting::DEFAULT.to_string();
    let words = default.split(' ').count();
    let mut changes: Vec<(String, Vec<Change>)> = Vec::new();
    for measured in scenes {
        for record in &measured.records {
            let other = record.setting.other_than(&Setting::DEFAULT);
            let is_alone = !other.contains(' ') && other != "default" && words > 0;
            if !is_alone || other.starts_with("path=") {
                continue;
            }
            let picture = record.picture.rmse / measured.records[0].picture.rmse;
            let change = (record.time.unwrap_or(f64::NAN), light(record), picture);
            match changes.iter_mut().find(|(name, _)| *name == other) {
                Some((_, list)) => list.push(change),
                None => changes.push((other, vec![change])),
            }
        }
    }
    page.push_str("| knob | scenes | time | error of light | error of picture |\n|---|--:|--:|--:|--:|\n");
    for (name, list) in changes {
        let range = |get: fn(&Change) -> Option<f64>| {
            let mut values: Vec<f64> = list.iter().filter_map(get).collect();
            values.sort_by(f64::total_cmp);
            let last = values.len().checked_sub(1)?;
            Some([values[0], values[values.len() / 2], values[last]])
        };
        let light = range(|change| change.1).map_or("".to_owned(), |[_, b, c]| format!("{b:.1e}, {c:.1e}"));
        let time = range(|change| Some(change.0)).map_or("".to_owned(), |[a, b, c]| format!("{a:.2}, {b:.2}, {c:.2}×"));
        let picture = range(|change| Some(change.2)).map_or("".to_owned(), |[_, b, c]| format!("{b:.2}, {c:.2}×"));
        let _ = writeln!(page, "| `{name}` | {} | {time} | {light} | {picture} |", list.len());
    }
}

fn depths(page: &mut String, depths: &[(&str, [Vec<f64>; 2])]) {
    page.push_str("| scene | |");
    (0..=10).for_each(|depth| page.push_str(&format!(" {depth} |")));
    page.push_str(&format!("\n|---|---|{}\n", "--:|".repeat(11)));
    for (name, both) in depths {
        for (errors, termination) in both.iter().zip(["background", "black"]) {
            let _ = write!(page, "| {name} | {termination} |");
            errors.iter().for_each(|error| page.push_str(&format!(" {error:.0e} |")));
            page.push('\n');
        }
    }
    let _ = write!(page, "| better | |");
    for depth in 0..=10 {
        let better =
            |a: usize, b: usize| depths.iter().filter(|(_, both)| both[a][depth] * 1.03 < both[b][depth]).count();
        let _ = write!(page, " {}, {} |", better(0, 1), better(1, 0));
    }
    page.push('\n');
}

fn curves(page: &mut String) {
    page.push_str("| media | R at 0° | largest error of Schlick | at |\n|---|--:|--:|--:|\n");
    for (name, pair) in PAIRS {
        let (error, degrees) = pair.worst();
        let [normal, _] = pair.reflectances(0.0);
        let _ = writeln!(page, "| {name} | {normal:.3} | {error:.3} | {degrees:.1}° |");
    }
}

fn formats(page: &mut String, formats: &[Format]) {
    page.push_str("| format | code | bits | RMSE | largest | over 1/255 | ΔE₀₀ | RMSE of 4×4 pixels | time |\n");
    page.push_str("|---|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for format in formats {
        let d = &format.difference;
        let _ = writeln!(
            page,
            "| {} | `{}` | {} | {:.1e} | {:.1e} | {:.0} % | {:.2} | {:.1e} | {:.2}× |",
            format.name,
            format.code,
            format.bits,
            d.rmse,
            d.max,
            100.0 * d.share,
            d.delta_e,
            format.far,
            format.time
        );
    }
}

fn section(page: &mut String, measured: &Measured) {
    let name = measured.name;
    let _ = writeln!(page, "\n### {name}\n\n![Error over time](images/accuracy/{name}.svg)\n");
    for (number, reason) in &measured.refusals {
        let _ = writeln!(page, "`{number}` refuses the scene: {reason}.\n");
    }
    page.push_str("| | setting | time | rays | RMSE | largest | over 1/255 | ΔE₀₀ | RMSE of light |\n");
    page.push_str("|--:|---|--:|--:|--:|--:|--:|--:|--:|\n");
    let frontier = measured.frontier();
    let numbered = frontier.iter().enumerate().map(|(i, &place)| ((i + 1).to_string(), place));
    let ring = if frontier.contains(&0) { None } else { Some(("○".to_owned(), 0)) };
    for (label, place) in numbered.chain(ring) {
        let record = &measured.records[place];
        let p = &record.picture;
        let _ = writeln!(
            page,
            "| {label} | `{}` | {} | {:.1} | {:.4} | {:.3} | {:.1} % | {:.2} | {} |",
            record.setting.other_than(&Setting::DEFAULT),
            times(record),
            record.rays,
            p.rmse,
            p.max,
            100.0 * p.share,
            p.delta_e,
            light(record).map_or(String::new(), |error| format!("{error:.1e}"))
        );
    }
    let good = frontier.iter().map(|&place| &measured.records[place]).find(|record| record.picture.rmse <= 1.0 / 64.0);
    if let Some(record) = good {
        let _ = writeln!(
            page,
            "\nThe first with an error of at most 1/64:\n\n```rust\n{}```",
            code::of(&record.setting, name)
        );
    }
    processors::frontiers(page, measured);
}

fn reference(page: &mut String, findings: &Findings) {
    page.push_str(include_str!("text/reference.md"));
    for Agreement { name, share, rmse } in &findings.agreements {
        let _ = writeln!(page, "| {name} | {:.2} % | {rmse:.1e} |", 100.0 * share);
    }
    let noise = findings.scenes.iter().map(|measured| measured.noise).fold(0.0, f64::max);
    let _ = writeln!(
        page,
        "\nTimes of this run varied by {:.1} % at most: that much longer than the shortest of a setting is the second shortest, in \
         the middle of all settings of a scene.",
        100.0 * noise
    );
}
