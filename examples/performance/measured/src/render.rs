//! Whole pictures.

use std::path::Path;

use whit::render::{Encoding, LinearRgb, Size};
use whit::{Budget, Frame, Observer, Rgb, Settings, Stats, Tracer};

use crate::clock::timed;
use crate::files::write_picture;
use crate::layout::{DEPTH, Visitor};

/// Renders a picture of `size` pixels a side; prints the number of rays and the nanoseconds of the picture and of the
/// scene's being made ready.
pub struct Render<'a> {
    pub size: u32,
    pub picture: &'a Path,
}

impl Visitor for Render<'_> {
    fn visit<const EFFECTS: u64>(self, tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, build: f64) -> Result<(), String> {
        // The one that counts is for the caches, too.
        let (stats, _) = picture(tracer, self.size, Stats::default())?;
        let (done, time) = timed(|| picture(tracer, self.size, ()));
        let pixels = done?.1.into_iter();
        let bytes: Vec<u8> = pixels.flat_map(|color| Encoding::Srgb.encode8(color)).collect();
        write_picture(self.picture, self.size, &bytes)?;
        println!("{} {time} {build}", stats.rays());
        Ok(())
    }
}

/// Renders a picture under an observer.
pub fn picture<const EFFECTS: u64, O: Observer + Copy>(
    tracer: &Tracer<'_, f32, EFFECTS, DEPTH>,
    size: u32,
    observer: O,
) -> Result<(O, Vec<Rgb<f32>>), String> {
    let settings = Settings { budget: Budget::with_depth(DEPTH as u8), ..Settings::new(size, size) };
    let mut pixels = vec![Rgb::BLACK; size as usize * size as usize];
    let mut target = LinearRgb::new(Size::new(size, size), &mut pixels).map_err(|error| error.to_string())?;
    let mut frame = Frame::observed(tracer, settings, observer).map_err(|error| error.to_string())?;
    frame.render(&mut target).map_err(|error| error.to_string())?;
    Ok((*frame.observer(), pixels))
}
