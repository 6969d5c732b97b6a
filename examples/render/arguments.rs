//! The command line.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::{CommandFactory, FromArgMatches, Parser};
use whit::render::{Sampling, Settings, Size};
use whit::{Budget, Rgb, Termination};

use crate::rows::{Rows, parse_part, parse_range};
use crate::scene::{DEPTH, Source};
use crate::setting::Share;
use crate::tune::Seconds;
use crate::tuner::Amount;
use crate::work::Job;

/// Writes a picture of a scene.
#[derive(Debug, Parser)]
#[command(name = "render", max_term_width = 100)]
pub struct Arguments {
    /// The name of a built-in scene, or a path to an .nff file.
    #[arg(default_value = "showcase")]
    pub scene: String,
    /// The picture: .png (8 bit) or .exr (linear 32-bit float) [default: target/render/SCENE.png].
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Pixels [default: the file's own, 512x512 for the card and the flake, else 640x480].
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<Size>,
    /// Samples a pixel; 1 is the middle of the pixel.
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=65_536))]
    samples: u32,
    /// Take a quarter of the samples, and the rest only where those differ by more than this.
    #[arg(long, value_name = "CONTRAST", value_parser = parse_amount)]
    adaptive: Option<f32>,
    /// Bounces; 0 is eye rays alone.
    #[arg(long, value_name = "D", default_value_t = 8, value_parser = clap::value_parser!(u8).range(0..=DEPTH as i64))]
    depth: u8,
    /// Cut branches that weigh less than this.
    #[arg(long, value_name = "C", default_value = "1/255", value_parser = parse_amount)]
    cutoff: f32,
    /// Rays a pixel may take, shadow rays included.
    #[arg(long, value_name = "N", default_value_t = u32::MAX, hide_default_value = true)]
    rays_per_pixel: u32,
    /// Steps a bent ray may take to its next surface.
    #[arg(long, value_name = "N", default_value_t = Budget::<f32>::with_depth(0).steps_per_ray)]
    steps: u16,
    /// What a cut branch shows: background, black, or R,G,B.
    #[arg(long, value_name = "COLOR", default_value = "background", value_parser = parse_termination)]
    termination: Termination<f32>,
    /// Pick the samples, depth and cutoff: the fastest measured with an error (RMSE) of at most this, such as 1/64.
    #[arg(long, value_name = "ERROR", conflicts_with_all = ["samples", "adaptive", "depth", "cutoff", "termination"])]
    pub max_error: Option<Amount>,
    /// Pick them: the best measured that take at most about this time, such as 50ms or 2s.
    #[arg(long, value_name = "TIME",
        conflicts_with_all = ["max_error", "samples", "adaptive", "depth", "cutoff", "termination"])]
    pub max_time: Option<Seconds>,
    /// Threads [default: one a core].
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub threads: usize,
    /// Print the counts of rays and cuts, and the time, as one JSON object.
    #[arg(long)]
    pub stats: bool,
    /// A picture of the throughput that the budget cut.
    #[arg(long, value_name = "FILE")]
    pub dropped: Option<PathBuf>,
    /// List the built-in scenes with the effects that each calls for.
    #[arg(long)]
    pub list: bool,
    /// Render only these rows, counted from the top; the file holds no others.
    #[arg(long, value_name = "A..B", value_parser = parse_range, help_heading = PARTS)]
    rows: Option<Rows>,
    /// Render the K-th of N nearly equal ranges of rows, K from 1 to N.
    #[arg(long, value_name = "K/N", value_parser = parse_part, conflicts_with = "rows", help_heading = PARTS)]
    part: Option<Rows>,
    /// Make the whole picture of .exr files that hold its rows; goes with --output alone.
    #[arg(long, value_name = "FILE", num_args = 1.., requires = "output", help_heading = PARTS)]
    pub join: Option<Vec<PathBuf>>,
}

const PARTS: &str = "Parts of a picture";

impl Arguments {
    /// From the command line. Where parts are joined, nothing is left to ask for but the file.
    pub fn read() -> Result<Self, clap::Error> {
        let alone = |argument: clap::Arg| match argument.get_id().as_str() {
            "join" | "output" => argument,
            _ => argument.conflicts_with("join"),
        };
        Self::from_arg_matches(&Self::command().mut_args(alone).try_get_matches()?)
    }

    pub fn output_path(&self, name: &str) -> PathBuf {
        let default = || Path::new("target/render").join(name).with_extension("png");
        self.output.clone().unwrap_or_else(default)
    }

    pub fn size(&self, source: &Source) -> Size {
        self.size.unwrap_or(source.size())
    }

    /// The rows of a picture of that size.
    pub fn rows_of(&self, size: Size) -> Result<Range<u32>, String> {
        self.rows.as_ref().or(self.part.as_ref()).unwrap_or(&Rows::All).of(size.height)
    }

    pub fn job(&self, source: &Source) -> Result<Job, String> {
        let size = self.size(source);
        let rows = self.rows_of(size)?;
        let sampling = match (self.adaptive, self.samples) {
            (None, 1) => Sampling::Grid(1),
            (None, n) => Sampling::Sequence(n),
            (Some(contrast), most) => Sampling::Adaptive { first: most.div_ceil(4), most, contrast },
        };
        let budget = Budget {
            depth: self.depth,
            cutoff: self.cutoff,
            rays_per_pixel: self.rays_per_pixel,
            steps_per_ray: self.steps,
            termination: self.termination,
        };
        let settings = Settings { rows, sampling, budget, ..Settings::new(size.width, size.height) };
        Ok(Job { settings, threads: self.threads })
    }
}

fn parse_size(text: &str) -> Result<Size, String> {
    let (width, height) = text.split_once('x').ok_or("expected WIDTHxHEIGHT, such as 640x480")?;
    let side = |text: &str| match text.parse() {
        Ok(side) if (1..=Size::LARGEST).contains(&side) => Ok(side),
        _ => Err(format!("expected 1 to {} pixels a side, found `{text}`", Size::LARGEST)),
    };
    Ok(Size::new(side(width)?, side(height)?))
}

fn parse_amount(text: &str) -> Result<f32, String> {
    match Share::from_str(text) {
        Ok(Share(value)) if value.is_finite() && value >= 0.0 => Ok(value),
        _ => Err("expected a finite number of at least 0".to_owned()),
    }
}

fn parse_termination(text: &str) -> Result<Termination<f32>, String> {
    match text {
        "background" => return Ok(Termination::Background),
        "black" => return Ok(Termination::Black),
        _ => {}
    }
    let channels: Result<Vec<f32>, String> = text.split(',').map(parse_amount).collect();
    match channels.as_deref() {
        Ok(&[r, g, b]) => Ok(Termination::Color(Rgb::new(r, g, b))),
        _ => Err("expected background, black or three numbers R,G,B".to_owned()),
    }
}
