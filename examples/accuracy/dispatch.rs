//! Tracers for the built-in scenes and their variants, each compiled for just its own effects.

use std::convert::Infallible;
use std::time::Duration;

use cpu_time::ThreadTime;
use whit::render::{ForEach, Pixel, Sampling, Settings};
use whit::scene::Fresnel;
use whit::{Budget, Effects, Frame, Real, Rgb, Scene, Stats, Termination, Tracer};

use crate::setting::{Path, Setting, SpectrumName};

/// The deepest tree.
pub const DEPTH: usize = 24;

/// What of a setting changes the code that a scene calls for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    fresnel: Fresnel,
    /// The spectrum of all films, if it is not the scene's own.
    spectrum: Effects,
    /// The steps of all paths, if they are not the scene's own.
    steps: Effects,
    /// That rays leave surfaces at a fixed distance, if they do.
    offset: Effects,
}

/// What is traced, and what came of it.
pub struct Picture<'p> {
    pub settings: Settings<f32>,
    /// Of the rows that are asked for.
    pub pixels: &'p mut [Rgb<f32>],
    pub stats: Stats,
    /// Of the processor, whatever else it did in between.
    pub time: Duration,
}

impl From<&Setting> for Kind {
    fn from(setting: &Setting) -> Self {
        let spectrum = match setting.spectrum {
            SpectrumName::Own => Effects::NONE,
            SpectrumName::Wavelengths => Effects::FILM_WAVELENGTHS,
            SpectrumName::Bands(_) => Effects::FILM_BANDS,
            SpectrumName::Table => Effects::FILM_TABLE,
        };
        let steps = match setting.path {
            Path::Own => Effects::NONE,
            Path::Fixed(_) => Effects::FIXED_STEPS,
            Path::Controlled(_) => Effects::CONTROLLED_STEPS,
            Path::Layers(_) => Effects::LAYERS,
        };
        let offset = if setting.offset.is_some() { Effects::FIXED_OFFSET } else { Effects::NONE };
        Self { fresnel: setting.fresnel, spectrum, steps, offset }
    }
}

/// Those of a scene in which one of a group of effects takes the place of the others.
const fn replaced(effects: Effects, group: Effects, by: Effects) -> Effects {
    if effects.has(group) && !by.is_empty() { effects.without(group).with(by) } else { effects }
}

/// Those of a variant of a scene with these effects.
const fn varied(effects: Effects, spectrum: Effects, steps: Effects) -> Effects {
    const SPECTRA: Effects = Effects::FILM_WAVELENGTHS.with(Effects::FILM_BANDS).with(Effects::FILM_TABLE);
    const STEPS: Effects = Effects::FIXED_STEPS.with(Effects::CONTROLLED_STEPS).with(Effects::LAYERS);
    replaced(replaced(effects, SPECTRA, spectrum), STEPS, steps)
}

/// With spheres that are objects of their own.
const fn unpack(effects: Effects) -> Effects {
    replaced(effects, Effects::SPHERES, Effects::SPHERE)
}

/// With spheres in lists.
const fn keep(effects: Effects) -> Effects {
    effects
}

macro_rules! tracers {
    ($module:ident, $unpack:ident, $kinds:ident) => {
        pub mod $module {
            use super::*;

            /// Traces a variant of a built-in scene.
            pub fn trace<T: Real>(
                name: &str,
                kind: Kind,
                scene: &Scene<'static, T>,
                picture: &mut Picture<'_>,
            ) -> Result<(), String> {
                with_built_in!(scenes(name, kind, scene, picture, $unpack, $kinds;))
            }
        }
    };
}

macro_rules! scenes {
    ($name:expr, $kind:expr, $scene:expr, $picture:expr, $unpack:ident, $kinds:ident; $($built_in:ident)*) => {
        match $name {
            $(name if name.eq_ignore_ascii_case(stringify!($built_in)) => {
                $kinds!($kind, $scene, $picture, $unpack, $built_in)
            })*
            name => Err(format!("this program has no tracer for the scene `{name}`: is it built with --release?")),
        }
    };
}

macro_rules! all_kinds {
    ($($arguments:tt)*) => {
        kinds!($($arguments)*;
            (Exact, NONE, NONE, NONE) (Exact, NONE, NONE, FIXED_OFFSET)
            (Exact, NONE, FIXED_STEPS, NONE) (Exact, NONE, CONTROLLED_STEPS, NONE) (Exact, NONE, LAYERS, NONE)
            (Exact, FILM_WAVELENGTHS, NONE, NONE) (Exact, FILM_BANDS, NONE, NONE) (Exact, FILM_TABLE, NONE, NONE)
            (Schlick, NONE, NONE, NONE)
            (Schlick, NONE, FIXED_STEPS, NONE) (Schlick, NONE, CONTROLLED_STEPS, NONE) (Schlick, NONE, LAYERS, NONE)
            (Schlick, FILM_WAVELENGTHS, NONE, NONE) (Schlick, FILM_BANDS, NONE, NONE)
            (Schlick, FILM_TABLE, NONE, NONE))
    };
}

/// What the reference needs.
macro_rules! finest_kinds {
    ($($arguments:tt)*) => {
        kinds!($($arguments)*; (Exact, NONE, NONE, NONE) (Exact, NONE, CONTROLLED_STEPS, NONE)
            (Exact, FILM_BANDS, NONE, NONE))
    };
}

macro_rules! own_kind {
    ($($arguments:tt)*) => {
        kinds!($($arguments)*; (Exact, NONE, NONE, NONE))
    };
}

macro_rules! kinds {
    ($kind:expr, $scene:expr, $picture:expr, $unpack:ident, $built_in:ident;
        $(($fresnel:ident, $spectrum:ident, $steps:ident, $offset:ident))*) => {
        match ($kind.fresnel, $kind.spectrum, $kind.steps, $kind.offset) {
            $((Fresnel::$fresnel, Effects::$spectrum, Effects::$steps, Effects::$offset) => {
                const SCENE: Scene<'static, f32> = whit::scenes::$built_in.with_fresnel(Fresnel::$fresnel);
                const EFFECTS: u64 =
                    varied($unpack(SCENE.effects()), Effects::$spectrum, Effects::$steps).with(Effects::$offset).bits();
                frame::<T, EFFECTS, { SCENE.stack(DEPTH) }, { SCENE.media() }>($scene, $picture)
            })*
            _ => Err("this program has no tracer of that kind".to_owned()),
        }
    };
}

tracers!(packed, keep, all_kinds);
tracers!(unpacked, unpack, own_kind);
tracers!(finest, unpack, finest_kinds);

fn frame<T: Real, const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize>(
    scene: &Scene<'static, T>,
    picture: &mut Picture<'_>,
) -> Result<(), String> {
    let Picture { settings, pixels, stats, time } = picture;
    let tracer = Tracer::<T, EFFECTS, DEPTH, MEDIA>::try_new(scene).map_err(|error| error.to_string())?;
    let (width, first) = (settings.size.width as usize, settings.rows.start);
    let mut target = ForEach::new(settings.size, |pixel: Pixel| {
        if let Some(place) = pixels.get_mut((pixel.y - first) as usize * width + pixel.x as usize) {
            *place = pixel.color;
        }
        Ok::<(), Infallible>(())
    });
    let started = ThreadTime::now();
    let frame = Frame::observed(&tracer, in_type(settings), Stats::default());
    let mut frame = frame.map_err(|error| error.to_string())?;
    let Ok(()) = frame.render(&mut target) else { return Err("the picture was not finished".to_owned()) };
    *time = started.elapsed();
    *stats = *frame.observer();
    Ok(())
}

/// Settings in another number type.
fn in_type<T: Real>(settings: &Settings<f32>) -> Settings<T> {
    let budget = settings.budget;
    Settings {
        size: settings.size,
        rows: settings.rows.clone(),
        order: settings.order,
        sampling: match settings.sampling {
            Sampling::Grid(n) => Sampling::Grid(n),
            Sampling::Sequence(n) => Sampling::Sequence(n),
            Sampling::Adaptive { first, most, contrast } => {
                Sampling::Adaptive { first, most, contrast: T::from_f32(contrast) }
            }
        },
        budget: Budget {
            depth: budget.depth,
            cutoff: T::from_f32(budget.cutoff),
            rays_per_pixel: budget.rays_per_pixel,
            steps_per_ray: budget.steps_per_ray,
            termination: match budget.termination {
                Termination::Background => Termination::Background,
                Termination::Black => Termination::Black,
                Termination::Color(color) => Termination::Color(color.map(T::from_f32)),
            },
        },
    }
}
