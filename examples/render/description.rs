//! What decides the bits of a picture, in words, so that parts of different pictures can be told apart.

use std::collections::BTreeMap;

use whit::Budget;
use whit::render::{Encoding, Sampling, Settings};

use crate::scene::Source;

const LINEAR: &str = "linear";
const DISPLAY: &str = "display";

/// Names and values. Numbers are written with as many digits as it takes to tell them from all others.
#[derive(Clone, Debug, PartialEq)]
pub struct Description(BTreeMap<String, String>);

impl Description {
    /// Of the picture itself.
    pub fn new(source: &Source, settings: &Settings<f32>) -> Self {
        // What is not here changes no bit, or is the data window and the display window of the file.
        let Settings { size: _, rows: _, order: _, sampling, budget } = settings;
        let Budget { depth, cutoff, rays_per_pixel, steps_per_ray, termination } = budget;
        let samples = match sampling {
            Sampling::Grid(n) => format!("grid of {n}x{n}"),
            Sampling::Sequence(n) => n.to_string(),
            Sampling::Adaptive { first, most, contrast } => format!("{first} to {most} by a contrast of {contrast}"),
        };
        let values = match source.encoding() {
            Encoding::Srgb => LINEAR,
            Encoding::Display => DISPLAY,
        };
        let entries = [
            ("tool", concat!("whit ", env!("CARGO_PKG_VERSION"), " render").to_owned()),
            ("scene", source.identity()),
            ("shows", "light".to_owned()),
            ("values", values.to_owned()),
            ("samples", samples),
            ("depth", depth.to_string()),
            ("cutoff", cutoff.to_string()),
            ("rays per pixel", rays_per_pixel.to_string()),
            ("steps", steps_per_ray.to_string()),
            ("termination", format!("{termination:?}")),
        ];
        Self(entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }

    /// Of the picture of what the budget cut.
    pub fn of_dropped(&self) -> Self {
        let mut entries = self.0.clone();
        entries.insert("shows".to_owned(), "dropped throughput".to_owned());
        entries.insert("values".to_owned(), LINEAR.to_owned());
        Self(entries)
    }

    /// How its values become those of a display; none if this program does not know it.
    pub fn encoding(&self) -> Option<Encoding> {
        match self.0.get("values")?.as_str() {
            LINEAR => Some(Encoding::Srgb),
            DISPLAY => Some(Encoding::Display),
            _ => None,
        }
    }

    /// All that is not as in the other one.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        let names: std::collections::BTreeSet<_> = self.0.keys().chain(other.0.keys()).collect();
        let value = |of: &Self, name: &String| of.0.get(name).map_or("nothing", String::as_str).to_owned();
        names
            .into_iter()
            .filter(|name| self.0.get(*name) != other.0.get(*name))
            .map(|name| format!("{name} {}, not {}", value(self, name), value(other, name)))
            .collect()
    }

    pub fn to_json(&self) -> String {
        serde_json::json!(self.0).to_string()
    }

    pub fn from_json(text: &str) -> Option<Self> {
        serde_json::from_str(text).ok().map(Self)
    }
}
