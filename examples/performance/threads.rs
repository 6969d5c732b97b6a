//! Pictures by many threads.

use std::convert::Infallible;
use std::time::Instant;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use whit::render::{ForEach, Pixel, Sampling};
use whit::{Frame, Settings, Tracer, scenes};

use crate::aim::{Aim, Limit};
use crate::effort::Effort;
use crate::rounds::Rounds;
use crate::section::Section;

/// Near to linear: of the number of threads.
const AIM: f64 = 0.9;

/// Renders a scene in a pool of threads.
type Draw<'a> = dyn Fn(&ThreadPool) -> Result<(), String> + 'a;

pub fn measure(effort: &Effort) -> Result<Section, String> {
    let cores = std::thread::available_parallelism().map_err(|error| error.to_string())?.get();
    let mut section = Section::new("Many threads");
    let settings = Settings::new(effort.threads * 4 / 3, effort.threads).with_sampling(Sampling::Grid(2));
    section.line(&format!(
        "Built-in scenes at {}×{} pixels of four samples, each row a frame of its own in a pool of rayon: how many times as fast as on one thread, by the \
         clock on the wall, with {cores} cores.",
        settings.size.width, settings.size.height
    ));
    section.table(&["scene", "threads", "times as fast"], "lrr");
    let mut measured = Vec::new();
    let (showcase, flake) = (whit::tracer!(scenes::SHOWCASE), whit::tracer!(scenes::FLAKE));
    let scenes: [(&'static str, &Draw<'_>); 2] =
        [("showcase", &|pool| draw(pool, &showcase, &settings)), ("flake", &|pool| draw(pool, &flake, &settings))];
    for (name, draw) in scenes {
        eprintln!("{name} by threads");
        let rounds = rounds(effort, cores, draw)?;
        for count in counts(cores).into_iter().skip(1) {
            let ratio = rounds.ratio("1", &count.to_string(), 0);
            section.row(&[format!("`{name}`"), count.to_string(), ratio.to_string()]);
            if count == cores {
                measured.push((name, ratio));
            }
        }
    }
    if cores > 1 {
        let what = format!("{cores} threads: times as fast as one");
        section.aims.push(Aim { what, limit: Limit::AtLeast(AIM * cores as f64), measured });
    }
    Ok(section)
}

/// Seconds of a picture, by the number of threads.
fn rounds<'a>(effort: &Effort, cores: usize, draw: &'a Draw<'a>) -> Result<Rounds<'a, 1>, String> {
    let mut rounds = Rounds::new();
    for count in counts(cores) {
        let pool = ThreadPoolBuilder::new().num_threads(count).build().map_err(|error| error.to_string())?;
        rounds.add(count.to_string(), move || {
            let start = Instant::now();
            draw(&pool)?;
            Ok([start.elapsed().as_secs_f64()])
        });
    }
    rounds.run(effort.rounds)?;
    Ok(rounds)
}

/// Powers of two, and all cores.
fn counts(cores: usize) -> Vec<usize> {
    let powers = std::iter::successors(Some(1), |count| Some(count * 2)).take_while(|&count| count < cores);
    powers.chain([cores]).collect()
}

fn draw<const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize>(
    pool: &ThreadPool,
    tracer: &Tracer<'_, f32, EFFECTS, DEPTH, MEDIA>,
    settings: &Settings<f32>,
) -> Result<(), String> {
    let row = |y: u32| {
        let settings = Settings { rows: y..y + 1, ..settings.clone() };
        let mut target = ForEach::new(settings.size, |pixel: Pixel| {
            std::hint::black_box(pixel);
            Ok::<(), Infallible>(())
        });
        let mut frame = Frame::new(tracer, settings).map_err(|error| error.to_string())?;
        frame.render(&mut target).map_err(|error| error.to_string())
    };
    pool.install(|| (0..settings.size.height).into_par_iter().try_for_each(row))
}
