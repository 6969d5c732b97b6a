//! Errors, steps and times of paths.

use std::hint::black_box;
use std::time::Instant;

use whit::Effects;

use crate::systems::{Case, System};
use crate::way::Way;
use crate::world::{Bend, Certain, ENOUGH, Start, World, ray};

/// What a way of following the paths of a system takes.
pub struct Row {
    pub way: Way,
    /// The largest of all paths, in `f32`; `None` where a path ends at something else.
    pub error: Option<f64>,
    /// Of all paths together.
    pub steps: u32,
    pub paths: u32,
    /// How many times as long as a straight ray a path takes; none where it was not measured.
    pub time: Option<f64>,
}

impl Row {
    pub fn steps_per_path(&self) -> f64 {
        f64::from(self.steps) / f64::from(self.paths)
    }

    pub fn evaluations_per_path(&self) -> f64 {
        self.steps_per_path() * f64::from(self.way.kind.evaluations())
    }
}

/// All ways of a system.
pub fn rows(system: &System, timed: bool) -> Vec<Row> {
    system.ways.iter().map(|&way| row(way, &(system.cases)(way), timed)).collect()
}

fn row(way: Way, cases: &[Case], timed: bool) -> Row {
    let error = |case: &Case| (case.error)(&case.world.follow::<f32>(&case.start, ENOUGH));
    let worst = cases.iter().map(error).try_fold(0.0_f64, |worst, error| Some(worst.max(error?)));
    let steps = cases.iter().map(|case| u32::from(case.world.steps::<f32>(&case.start).unwrap_or(ENOUGH))).sum();
    Row { way, error: worst, steps, paths: cases.len() as u32, time: timed.then(|| ratio(cases)) }
}

const PLAIN: Effects = Effects::SPHERE.with(Effects::PLANE).with(Effects::BODY);
const STEPS: Effects = Effects::FIXED_STEPS.with(Effects::CONTROLLED_STEPS);
const LAWS: Effects = Effects::POLYNOMIAL_LAW.with(Effects::EXPONENTIAL_LAW).with(Effects::FISH_EYE_LAW);
const LEVELS: Effects = Effects::HEIGHT_PROFILE.with(Effects::RADIUS_PROFILE);
const STRAIGHT: u64 = PLAIN.bits();
const MEDIA: u64 = PLAIN.with(STEPS).with(LAWS).with(LEVELS).with(Effects::LAYERS).bits();
const HOLES: u64 = PLAIN.with(STEPS).with(Effects::BLACK_HOLE).bits();

/// The time of the paths as a ratio to that of straight rays at the same targets, in turn; each the least of several runs.
fn ratio(cases: &[Case]) -> f64 {
    const RUNS: usize = 25;
    let mut least = [f64::INFINITY; 2];
    for _ in 0..RUNS {
        least = [least[0].min(bent(cases)), least[1].min(straight())];
    }
    least[0] / least[1]
}

/// Seconds a path.
fn bent(cases: &[Case]) -> f64 {
    let seconds = |case: &Case| match case.world.bend {
        Bend::Medium(_) => case.world.with_tracer::<f32, MEDIA, _>(|tracer| time(tracer, &case.start, 4)),
        Bend::Hole { .. } => case.world.with_tracer::<f32, HOLES, _>(|tracer| time(tracer, &case.start, 4)),
        Bend::Nothing => case.world.with_tracer::<f32, STRAIGHT, _>(|tracer| time(tracer, &case.start, 4)),
    };
    cases.iter().map(seconds).sum::<f64>() / cases.len() as f64
}

/// Seconds a straight ray to a wall.
fn straight() -> f64 {
    let world = World { bend: Bend::Nothing, targets: vec![crate::systems::wall(1.0)] };
    let start = crate::systems::start(-2.0, 0.5, 0.1);
    world.with_tracer::<f32, STRAIGHT, _>(|tracer| time(tracer, &start, 20_000))
}

fn time<const EFFECTS: u64>(tracer: &Certain<'_, f32, EFFECTS>, start: &Start, times: u32) -> f64 {
    let ray = ray::<f32>(start);
    let started = Instant::now();
    for _ in 0..times {
        let _ = black_box(tracer.destination(black_box(&ray), ENOUGH));
    }
    started.elapsed().as_secs_f64() / f64::from(times)
}
