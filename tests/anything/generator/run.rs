//! A whole run.

use whit::scene::{Medium, Offset, ShadowRays};
use whit::{Background, Camera, Fresnel, Light, Object, Ray, Scene, Settings, Tone};

use super::Source;
use super::bending::Bending;
use super::objects::Thing;
use super::span::{AMOUNT, LENGTH, POSITIVE};

/// A scene with the memory that it borrows from, and what is asked of it.
#[derive(Clone, Debug)]
pub struct Run {
    /// Whether its numbers may be out of their ranges.
    pub is_wild: bool,
    things: Vec<Thing>,
    lights: Vec<Light<f32>>,
    bending: Bending,
    offset: Offset<f32>,
    camera: Camera<f32>,
    background: Background<f32>,
    medium: Medium<f32>,
    fresnel: Fresnel,
    tone: Tone<f32>,
    pub settings: Settings<f32>,
    /// Which of several tracers renders it.
    pub tracer: u8,
    /// So many rays are traced in one step.
    pub step: u32,
    /// Rays to be traced apart from any picture.
    pub rays: Vec<Ray<f32>>,
}

/// What became of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The scene or the settings were refused.
    Refused,
    /// Pixels were rendered, and are as they should be.
    Rendered,
}

impl Run {
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let source = &mut Source::new(bytes);
        let things: Vec<_> = (0..1 + source.below(6)).map(|_| Thing::random(source)).collect();
        let lights = (0..source.below(4)).map(|_| source.light()).collect();
        let mut run = Self {
            is_wild: source.is_wild || source.is_spoiled,
            things,
            lights,
            camera: source.camera(),
            background: source.background(),
            medium: if source.once_in(3) { source.medium() } else { Medium::VACUUM },
            fresnel: source.pick(&[Fresnel::Exact, Fresnel::Schlick], Fresnel::Exact),
            tone: tone(source),
            settings: source.settings(),
            tracer: source.byte(),
            step: 1 + source.below(9) as u32,
            rays: (0..source.below(4)).map(|_| source.ray()).collect(),
            bending: Bending { profiles: Vec::new(), black_hole: None, shadow_rays: ShadowRays::Straight },
            offset: Offset::Bounded,
        };
        run.bend(source);
        if source.once_in(8) {
            run.offset = Offset::Fixed(source.number(POSITIVE));
        }
        run
    }

    fn bend(&mut self, source: &mut Source<'_>) {
        let bending = Bending::random(source, &mut self.settings);
        bending.medium(source, &mut self.medium);
        for thing in &mut self.things {
            bending.thing(source, thing);
        }
        self.background = source.stars(self.background);
        self.bending = bending;
    }

    pub fn objects(&self) -> Vec<Object<'_, f32>> {
        self.things.iter().map(Thing::object).collect()
    }

    /// The scene, of the objects above.
    pub fn scene<'a>(&'a self, objects: &'a [Object<'a, f32>]) -> Scene<'a, f32> {
        Scene {
            camera: self.camera,
            background: self.background,
            medium: self.medium,
            fresnel: self.fresnel,
            objects,
            lights: &self.lights,
            tone: self.tone,
            profiles: &self.bending.profiles,
            black_hole: self.bending.black_hole,
            shadow_rays: self.bending.shadow_rays,
            offset: self.offset,
            hierarchy: None,
        }
    }
}

fn tone(source: &mut Source<'_>) -> Tone<f32> {
    match source.below(6) {
        5 => Tone::Display { gain: source.number(AMOUNT), lift: source.number(LENGTH) },
        _ => Tone::Linear,
    }
}
