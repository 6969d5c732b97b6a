//! Which setting to take: the command line of the tuner, and its answer.

use std::path::Path;
use std::str::FromStr;

use clap::Args;
use whit::render::Size;

use crate::boards::MACHINES;
use crate::code;
use crate::record::{self, Record};
use crate::targets;
use crate::tuner::{Amount, Wish, pick};

/// What a setting should do.
#[derive(Debug, Args)]
pub struct Question {
    /// Pick the cheapest setting with an error of the picture (RMSE) of at most this, such as 1/255.
    #[arg(long, value_name = "ERROR", conflicts_with = "max_instructions")]
    max_error: Option<Amount>,
    /// Pick the best setting that takes at most so many instructions a picture, such as 100M; on a target that has them.
    #[arg(long, value_name = "COUNT")]
    max_instructions: Option<Amount>,
    /// Where: host, m4f, m0, rv32 or wasm.
    #[arg(long, value_name = "NAME", default_value = "host")]
    target: Target,
    /// Pixels of the picture.
    #[arg(long, value_name = "WxH", default_value = "320x240", value_parser = parse_size)]
    size: Size,
}

/// Where a picture is rendered.
#[derive(Clone, Debug, PartialEq)]
enum Target {
    Host,
    /// By the name of its column.
    Other(&'static str),
}

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "host" {
            return Ok(Self::Host);
        }
        let found = MACHINES.into_iter().map(targets::column).find(|column| *column == text);
        found.map(Self::Other).ok_or_else(|| "expected host, m4f, m0, rv32 or wasm".to_owned())
    }
}

fn parse_size(text: &str) -> Result<Size, String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match sides {
        Some((width, height)) if width > 0 && height > 0 => Ok(Size::new(width, height)),
        _ => Err("expected WIDTHxHEIGHT, such as 320x240".to_owned()),
    }
}

impl Question {
    /// What is wished for, if anything is.
    ///
    /// # Errors
    /// What cannot be wished for.
    pub fn wish(&self) -> Result<Option<Wish>, String> {
        match (self.max_error, self.max_instructions) {
            (Some(Amount(error)), _) => Ok(Some(Wish::Error(error))),
            (None, Some(_)) if self.target == Target::Host => {
                Err("--max-instructions: expected a --target whose instructions are counted".to_owned())
            }
            (None, Some(Amount(count))) => Ok(Some(Wish::Cost(count / self.size.pixels() as f64))),
            (None, None) => Ok(None),
        }
    }

    /// Prints what to take for each scene.
    ///
    /// # Errors
    /// Why nothing can be picked.
    pub fn answer(&self, wish: Wish, numbers: &Path, scenes: &[String]) -> Result<(), String> {
        let records = record::read(numbers)?;
        if scenes.is_empty() {
            return Err("--scene: expected the name of a built-in scene".to_owned());
        }
        for scene in scenes {
            let of_scene: Vec<&Record> = records.iter().filter(|record| record.scene == *scene).collect();
            if of_scene.is_empty() {
                return Err(format!("--scene {scene}: {} has no such scene", numbers.display()));
            }
            let pick = pick(of_scene, |record| self.cost(record), |cost| self.in_words(cost), wish);
            let pick = pick.map_err(|error| format!("{scene}: {error}"))?;
            println!("{}", pick.reasons(|cost| self.in_words(cost)));
            println!("{}", code::of(&pick.record.setting, scene));
        }
        Ok(())
    }

    fn cost(&self, record: &Record) -> Option<f64> {
        match self.target {
            Target::Host => record.time,
            Target::Other(column) => record.costs.get(column).copied(),
        }
    }

    fn in_words(&self, cost: f64) -> String {
        match self.target {
            Target::Host => format!("{cost:.2} times the time of the default"),
            Target::Other(column) => {
                let whole = cost * self.size.pixels() as f64 / 1e6;
                let Size { width, height } = self.size;
                format!("{cost:.0} instructions a pixel on {column}, {whole:.1} M for {width}x{height}")
            }
        }
    }
}
