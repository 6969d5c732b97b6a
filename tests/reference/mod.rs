//! A plain Whitted tracer to compare the library with: `f64`, recursive, every ray against every primitive. It shares
//! nothing with the library but the description of the scene.
#![allow(dead_code, unreachable_pub, missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![allow(clippy::indexing_slicing)]

pub mod aim;
pub mod bent;
pub mod camera;
pub mod compare;
pub mod complex;
pub mod cone;
pub mod film;
pub mod fresnel;
pub mod graded;
pub mod hole;
pub mod inside;
pub mod integrator;
pub mod law;
pub mod light;
pub mod medium;
pub mod nesting;
pub mod optics;
pub mod path;
pub mod profile;
pub mod shade;
pub mod shadow;
pub mod shapes;
pub mod spectrum;
pub mod stars;
pub mod touch;
pub mod vector;
pub mod walk;
pub mod world;

use std::ops::AddAssign;
use std::thread;

use whit::scene::{Channel, Scene, Tone};

use bent::Arrival;
use path::Bend;
use shapes::Ray;
use vector::{Color, Vector};
use world::{Hit, World};

/// The numbers in [0, 1)² of one sample, by dimension: 0 for the position in the pixel, 1 for the lens,
/// 2 + depth·(number of lights) + (place in the list) for a light at a point that a branch of that depth meets.
pub type Numbers<'a> = &'a dyn Fn(u32) -> [f64; 2];

/// How a picture is made.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub width: u32,
    pub height: u32,
    /// The largest number of bounces; 0 for eye rays alone.
    pub depth: u32,
    /// Branches with less throughput than this in every channel are cut; 0 for none.
    pub cutoff: f64,
    pub termination: Termination,
}

impl Settings {
    /// No cutoff, and the background for what is cut.
    pub const fn new(width: u32, height: u32, depth: u32) -> Self {
        Self { width, height, depth, cutoff: 0.0, termination: Termination::Background }
    }
}

/// The light of branches that are cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Termination {
    /// The background in the direction of the branch.
    Background,
    Black,
    Color([f64; 3]),
}

/// The samples of a pixel.
#[derive(Clone, Copy)]
pub struct Samples<'a> {
    pub count: u32,
    /// By column, row, sample and dimension.
    pub numbers: &'a (dyn Fn(u32, u32, u32, u32) -> [f64; 2] + Sync),
}

impl Samples<'_> {
    /// One sample: the middle of the pixel, of the lens and of the lights.
    pub const CENTRE: Samples<'static> = Samples { count: 1, numbers: &|_, _, _, _| [0.5, 0.5] };
}

/// Rays that were traced, by kind; branches that are cut are not traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub eye: u64,
    pub reflected: u64,
    pub transmitted: u64,
    pub shadow: u64,
    /// Rays that go straight on where an object meets one of a higher priority.
    pub passed: u64,
    /// Hits at which total internal reflection takes all the light.
    pub total_internal: u64,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.eye += other.eye;
        self.reflected += other.reflected;
        self.transmitted += other.transmitted;
        self.shadow += other.shadow;
        self.passed += other.passed;
        self.total_internal += other.total_internal;
    }
}

/// The pixels of a picture, row by row from the top, and the rays that it took.
pub fn render(scene: &Scene<'_, f32>, settings: &Settings, samples: &Samples<'_>) -> (Vec<[f64; 3]>, Counts) {
    const THREADS: usize = 2;
    let world = &World::new(scene);
    let mut picture = vec![[0.0; 3]; settings.width as usize * settings.height as usize];
    let mut rows: [Vec<_>; THREADS] = Default::default();
    for (y, row) in (0..).zip(picture.chunks_mut(settings.width as usize)) {
        rows[y as usize % THREADS].push((y, row));
    }
    let render_rows = |rows: Vec<(u32, &mut [[f64; 3]])>| {
        let mut counts = Counts::default();
        for (y, row) in rows {
            for (x, pixel) in (0..).zip(row) {
                *pixel = trace_pixel(world, settings, samples, [x, y], &mut counts);
            }
        }
        counts
    };
    let mut counts = Counts::default();
    thread::scope(|scope| {
        for thread in rows.map(|rows| scope.spawn(|| render_rows(rows))) {
            counts += thread.join().unwrap();
        }
    });
    (picture, counts)
}

/// One pixel: the mean of its samples, after the tone.
pub fn trace_pixel(
    world: &World<'_>,
    settings: &Settings,
    samples: &Samples<'_>,
    [x, y]: [u32; 2],
    counts: &mut Counts,
) -> [f64; 3] {
    let mut sum = Color::BLACK;
    for sample in 0..samples.count {
        let numbers = |dimension| (samples.numbers)(x, y, sample, dimension);
        let [s, t] = numbers(0);
        let position = [f64::from(x) + s, f64::from(y) + t];
        let ray = camera::eye_ray(&world.scene.camera, [settings.width, settings.height], position, &numbers);
        counts.eye += 1;
        sum += Branch::eye(world, settings, &numbers).trace(&ray, counts);
    }
    let light = sum * f64::from(samples.count).recip();
    match world.scene.tone {
        Tone::Linear => light.0,
        Tone::Display { gain, lift } => light.map(|channel| f64::from(lift) + f64::from(gain) * channel).0,
    }
}

/// A node of the ray tree.
#[derive(Clone, Copy)]
pub struct Branch<'a> {
    pub world: &'a World<'a>,
    pub settings: &'a Settings,
    pub numbers: Numbers<'a>,
    /// The number of bounces so far.
    pub depth: u32,
    /// The product of the weights so far.
    pub throughput: Color,
    /// The only channel of light that has been dispersed.
    pub channel: Option<Channel>,
}

impl<'a> Branch<'a> {
    /// The root of the tree.
    pub fn eye(world: &'a World<'a>, settings: &'a Settings, numbers: Numbers<'a>) -> Self {
        Self { world, settings, numbers, depth: 0, throughput: Color::WHITE, channel: None }
    }

    /// The light that comes along the ray.
    pub fn trace(&self, ray: &Ray, counts: &mut Counts) -> Color {
        if let Some(bend) = self.world.bend(ray) {
            return self.trace_bent(bend, ray, counts);
        }
        let Some(hit) = self.world.nearest(ray) else {
            let clarity = self.world.clarity(ray, f64::INFINITY, |_| true);
            return clarity * light::background(&self.world.scene.background, ray.direction);
        };
        let clarity = self.world.clarity(ray, hit.distance, |_| true);
        let branch = Self { throughput: self.throughput * clarity, ..*self };
        clarity * branch.shine(ray, &hit, counts)
    }

    /// The same where light is bent. None comes from behind a horizon.
    fn trace_bent(&self, bend: Bend<'_>, ray: &Ray, counts: &mut Counts) -> Color {
        match self.world.travel(bend, ray) {
            Arrival::Surface { ray: arriving, hit, length } => {
                let clarity = self.world.clarity_ahead(ray, length);
                let branch = Self { throughput: self.throughput * clarity, ..*self };
                clarity * branch.shine(&arriving, &hit, counts)
            }
            Arrival::Away { direction } => {
                let clarity = self.world.clarity_ahead(ray, f64::INFINITY);
                clarity * light::background(&self.world.scene.background, direction)
            }
            Arrival::Captured => Color::BLACK,
        }
    }

    /// The light that leaves a surface towards the ray's origin.
    fn shine(&self, ray: &Ray, hit: &Hit<'_>, counts: &mut Counts) -> Color {
        let Some(border) = self.world.border(ray, hit) else {
            counts.passed += 1;
            return self.trace(&hit.leave(ray.direction), counts);
        };
        let branches = optics::branches(hit, ray.direction, &border, self.world.scene.fresnel, self.channel);
        if branches.total_internal {
            counts.total_internal += 1;
        }
        let (own, sent) = shade::balance(&hit.object.material);
        let mut light =
            shade::local(self.world, hit, ray.direction, branches.body, self.depth, self.numbers, counts) * own;
        if let Some((weight, direction)) = branches.reflected {
            light += self.grow(weight * sent, &hit.leave(direction), counts, |counts| &mut counts.reflected);
        }
        for transmitted in branches.transmitted {
            let branch = Self { channel: transmitted.channel, ..*self };
            let ray = hit.leave(transmitted.direction);
            light += branch.grow(transmitted.weight * sent, &ray, counts, |counts| &mut counts.transmitted);
        }
        light
    }

    /// Weight × the light that comes along a branch, or the termination colour in its place.
    fn grow(&self, weight: Color, ray: &Ray, counts: &mut Counts, kind: fn(&mut Counts) -> &mut u64) -> Color {
        let branch = Self { depth: self.depth + 1, throughput: self.throughput * weight, ..*self };
        if branch.throughput == Color::BLACK {
            return Color::BLACK;
        }
        if branch.depth > self.settings.depth || branch.throughput.max_channel() < self.settings.cutoff {
            return weight * self.cut(ray.direction);
        }
        *kind(counts) += 1;
        weight * branch.trace(ray, counts)
    }

    fn cut(&self, direction: Vector) -> Color {
        match self.settings.termination {
            Termination::Background => light::background(&self.world.scene.background, direction),
            Termination::Black => Color::BLACK,
            Termination::Color(color) => Color(color),
        }
    }
}
