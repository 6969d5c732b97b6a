//! Whatever is accepted renders without overflow, and to pixels that are in range.

use std::panic::{AssertUnwindSafe, catch_unwind};

use fixed::types::extra::{U12, U14, U18};
use rayon::prelude::*;
use whit::math::{Q, Q16, Q20};
use whit::render::{LinearRgb, Progress, Size};
use whit::{Frame, Real, Rgb, Scene, Settings, Tracer, Vec3};

use super::generator::{Buffer, Source};
use super::{ALL, cases};

/// No more steps than this are taken in a picture.
const STEPS: u32 = 40;

#[test]
fn any_scene_of_q16_renders_in_range() {
    run::<Q16>(cases(8000));
}

#[test]
fn any_scene_of_q20_renders_in_range() {
    run::<Q20>(cases(8000));
}

#[test]
fn any_scene_of_other_fractions_renders_in_range() {
    run::<Q<U12>>(cases(2000));
    run::<Q<U14>>(cases(2000));
    run::<Q<U18>>(cases(2000));
}

/// Tries scenes; many of them have to be accepted.
fn run<T: Real + Sync + Send>(count: u64) {
    let outcomes: Vec<_> = (0..count).into_par_iter().map(|case| (case, tried::<T>(case))).collect();
    let faults: Vec<_> = outcomes.iter().filter_map(|(case, outcome)| Some((case, outcome.as_ref().err()?))).collect();
    if let Some((case, fault)) = faults.first() {
        panic!("{} of {count} cases; case {case}: {fault}\n{:#?}", faults.len(), Source::new::<T>(**case).scene());
    }
    let accepted = outcomes.iter().filter(|(_, outcome)| outcome == &Ok(true)).count();
    assert!(accepted as u64 > count / 3, "only {accepted} of {count} were accepted");
}

/// Whether the scene of a case was accepted; what went wrong, if anything did.
fn tried<T: Real>(case: u64) -> Result<bool, String> {
    catch_unwind(AssertUnwindSafe(|| check::<T>(case))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        Err(text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.into())).unwrap_or_default())
    })
}

fn check<T: Real>(case: u64) -> Result<bool, String> {
    let mut source = Source::new::<T>(case);
    let scene = Buffer::<T>::from_scene(&source.scene().as_scene(), T::from_f32).unwrap();
    let scene = scene.as_scene();
    let Ok(tracer) = Tracer::<T, ALL, 10, 4>::try_new(&scene) else { return Ok(false) };
    check_frame(&tracer, source.settings())?;
    check_rays(&tracer, &mut source)?;
    Ok(true)
}

fn check_frame<T: Real>(tracer: &Tracer<'_, T, ALL, 10, 4>, settings: Settings<T>) -> Result<(), String> {
    let Size { width, height } = settings.size;
    let mut pixels = vec![Rgb::BLACK; (width * height) as usize];
    let mut target = LinearRgb::new(settings.size, &mut pixels).unwrap();
    let mut frame = Frame::new(tracer, settings).map_err(|error| error.to_string())?;
    for _ in 0..STEPS {
        if frame.step(100, &mut target).unwrap() == Progress::Done {
            break;
        }
    }
    let most = T::MAX.to_f32();
    let lowest = lowest(tracer.scene());
    let is_fine = |x: f32| (lowest..=most).contains(&x);
    match pixels.iter().find(|Rgb { r, g, b }| !(is_fine(*r) && is_fine(*g) && is_fine(*b))) {
        Some(pixel) => Err(format!("{pixel:?}")),
        None => Ok(()),
    }
}

/// The darkest pixel there can be.
fn lowest<T: Real>(scene: &Scene<'_, T>) -> f32 {
    match scene.tone {
        whit::Tone::Display { lift, .. } => lift.to_f32().min(0.0),
        whit::Tone::Linear => 0.0,
    }
}

fn check_rays<T: Real>(tracer: &Tracer<'_, T, ALL, 10, 4>, source: &mut Source) -> Result<(), String> {
    for _ in 0..20 {
        let ray = source.ray::<T>();
        let budget = whit::Budget { rays_per_pixel: 100, ..source.settings::<T>().budget };
        let Rgb { r, g, b } = tracer.trace(ray, &budget, &mut ());
        if [r, g, b].into_iter().any(|light| !(light >= T::ZERO && light <= T::MAX)) {
            return Err(format!("{r:?} {g:?} {b:?} along {ray:?}"));
        }
        let Some(met) = tracer.intersect(&ray) else { continue };
        let is_unit = (met.normal.length() - T::ONE).abs() < T::SMALLEST * T::from_f32(4.0);
        let is_near = met.point.largest_coordinate() <= 1.01 * T::OUTERMOST.to_f32();
        if !(met.distance > T::ZERO && is_unit && is_near) {
            return Err(format!("{met:?} along {ray:?}"));
        }
        let _ = met.leave(-ray.direction);
    }
    Ok(())
}

trait Largest {
    fn largest_coordinate(&self) -> f32;
}

impl<T: Real> Largest for Vec3<T> {
    fn largest_coordinate(&self) -> f32 {
        let Vec3 { x, y, z } = self.abs().map(T::to_f32);
        x.max(y).max(z)
    }
}
