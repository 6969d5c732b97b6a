//! The runs, with settings each: WHIT_RUNS.

use whit::render::{Sampling, Settings};
use whit::trace::{Budget, Termination};
use whit::{Real, Rgb};

use crate::number::Number;

/// Runs with semicolons between them, each of the number of bounces, the cutoff, `background`, `black` or `magenta`, and the
/// number of samples a pixel.
pub const RUNS: &str = match option_env!("WHIT_RUNS") {
    Some(runs) => runs,
    None => "5,0,background,1",
};

/// The most bounces of any run, for which there has to be room.
pub const DEPTH: u8 = {
    let text = RUNS.as_bytes();
    let (mut most, mut depth, mut is_depth, mut place) = (0, 0_u32, true, 0);
    while place < text.len() {
        match text[place] {
            digit @ b'0'..=b'9' if is_depth => depth = 10 * depth + (digit - b'0') as u32,
            b';' => (depth, is_depth) = (0, true),
            b' ' => {}
            _ => is_depth = false,
        }
        assert!(depth <= 254, "WHIT_RUNS: expected at most 254 bounces");
        if depth > most {
            most = depth;
        }
        place += 1;
    }
    most as u8
};

/// What is asked of a picture.
pub struct Run {
    depth: u8,
    cutoff: f32,
    termination: Termination<Number>,
    samples: u32,
}

impl Run {
    /// As in `5,0.00392,background,1`.
    pub fn read(text: &str) -> Result<Self, &'static str> {
        let mut words = text.split(',').map(str::trim);
        let mut word = || words.next().ok_or("WHIT_RUNS: expected for example 5,0.00392,background,1");
        let run = Self {
            depth: word()?.parse().map_err(|_| "WHIT_RUNS: expected a number of bounces")?,
            cutoff: word()?.parse().map_err(|_| "WHIT_RUNS: expected a cutoff such as 0.00392")?,
            termination: match word()? {
                "background" => Termination::Background,
                "black" => Termination::Black,
                "magenta" => Termination::Color(Rgb::new(Number::ONE, Number::ZERO, Number::ONE)),
                _ => return Err("WHIT_RUNS: expected background, black or magenta"),
            },
            samples: word()?.parse().map_err(|_| "WHIT_RUNS: expected a number of samples")?,
        };
        if words.next().is_some() { Err("WHIT_RUNS: expected four words a run") } else { Ok(run) }
    }

    /// One sample is in the middle of a pixel; more are points of the sequence.
    pub fn settings(&self, size: [u32; 2]) -> Settings<Number> {
        let Self { depth, cutoff, termination, samples } = *self;
        let budget = Budget { cutoff: Number::from_f32(cutoff), termination, ..Budget::with_depth(depth) };
        let sampling = if samples == 1 { Sampling::Grid(1) } else { Sampling::Sequence(samples) };
        Settings { budget, sampling, ..Settings::new(size[0], size[1]) }
    }
}
