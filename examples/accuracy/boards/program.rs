//! What the example `sweep` is compiled with.

use std::fmt;
use std::process::Command;

use super::said::Run;

/// A scene, how it is computed, and the runs of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Of the built-in ones.
    pub scene: String,
    /// `f32`, `f64`, or one that a feature makes available.
    pub number: String,
    /// What is other than in the scene.
    pub models: Vec<Model>,
    pub size: [u32; 2],
    pub runs: Vec<Run>,
}

/// A model that is chosen when a program is compiled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    /// WHIT_FRESNEL
    SchlickFresnel,
    /// WHIT_SPECTRUM, for scenes with thin films.
    Wavelengths,
    Bands(u8),
    Table,
    /// WHIT_STEPS, for scenes that bend light.
    StepLength(f32),
    Tolerance(f32),
    Layers(f32),
    /// WHIT_OFFSET
    Offset(f32),
}

impl Model {
    const fn variable(&self) -> &'static str {
        match self {
            Self::SchlickFresnel => "WHIT_FRESNEL",
            Self::Wavelengths | Self::Bands(_) | Self::Table => "WHIT_SPECTRUM",
            Self::StepLength(_) | Self::Tolerance(_) | Self::Layers(_) => "WHIT_STEPS",
            Self::Offset(_) => "WHIT_OFFSET",
        }
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SchlickFresnel => f.write_str("schlick"),
            Self::Wavelengths => f.write_str("wavelengths"),
            Self::Bands(count) => write!(f, "bands:{count}"),
            Self::Table => f.write_str("table"),
            Self::StepLength(length) => write!(f, "length:{length}"),
            Self::Tolerance(tolerance) => write!(f, "tolerance:{tolerance}"),
            Self::Layers(thickness) => write!(f, "layers:{thickness}"),
            Self::Offset(distance) => write!(f, "{distance}"),
        }
    }
}

impl Program {
    /// How many pixels a picture has.
    pub const fn pixels(&self) -> u64 {
        self.size[0] as u64 * self.size[1] as u64
    }

    /// Sets what the program reads when it is compiled.
    pub fn choose(&self, cargo: &mut Command) {
        let runs: Vec<String> = self.runs.iter().map(ToString::to_string).collect();
        cargo.env("WHIT_SCENE", &self.scene).env("WHIT_NUMBER", &self.number).env("WHIT_RUNS", runs.join(";"));
        cargo.env("WHIT_SIZE", format!("{}x{}", self.size[0], self.size[1]));
        for variable in ["WHIT_FRESNEL", "WHIT_SPECTRUM", "WHIT_STEPS", "WHIT_OFFSET"] {
            cargo.env_remove(variable);
        }
        for model in &self.models {
            cargo.env(model.variable(), model.to_string());
        }
        if let Some(feature) = feature(&self.number) {
            cargo.args(["--features", feature]);
        }
    }
}

/// The feature that makes a number type available.
fn feature(number: &str) -> Option<&'static str> {
    match number {
        "f32" | "f64" => None,
        "fast" | "micromath" => Some("micromath"),
        _ => Some("fixed"),
    }
}
