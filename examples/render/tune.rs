//! Settings by what is wished of the picture, from what was measured: docs/accuracy.csv.

use std::path::Path;
use std::time::Instant;

use whit::render::{Settings, Size};

use crate::arguments::Arguments;
use crate::code;
use crate::print::print;
use crate::record::{self, Record};
use crate::scene::Source;
use crate::setting::Setting;
use crate::tuner::{Amount, Wish, pick};
use crate::work::Job;

const NUMBERS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/accuracy.csv");

/// The job of the setting that is picked, which is said on the standard output with its reasons; `None` where nothing is wished.
///
/// # Errors
/// Why nothing can be picked.
pub fn job(arguments: &Arguments, source: &Source) -> Result<Option<Job>, String> {
    if arguments.max_error.is_none() && arguments.max_time.is_none() {
        return Ok(None);
    }
    let Source::BuiltIn { name, .. } = source else {
        return Err(
            "only built-in scenes were measured: expected one of them with --max-error and --max-time".to_owned()
        );
    };
    let size = arguments.size(source);
    let (wish, default) = match (arguments.max_error, arguments.max_time) {
        (Some(Amount(error)), _) => (Wish::Error(error), None),
        (None, Some(Seconds(most))) => {
            let default = time_of_default(arguments, source, size)?;
            (Wish::Cost(most / default), Some(default))
        }
        (None, None) => return Ok(None),
    };
    let records = record::read(Path::new(NUMBERS))?;
    let of_scene: Vec<&Record> =
        records.iter().filter(|record| record.scene == *name && is_had_here(&record.setting)).collect();
    let in_words = |cost: f64| match default {
        Some(default) => format!("about {:.3} s", cost * default),
        None => format!("{cost:.2} times the time of the default"),
    };
    let picked = pick(of_scene, |record| record.time, in_words, wish).map_err(|error| format!("{name}: {error}"))?;
    print(&picked.reasons(in_words))?;
    print(&code::of(&picked.record.setting, name))?;
    let settings = picked.record.setting.for_picture(size.width, size.height);
    Ok(Some(Job { settings: Settings { rows: arguments.rows_of(size)?, ..settings }, threads: arguments.threads }))
}

/// Whether this program has a tracer for it: in `f32`, of the scene as it is.
fn is_had_here(setting: &Setting) -> bool {
    setting.number == Setting::DEFAULT.number && setting.has_own_scene()
}

/// Seconds for a picture by the default setting, from a picture of a sixteenth of the pixels, the least of three.
fn time_of_default(arguments: &Arguments, source: &Source, size: Size) -> Result<f64, String> {
    let small = Size::new(size.width.div_ceil(4), size.height.div_ceil(4));
    let settings = Setting::DEFAULT.for_picture(small.width, small.height);
    let job = Job { settings, threads: arguments.threads };
    let mut least = f64::INFINITY;
    for _ in 0..3 {
        let started = Instant::now();
        source.render(&job)?;
        least = least.min(started.elapsed().as_secs_f64());
    }
    Ok(least * size.pixels() as f64 / small.pixels() as f64)
}

/// A time, as `50ms` or `2s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seconds(pub f64);

impl std::str::FromStr for Seconds {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (number, unit) = match text.strip_suffix("ms") {
            Some(number) => (number, 1e-3),
            None => (text.strip_suffix('s').unwrap_or(text), 1.0),
        };
        match number.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value > 0.0 => Ok(Self(value * unit)),
            _ => Err(format!("expected a time such as 50ms or 2s, found `{text}`")),
        }
    }
}
