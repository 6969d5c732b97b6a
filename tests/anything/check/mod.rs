//! What must hold for whatever is asked: an error that says what is wrong, or finite pixels within the budget.

mod bound;
mod canvas;
mod frame;
mod hierarchy;
mod lines;
mod nff;
mod rendered;
mod targets;
mod watch;

use whit::{Effects, Ray, Real, Scene, SceneBuf, Settings, Shape, Tracer};

use crate::generator::{Outcome, Run, text};
pub use nff::check_file;

/// What went wrong.
pub type Fault = String;

/// A tracer of all effects.
type Everything<'a, T, const DEPTH: usize, const MEDIA: usize> = Tracer<'a, T, { Effects::ALL.bits() }, DEPTH, MEDIA>;

/// A stack for 8 bounces in scenes with dispersion too.
const LARGE: usize = 10;

/// What is asked for, in one number type.
struct Order<'o, T> {
    scene: &'o Scene<'o, T>,
    settings: Settings<T>,
    step: u32,
    rays: Vec<Ray<T>>,
}

/// A run out of bytes.
///
/// # Errors
/// Says what does not hold, and for what.
pub fn check_bytes(bytes: &[u8]) -> Result<Outcome, Fault> {
    let run = Run::from_bytes(bytes);
    check_run(&run).map_err(|fault| format!("{fault}\n{run:?}"))
}

/// A file that looks like one, out of bytes.
///
/// # Errors
/// Says what does not hold, and for what.
pub fn check_text(bytes: &[u8]) -> Result<Outcome, Fault> {
    let text = text(bytes);
    check_file(text.as_bytes()).map_err(|fault| format!("{fault}\n{text}"))
}

fn check_run(run: &Run) -> Result<Outcome, Fault> {
    let objects = run.objects();
    let scene = run.scene(&objects);
    let outcome = check_scene(&scene, &run.settings, run.tracer, run.step, &run.rays)?;
    let is_odd =
        run.is_wild && outcome == Outcome::Rendered && has_odd_number(&format!("{scene:?} {:?}", run.settings));
    require(!is_odd, || "a number that is not finite was accepted".into())?;
    Ok(outcome)
}

/// Whether something that is not finite is written there.
fn has_odd_number(text: &str) -> bool {
    ["NaN", ": inf", ": -inf"].iter().any(|word| text.contains(word))
}

/// A scene in both number types.
fn check_scene(
    scene: &Scene<'_, f32>,
    settings: &Settings<f32>,
    tracer: u8,
    step: u32,
    rays: &[Ray<f32>],
) -> Result<Outcome, Fault> {
    require(scene.check().is_ok() == scene.validate().is_ok(), || "constants are validated differently".into())?;
    let order = Order { scene, settings: settings.clone(), step, rays: rays.to_vec() };
    let outcome = order.check(tracer)?;
    let Ok(wide) = SceneBuf::<f64, 128, 4, 4>::from_scene(scene, |x| widen(x, tracer)) else { return Ok(outcome) };
    let wide = wide.as_scene();
    // Of an empty list the copy has nothing that could be refused; of several faults in an object it may name another.
    let is_copied = scene.objects.iter().all(|object| object.shape != Shape::Triangles(&[]));
    require(!is_copied || wide.validate().is_ok() == scene.validate().is_ok(), || "f64 is refused differently".into())?;
    let rays = rays.iter().map(|ray| widen_ray(ray, tracer)).collect();
    Order { scene: &wide, settings: frame::widened(settings), step, rays }.check(tracer)?;
    Ok(outcome)
}

/// The same number, or for some tracers one that has more digits and rounds to it.
fn widen(x: f32, tracer: u8) -> f64 {
    let more = if tracer & 64 == 0 { 0.0 } else { 2.0_f64.powi(-40) };
    f64::from(x) * (1.0 + more)
}

fn widen_ray(ray: &Ray<f32>, tracer: u8) -> Ray<f64> {
    Ray { origin: ray.origin.map(|x| widen(x, tracer)), direction: ray.direction.map(f64::from).normalized() }
}

impl<T: Real> Order<'_, T> {
    /// Whether anything bends light.
    fn bends(&self) -> bool {
        self.scene.black_hole.is_some() || !self.scene.profiles.is_empty()
    }

    /// By one of several tracers.
    fn check(&self, tracer: u8) -> Result<Outcome, Fault> {
        match tracer % 4 {
            0 => self.check_with::<0>(|_| Ok(())),
            1 => self.check_with::<2>(|_| Ok(())),
            2 => self.check_with::<8>(|_| Ok(())),
            _ => self.check_with::<8>(|tracer| self.check_small_stack(tracer)),
        }
    }

    fn check_with<const MEDIA: usize>(
        &self,
        more: impl Fn(&Everything<'_, T, LARGE, MEDIA>) -> Result<(), Fault>,
    ) -> Result<Outcome, Fault> {
        let tracer = match Everything::<T, LARGE, MEDIA>::try_new(self.scene) {
            Ok(tracer) => tracer,
            Err(error) => {
                require(error.to_string().len() > 10, || format!("says little: {error}"))?;
                return Ok(Outcome::Refused);
            }
        };
        let outcome = self.check_frames(&tracer)?;
        if outcome == Outcome::Rendered {
            self.check_rays(&tracer)?;
            self.check_hierarchy(&tracer)?;
            more(&tracer)?;
        }
        Ok(outcome)
    }
}

fn require(holds: bool, fault: impl FnOnce() -> Fault) -> Result<(), Fault> {
    if holds { Ok(()) } else { Err(fault()) }
}
