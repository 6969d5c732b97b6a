//! Rows of a picture, traced in parallel.

use std::convert::Infallible;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;
use whit::render::{ForEach, Frame, RenderError, Settings};
use whit::trace::Dropped;
use whit::{Rgb, Stats, Tracer};

/// What is to be done.
pub struct Job {
    pub settings: Settings<f32>,
    pub threads: usize,
}

/// What came of it.
pub struct Picture {
    pub pixels: Vec<Rgb<f32>>,
    /// The throughput that was cut.
    pub dropped: Vec<Rgb<f32>>,
    pub stats: Stats,
}

/// Traces the rows of a job, each as a frame of its own, on as many threads as there are cores or were asked for.
pub fn trace<const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize>(
    tracer: &Tracer<'_, f32, EFFECTS, DEPTH, MEDIA>,
    job: &Job,
) -> Result<Picture, String> {
    let width = job.settings.size.width as usize;
    let count = job.settings.rows.len() * width;
    let room = || black(count).map_err(|problem| format!("--size: {problem}"));
    let (mut pixels, mut dropped) = (room()?, room()?);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(job.threads).build().map_err(|error| error.to_string())?;
    let bar = progress_bar(job.settings.rows.len());
    let stats = pool.install(|| {
        let rows = job.settings.rows.clone().into_par_iter();
        let places = pixels.par_chunks_mut(width).zip(dropped.par_chunks_mut(width));
        let row = |(y, (pixels, dropped)): (u32, (&mut [_], &mut [_]))| {
            let keep = Dropped::new(|x, _, weight| set(dropped, x, weight));
            let stats = trace_row(tracer, &job.settings, y, pixels, (Stats::default(), keep))?.observer().0;
            bar.inc(1);
            Ok::<Stats, String>(stats)
        };
        rows.zip(places).map(row).try_reduce(Stats::default, |a, b| Ok(a.plus(b)))
    });
    bar.finish_and_clear();
    Ok(Picture { pixels, dropped, stats: stats? })
}

fn trace_row<'a, const EFFECTS: u64, const DEPTH: usize, O: whit::trace::Observer, const MEDIA: usize>(
    tracer: &Tracer<'a, f32, EFFECTS, DEPTH, MEDIA>,
    settings: &Settings<f32>,
    y: u32,
    pixels: &mut [Rgb<f32>],
    observer: O,
) -> Result<Frame<'a, f32, EFFECTS, DEPTH, O, MEDIA>, String> {
    let settings = Settings { rows: y..y + 1, ..settings.clone() };
    let mut target = ForEach::new(settings.size, |pixel| {
        set(pixels, pixel.x, pixel.color);
        Ok::<(), Infallible>(())
    });
    let mut frame = Frame::observed(tracer, settings, observer).map_err(|error| error.to_string())?;
    frame.render(&mut target).map_err(|error: RenderError<Infallible>| error.to_string())?;
    Ok(frame)
}

fn set(pixels: &mut [Rgb<f32>], x: u32, color: Rgb<f32>) {
    if let Some(pixel) = pixels.get_mut(x as usize) {
        *pixel = color;
    }
}

pub fn black(count: usize) -> Result<Vec<Rgb<f32>>, String> {
    let mut pixels = Vec::new();
    pixels.try_reserve_exact(count).map_err(|_| format!("there is no memory for {count} pixels"))?;
    pixels.resize(count, Rgb::BLACK);
    Ok(pixels)
}

/// On a terminal only.
fn progress_bar(rows: usize) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(rows as u64), ProgressDrawTarget::stderr());
    match ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

pub fn stats_as_json(stats: &Stats, seconds: f64) -> serde_json::Value {
    serde_json::json!({
        "eye": stats.eye,
        "reflected": stats.reflected,
        "transmitted": stats.transmitted,
        "passed": stats.passed,
        "shadow": stats.shadow,
        "total_internal": stats.total_internal,
        "media_overflows": stats.media_overflows,
        "cut_by_depth": stats.cut_by_depth,
        "cut_by_cutoff": stats.cut_by_cutoff,
        "cut_by_budget": stats.cut_by_budget,
        "cut_by_passing": stats.cut_by_passing,
        "steps": stats.steps,
        "captured": stats.captured,
        "cut_by_steps": stats.cut_by_steps,
        "seconds": seconds,
        "ns_per_ray": seconds * 1e9 / stats.rays() as f64,
    })
}
