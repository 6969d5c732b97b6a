//! How long a ray takes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use whit::render::{ForEach, Pixel, Size};
use whit::{Frame, Settings, Stats, Tracer};

const SIZE: Size = Size::new(96, 72);
/// Runs, as many as take about this long, but not more than needed and not so few that one that was disturbed counts.
const RUNS: std::ops::RangeInclusive<usize> = 21..=301;
const ENOUGH: Duration = Duration::from_millis(1500);

/// Nanoseconds a ray of two tracers, run in turn; each the least of several runs.
pub fn compare<const E: u64, const D: usize, const M: usize, const F: u64, const C: usize, const N: usize>(
    with: &Tracer<'_, f32, E, D, M>,
    without: &Tracer<'_, f32, F, C, N>,
) -> [f64; 2] {
    let mut least = [f64::INFINITY; 2];
    let started = Instant::now();
    for run in 0..*RUNS.end() {
        if run >= *RUNS.start() && started.elapsed() > ENOUGH {
            break;
        }
        least = [least[0].min(time(with)), least[1].min(time(without))];
    }
    least
}

fn time<const E: u64, const D: usize, const M: usize>(tracer: &Tracer<'_, f32, E, D, M>) -> f64 {
    let mut target = ForEach::new(SIZE, |pixel: Pixel| {
        black_box(pixel);
        Ok::<(), core::convert::Infallible>(())
    });
    let started = Instant::now();
    let Ok(mut frame) = Frame::observed(tracer, Settings::new(SIZE.width, SIZE.height), Stats::default()) else {
        return f64::NAN;
    };
    let _ = frame.render(&mut target);
    started.elapsed().as_secs_f64() * 1e9 / frame.observer().rays() as f64
}
