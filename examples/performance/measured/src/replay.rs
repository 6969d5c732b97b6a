//! Rays from a file, one after another.

use std::path::Path;

use whit::{Ray, Tracer};

use crate::clock::timed;
use crate::files::write;
use crate::layout::{DEPTH, Visitor};
use crate::rays::Rays;

/// Looks for what each ray meets; prints nanoseconds for the scene's being made ready, for all rays that look for the nearest
/// surface, and for all that look for any. Writes, for each ray, the distance to the nearest, infinite for none; or 1 where there is any, and else 0.
pub struct Replay<'a> {
    pub rays: &'a Rays,
    pub answers: &'a Path,
}

impl Visitor for Replay<'_> {
    fn visit<const EFFECTS: u64>(self, tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, build: f64) -> Result<(), String> {
        let Rays { closest, shadow } = self.rays;
        let (mut distances, mut hidden) = (vec![0.0_f32; closest.len()], vec![0.0_f32; shadow.len()]);
        let mut times = [0.0; 2];
        // The first time is for the caches.
        for _ in 0..2 {
            let look = || distances.iter_mut().zip(closest).for_each(|(place, ray)| *place = distance(tracer, ray));
            let ((), for_closest) = timed(look);
            let look = || hidden.iter_mut().zip(shadow).for_each(|(place, ray)| *place = is_hidden(tracer, ray));
            let ((), for_shadow) = timed(look);
            times = [for_closest, for_shadow];
        }
        let bytes: Vec<u8> = distances.iter().chain(&hidden).flat_map(|answer| answer.to_le_bytes()).collect();
        write(self.answers, &bytes)?;
        println!("{build} {} {}", times[0], times[1]);
        Ok(())
    }
}

fn distance<const EFFECTS: u64>(tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, ray: &Ray<f32>) -> f32 {
    tracer.intersect(ray).map_or(f32::INFINITY, |there| there.distance)
}

fn is_hidden<const EFFECTS: u64>(tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, (ray, distance): &(Ray<f32>, f32)) -> f32 {
    f32::from(tracer.is_occluded(ray, *distance))
}
