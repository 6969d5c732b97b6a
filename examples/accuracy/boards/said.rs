//! The runs of the example `sweep`, and what it prints of them.

use std::fmt;

use super::program::Program;

/// What is asked of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    pub depth: u8,
    pub cutoff: f32,
    /// `background`, `black` or `magenta`.
    pub termination: String,
    /// A pixel.
    pub samples: u32,
}

impl fmt::Display for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { depth, cutoff, termination, samples } = self;
        write!(f, "{depth},{cutoff},{termination},{samples}")
    }
}

/// What a run took.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    pub run: Run,
    /// Instructions a pixel.
    pub per_pixel: f64,
    /// Of the linear pixels.
    pub checksum: u64,
}

/// What a program printed, run by run.
pub fn read(text: &str, program: &Program) -> Result<Vec<Cost>, String> {
    let cost = |(run, words): (&Run, &str)| {
        let instructions = words.strip_prefix("instructions ")?.split_once(' ')?.0.parse::<u64>().ok()?;
        let per_pixel = instructions as f64 / program.pixels() as f64;
        Some(Cost { run: run.clone(), per_pixel, checksum: checksum(words)? })
    };
    each(text, program, cost)
}

/// Reads what is said after each run.
fn each<T>(text: &str, program: &Program, read: impl Fn((&Run, &str)) -> Option<T>) -> Result<Vec<T>, String> {
    let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("run ")).collect();
    if lines.len() != program.runs.len() {
        return Err(format!("{} runs were asked for; the program printed\n{text}", program.runs.len()));
    }
    let of_run = |(line, run): (&&str, &Run)| {
        let words = line.strip_prefix(&format!("run {} ", run.to_string().replace(',', " ")));
        words.and_then(|words| read((run, words))).ok_or_else(|| format!("{run}: it printed {line}"))
    };
    lines.iter().zip(&program.runs).map(of_run).collect()
}

fn checksum(words: &str) -> Option<u64> {
    u64::from_str_radix(words.split_once("checksum ")?.1.trim(), 16).ok()
}
