//! Frames, in steps of two sizes.

use whit::render::{Progress, Sampling};
use whit::trace::Dropped;
use whit::{Budget, Frame, Real, Settings, Stats, Termination};

use super::bound::limits;
use super::canvas::Canvas;
use super::rendered::Rendered;
use super::targets::check_targets;
use super::watch::Watch;
use super::{Everything, Fault, LARGE, Order, Outcome, require};

/// A picture that could take more steps of one ray than this is left unfinished after `SOME`.
const MOST: u64 = 20_000;
const SOME: u64 = 1500;

/// A stack for 4 bounces, or for 2 in scenes with dispersion.
const SMALL: usize = 4;

impl<T: Real> Order<'_, T> {
    pub(super) fn check_frames<const MEDIA: usize>(
        &self,
        tracer: &Everything<'_, T, LARGE, MEDIA>,
    ) -> Result<Outcome, Fault> {
        if let Err(error) = Frame::new(tracer, self.settings.clone()) {
            require(error.to_string().len() > 10, || format!("says little: {error}"))?;
            return Ok(Outcome::Refused);
        }
        let in_steps = self.render(tracer, self.step)?;
        self.check_pixels(&in_steps)?;
        let whole = self.render(tracer, u32::MAX)?;
        self.check_pixels(&whole)?;
        in_steps.compare(&whole).map_err(|fault| format!("in steps of {} {fault}", self.step))?;
        Ok(Outcome::Rendered)
    }

    /// A stack that has just the room that so many bounces need gives the same picture as a larger one.
    pub(super) fn check_small_stack(&self, large: &Everything<'_, T, LARGE, 8>) -> Result<(), Fault> {
        let small = Everything::<T, SMALL, 8>::try_new(self.scene).map_err(|error| error.to_string())?;
        let depth = small.depth() as u8;
        if self.settings.budget.depth < depth {
            return Ok(());
        }
        let settings = self.settings.clone().with_depth(depth);
        let fewer = Order { settings, rays: Vec::new(), ..*self };
        let (small, large) = (fewer.render(&small, u32::MAX)?, fewer.render(large, u32::MAX)?);
        small.compare(&large).map_err(|fault| format!("with a small stack {fault}"))
    }

    fn render<const DEPTH: usize, const MEDIA: usize>(
        &self,
        tracer: &Everything<'_, T, DEPTH, MEDIA>,
        step: u32,
    ) -> Result<Rendered, Fault> {
        let mut dropped = Vec::new();
        let drop = Dropped::new(|x, y, w| dropped.push((x, y, [w.r, w.g, w.b].map(f32::to_bits))));
        let mut canvas = Canvas::new(self.settings.size);
        let observer = (Stats::default(), (Watch::default(), drop));
        let mut frame = Frame::observed(tracer, self.settings.clone(), observer).map_err(|error| error.to_string())?;
        let most = most_work(&self.settings);
        let limit = if most > MOST { SOME } else { most };
        let step = u64::from(step).min(limit) as u32;
        // The last step may trace nothing. Where the steps of bent rays count too, a step of many rays may trace one, or only
        // look for a path to a light.
        let is_long = self.bends() && most <= MOST;
        let steps =
            if is_long { limit * (1 + self.scene.lights.len() as u64) } else { limit.div_ceil(step.into()) } + 1;
        let (mut is_done, mut before) = (false, 0);
        for _ in 0..steps {
            is_done = frame.step(step, &mut canvas).map_err(|error| error.to_string())? == Progress::Done;
            let rays = frame.observer().0.rays();
            require(rays - before <= u64::from(step), || format!("{} rays in a step of {step}", rays - before))?;
            before = rays;
            if is_done {
                break;
            }
        }
        require(is_done || most > MOST, || format!("not done after {steps} steps of {step}"))?;
        let (stats, watch) = (frame.observer().0, frame.observer().1.0);
        Ok(Rendered { canvas, stats, watch, dropped, is_done })
    }

    fn check_pixels(&self, rendered: &Rendered) -> Result<(), Fault> {
        let Rendered { canvas, stats, watch, dropped, is_done } = rendered;
        let (rows, budget) = (&self.settings.rows, &self.settings.budget);
        let (highest, lowest) = limits(self.scene, &self.settings, u64::from(budget.rays_per_pixel).min(200_000));
        for pixel in &canvas.pixels {
            let fine = |x: f32| {
                x.is_finite() && f64::from(x) >= lowest && (f64::from(x) <= highest || is_too_bright::<T>(highest))
            };
            let color = pixel.color;
            require(fine(color.r) && fine(color.g) && fine(color.b), || {
                format!("{pixel:?}, not from {lowest:e} to {highest:e}")
            })?;
            check_targets(color)?;
            require(rows.contains(&pixel.y) && pixel.x < self.settings.size.width, || format!("outside: {pixel:?}"))?;
        }
        require(canvas.is_each_once(), || "a pixel came twice".into())?;
        let all = u64::from(rows.end - rows.start) * u64::from(self.settings.size.width);
        let count = canvas.pixels.len();
        require(!is_done || count as u64 == all, || format!("{count} of {all} pixels"))?;
        require(watch.rays == stats.rays(), || format!("{} rays, not {}", stats.rays(), watch.rays))?;
        require(watch.most_rays <= u64::from(budget.rays_per_pixel), || {
            format!("{} rays in a pixel", watch.most_rays)
        })?;
        self.check_steps(stats, watch)?;
        require(watch.most_samples <= self.settings.sampling.most(), || "too many samples".into())?;
        require(watch.pixels == dropped.len(), || "a pixel was not told of".into())?;
        require(!watch.is_odd, || "a weight that was cut is no weight".into())
    }
}

impl<T: Real> Order<'_, T> {
    /// No ray, nor the search for a path to a light, takes more steps than it may.
    fn check_steps(&self, stats: &Stats, watch: &Watch) -> Result<(), Fault> {
        let most = self.settings.budget.steps_per_ray;
        require(watch.most_steps <= u32::from(most), || format!("{} steps of one ray", watch.most_steps))?;
        require(watch.steps == stats.steps, || format!("{} steps, not {}", stats.steps, watch.steps))?;
        let branches = stats.rays() - stats.shadow;
        let most = branches * (1 + self.scene.lights.len() as u64) * u64::from(most);
        require(stats.steps <= most, || format!("{} steps, more than {most}", stats.steps))?;
        require(self.bends() || *stats == Stats { steps: 0, captured: 0, cut_by_steps: 0, ..*stats }, || {
            format!("{stats:?}")
        })
    }
}

/// Whether the number type may overflow on the way, so that the largest number is right.
fn is_too_bright<T: Real>(highest: f64) -> bool {
    let is_wide = T::MAX.to_f32() != f32::MAX;
    highest > f64::from(f32::MAX) * if is_wide { 1.0 } else { 1e-3 }
}

/// The most steps of one ray that a frame can take.
fn most_work<T: Real>(settings: &Settings<T>) -> u64 {
    let pixels = u64::from(settings.size.width) * u64::from(settings.rows.end - settings.rows.start);
    let samples = u64::from(settings.sampling.most());
    let rays = u64::from(settings.budget.rays_per_pixel) / samples.max(1);
    // Besides the rays themselves, every branch that waits may be cut.
    pixels.saturating_mul(samples).saturating_mul(rays + 14)
}

/// The same settings in `f64`.
pub fn widened(settings: &Settings<f32>) -> Settings<f64> {
    let Settings { size, rows, order, sampling, budget } = settings.clone();
    let sampling = match sampling {
        Sampling::Grid(n) => Sampling::Grid(n),
        Sampling::Sequence(n) => Sampling::Sequence(n),
        Sampling::Adaptive { first, most, contrast } => Sampling::Adaptive { first, most, contrast: contrast.into() },
    };
    let Budget { depth, cutoff, rays_per_pixel, steps_per_ray, termination } = budget;
    let termination = match termination {
        Termination::Background => Termination::Background,
        Termination::Black => Termination::Black,
        Termination::Color(color) => Termination::Color(color.map(f64::from)),
    };
    Settings {
        size,
        rows,
        order,
        sampling,
        budget: Budget { depth, cutoff: cutoff.into(), rays_per_pixel, steps_per_ray, termination },
    }
}
