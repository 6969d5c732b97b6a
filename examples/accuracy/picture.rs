//! Pictures of built-in scenes by a setting.

use std::collections::HashMap;
use std::time::Duration;

use palette::LinSrgb;
use rayon::prelude::*;
use whit::render::{Encoding, Settings, Size};
use whit::{Rgb, Scene, Stats};

use crate::difference::shown;
use crate::dispatch::{Kind, Picture};
use crate::number::{Number, with_number};
use crate::setting::Setting;
use crate::variant;

/// A built-in scene, ready to be traced by settings.
pub struct Subject {
    pub name: &'static str,
    pub scene: Scene<'static, f32>,
    pub size: Size,
    /// By what of a setting is in the scene's data.
    worlds: HashMap<String, World>,
}

type World = Result<Run, String>;
type Run = Box<dyn Fn(&mut Picture<'_>) -> Result<(), String> + Send + Sync>;

/// A picture and what it took.
pub struct Taken {
    pub pixels: Vec<Rgb<f32>>,
    pub stats: Stats,
    pub time: Duration,
}

impl Subject {
    pub fn new(name: &'static str, scene: Scene<'static, f32>, size: Size) -> Self {
        Self { name, scene, size, worlds: HashMap::new() }
    }

    /// The picture in linear light, as a display shows it.
    pub fn shown(&self, pixels: &[Rgb<f32>]) -> Vec<LinSrgb<f64>> {
        let encoding = Encoding::of(&self.scene);
        pixels.iter().map(|pixel| shown(pixel.map(f64::from), encoding)).collect()
    }

    /// A picture on one thread, timed.
    ///
    /// # Errors
    /// Why the number type or the library refuses the scene.
    pub fn take(&mut self, setting: &Setting) -> Result<Taken, String> {
        let size = self.size;
        let settings = setting.for_picture(size.width, size.height);
        let mut pixels = vec![Rgb::BLACK; size.pixels() as usize];
        let mut picture = Picture { settings, pixels: &mut pixels, stats: Stats::default(), time: Duration::ZERO };
        self.world(setting)?(&mut picture)?;
        let Picture { stats, time, .. } = picture;
        Ok(Taken { pixels, stats, time })
    }

    /// The same on all threads, not timed.
    ///
    /// # Errors
    /// As [`take`](Self::take).
    pub fn take_quickly(&mut self, setting: &Setting) -> Result<Taken, String> {
        let size = self.size;
        let settings = setting.for_picture(size.width, size.height);
        let mut pixels = vec![Rgb::BLACK; size.pixels() as usize];
        let run = self.world(setting)?;
        let row = |(y, pixels): (u32, &mut [Rgb<f32>])| {
            let settings = Settings { rows: y..y + 1, ..settings.clone() };
            let mut picture = Picture { settings, pixels, stats: Stats::default(), time: Duration::ZERO };
            run(&mut picture)?;
            Ok::<Stats, String>(picture.stats)
        };
        let rows = (0..size.height).into_par_iter().zip(pixels.par_chunks_mut(size.width as usize));
        let stats = rows.map(row).try_reduce(Stats::default, |a, b| Ok(a.plus(b)))?;
        Ok(Taken { pixels, stats, time: Duration::ZERO })
    }

    fn world(&mut self, setting: &Setting) -> Result<&Run, String> {
        let plain = Setting {
            number: setting.number,
            fresnel: setting.fresnel,
            spectrum: setting.spectrum,
            path: setting.path,
            offset: setting.offset,
            ..Setting::DEFAULT
        };
        let (name, scene) = (self.name, &self.scene);
        let world = self.worlds.entry(plain.to_string()).or_insert_with(|| {
            let scene = variant::of(scene, setting)?;
            with_number!(setting.number, prepare((name, Kind::from(setting), &scene)))
        });
        world.as_ref().map_err(Clone::clone)
    }
}

fn prepare<T: Number>((name, kind, scene): (&'static str, Kind, &Scene<'static, f32>)) -> World {
    let scene = T::scene(scene)?;
    Ok(Box::new(move |picture| T::trace(name, kind, &scene, picture)))
}
