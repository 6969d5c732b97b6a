//! One picture, rendered as far as asked and taken up again.

use core::fmt;
use core::ops::Range;

use super::order::{Cursor, Next};
use super::sampling::{Accumulator, Plan};
use super::view::View;
use super::{Framebuffer, Pixel, Settings, SettingsError, Size};
use crate::intersect::Ray;
use crate::math::{Real, Rgb};
use crate::scene::{Effects, Tone};
use crate::trace::{Budget, Context, Observer, RayTree, Samples, Sequence, Tracer};

/// Why rendering stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RenderError<E> {
    /// The framebuffer's size is not the frame's.
    Size {
        /// The frame's.
        frame: Size,
        /// The framebuffer's.
        framebuffer: Size,
    },
    /// The framebuffer's own error. Rendering goes on with the same call to the framebuffer.
    Framebuffer(E),
}

impl<E: fmt::Display> fmt::Display for RenderError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { frame, framebuffer } => write!(
                f,
                "the framebuffer has {}×{} pixels and the frame {}×{}",
                framebuffer.width, framebuffer.height, frame.width, frame.height
            ),
            Self::Framebuffer(error) => error.fmt(f),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for RenderError<E> {}

/// Whether there is more to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Rays are left to trace.
    More,
    /// Every pixel has been handed over.
    Done,
}

/// What the frame does next.
#[derive(Clone, Copy, Debug)]
enum Phase {
    /// Start the tree of the next sample and follow it.
    Sample,
    /// Go on with the tree of the current sample.
    Trace,
    /// Hand over a finished pixel once more, which the framebuffer has refused.
    Put(Rgb<f32>),
    /// Report the end of a row.
    EndRow(u32),
    /// Nothing.
    Done,
}

/// What following a tree came to.
enum Traced {
    /// The rays were used up first.
    Part,
    /// A sample is done, and its pixel is not.
    Sample,
    /// A pixel is done.
    Pixel(Rgb<f32>),
}

/// A picture, or some rows of one, that is rendered as far as asked.
///
/// Its memory is this value and nothing else. However it is stopped and taken up again, and in whatever parts of
/// the picture: the pixels have the same bits.
///
/// ```
/// use whit::render::{Frame, LinearRgb, Progress, Settings, Size};
/// let tracer = whit::tracer!(whit::scenes::SHOWCASE);
/// let mut pixels = [whit::Rgb::BLACK; 32 * 24];
/// let mut target = LinearRgb::new(Size::new(32, 24), &mut pixels).unwrap();
/// let mut frame = Frame::new(&tracer, Settings::new(32, 24)).unwrap();
/// while frame.step(100, &mut target).unwrap() == Progress::More {
///     // About 100 rays later: look after something else.
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Frame<'a, T: Real, const EFFECTS: u64, const DEPTH: usize, O = (), const MEDIA: usize = 0> {
    tracer: Tracer<'a, T, EFFECTS, DEPTH, MEDIA>,
    job: Job<T>,
    view: View<T>,
    cursor: Cursor,
    phase: Phase,
    pixel: Accumulator<T>,
    sequence: Sequence,
    tree: RayTree<'a, T, DEPTH, MEDIA>,
    observer: O,
}

/// What is asked of a frame, in the form in which it is worked off.
#[derive(Clone, Debug)]
struct Job<T> {
    size: Size,
    rows: Range<u32>,
    plan: Plan<T>,
    budget: Budget<T>,
    /// The share of one sample in the budget's rays.
    rays_per_sample: u32,
}

// What is asked of a frame of five bounces.
const _: () = assert!(size_of::<Frame<'_, f32, 0, 5>>() <= 1024);

impl<'a, T: Real, const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize> Frame<'a, T, EFFECTS, DEPTH, (), MEDIA> {
    /// A frame that is about to begin.
    ///
    /// # Errors
    /// Says which setting is out of its range.
    pub fn new(tracer: &Tracer<'a, T, EFFECTS, DEPTH, MEDIA>, settings: Settings<T>) -> Result<Self, SettingsError> {
        Self::observed(tracer, settings, ())
    }
}

impl<'a, T: Real, const EFFECTS: u64, const DEPTH: usize, O: Observer, const MEDIA: usize>
    Frame<'a, T, EFFECTS, DEPTH, O, MEDIA>
{
    /// A frame that tells an observer of its rays: [`Stats`](crate::Stats), [`Dropped`](crate::trace::Dropped), a
    /// pair of observers, or one's own.
    ///
    /// # Errors
    /// Says which setting is out of its range.
    pub fn observed(
        tracer: &Tracer<'a, T, EFFECTS, DEPTH, MEDIA>,
        settings: Settings<T>,
        observer: O,
    ) -> Result<Self, SettingsError> {
        settings.check(tracer.depth())?;
        let Settings { size, rows, order, sampling, budget } = settings;
        let cursor = Cursor::new(size.width, &rows, order);
        // At least one sample is taken, so that the division cannot trap.
        let rays_per_sample = budget.rays_per_pixel / sampling.most().max(1);
        Ok(Self {
            tracer: *tracer,
            view: View::new(&tracer.scene().camera, size),
            sequence: Sequence::new(cursor.x, cursor.y),
            cursor,
            job: Job { size, rows, plan: Plan::new(&sampling), budget, rays_per_sample },
            phase: Phase::Sample,
            pixel: Accumulator::EMPTY,
            tree: RayTree::new(),
            observer,
        })
    }

    /// Whether something besides the pixel itself is sampled.
    const SAMPLES: bool =
        Effects::from_bits(EFFECTS).has(Effects::LENS.with(Effects::SPHERE_LIGHT).with(Effects::PARALLELOGRAM_LIGHT));

    /// The observer.
    #[must_use]
    pub fn observer(&self) -> &O {
        &self.observer
    }

    /// Renders all that is left.
    ///
    /// # Errors
    /// Sizes that differ, or the framebuffer's own error, after which rendering can go on.
    pub fn render<F: Framebuffer>(&mut self, target: &mut F) -> Result<(), RenderError<F::Error>> {
        while self.step(u32::MAX, target)? == Progress::More {}
        Ok(())
    }

    /// Renders until `rays` more rays, shadow rays included, have been traced, or to the end of the frame. It may stop
    /// in the middle of a pixel. Each step of a bent ray counts as one more, and the last ray is taken to its end: in at most
    /// [`steps_per_ray`](crate::Budget::steps_per_ray) steps.
    ///
    /// # Errors
    /// Sizes that differ, or the framebuffer's own error, after which rendering can go on.
    pub fn step<F: Framebuffer>(&mut self, rays: u32, target: &mut F) -> Result<Progress, RenderError<F::Error>> {
        let (frame, framebuffer) = (self.job.size, target.size());
        if frame != framebuffer {
            return Err(RenderError::Size { frame, framebuffer });
        }
        let mut rays = rays;
        loop {
            let color = match self.phase {
                Phase::Sample | Phase::Trace => match self.trace(&mut rays) {
                    Traced::Pixel(color) => color,
                    Traced::Sample => continue,
                    Traced::Part => return Ok(Progress::More),
                },
                Phase::Put(color) => color,
                Phase::EndRow(y) => {
                    target.end_row(y).map_err(RenderError::Framebuffer)?;
                    self.phase = if self.cursor.cell == 0 { Phase::Done } else { Phase::Sample };
                    continue;
                }
                Phase::Done => return Ok(Progress::Done),
            };
            let Cursor { x, y, cell, .. } = self.cursor;
            if let Err(error) = target.put(Pixel { x, y, cell, color }) {
                self.phase = Phase::Put(color);
                return Err(RenderError::Framebuffer(error));
            }
            let next = self.cursor.advance(self.job.size.width, &self.job.rows);
            if Self::SAMPLES || self.job.plan.is_sequence() {
                self.sequence = Sequence::new(self.cursor.x, self.cursor.y);
            }
            self.phase = if next == Next::SameRow { Phase::Sample } else { Phase::EndRow(y) };
        }
    }

    fn samples(&self) -> Samples {
        Samples { sequence: self.sequence, index: self.pixel.count }
    }

    /// The eye ray of the current sample.
    #[inline]
    fn eye_ray(&self) -> Ray<T> {
        let samples = self.samples();
        let [s, t] = self.job.plan.position(&samples);
        let (x, y) = (T::from_u32(self.cursor.x) + s, T::from_u32(self.cursor.y) + t);
        self.view.ray::<EFFECTS>(x, y, || samples.point(Sequence::LENS))
    }

    /// Follows the tree of the current sample.
    fn trace(&mut self, rays: &mut u32) -> Traced {
        let scene = self.tracer.scene();
        if matches!(self.phase, Phase::Sample) {
            self.tree.start::<EFFECTS, O>(self.eye_ray(), self.job.rays_per_sample, scene, &mut self.observer);
        }
        let context = Context { scene, budget: &self.job.budget, samples: self.samples() };
        let Some(light) = self.tree.advance::<EFFECTS, O>(&context, rays, &mut self.observer) else {
            self.phase = Phase::Trace;
            return Traced::Part;
        };
        if !self.pixel.add(light, &self.job.plan) {
            self.phase = Phase::Sample;
            return Traced::Sample;
        }
        self.observer.pixel(self.cursor.x, self.cursor.y, self.pixel.count);
        let color = finite(self.tone(self.pixel.mean()).map(T::to_f32));
        self.pixel.clear();
        Traced::Pixel(color)
    }

    fn tone(&self, light: Rgb<T>) -> Rgb<T> {
        match self.tracer.scene().tone {
            Tone::Display { gain, lift } if Effects::from_bits(EFFECTS).has(Effects::DISPLAY_TONE) => {
                finite(light).map(|light| T::held(light.product(gain)).plus(lift))
            }
            _ => light,
        }
    }
}

/// Huge lights may overflow, and a finite pixel is promised. What is not a number would be black, not white.
#[inline]
fn finite<T: Real>(color: Rgb<T>) -> Rgb<T> {
    let is_finite = color.r.plus(color.g).plus(color.b).abs() <= T::MAX;
    if is_finite { color } else { color.max(Rgb::BLACK).min(Rgb::grey(T::MAX)) }
}
