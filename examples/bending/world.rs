//! Scenes in which light is bent, for any number type.
//!
//! A world is described in `f64`; [`World::follow`] rounds it to the number type in question.

use whit::scene::{BlackHole, Index, Law, Level, Medium, Method, Profile, Steps};
use whit::{Background, Camera, Destination, Effects, Material, Object, Ray, Real, Rgb, Scene, Shape, Tracer, Vec3};

/// A point or a direction.
pub type Vector = [f64; 3];

/// A number type of the library and its way from and to `f64`.
pub trait Number: Real {
    fn of(x: f64) -> Self;
    fn get(self) -> f64;

    fn vector([x, y, z]: Vector) -> Vec3<Self> {
        Vec3::new(Self::of(x), Self::of(y), Self::of(z))
    }
}

impl Number for f32 {
    fn of(x: f64) -> Self {
        x as f32
    }
    fn get(self) -> f64 {
        f64::from(self)
    }
}

impl Number for f64 {
    fn of(x: f64) -> Self {
        x
    }
    fn get(self) -> f64 {
        self
    }
}

/// How a path starts.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    pub origin: Vector,
    /// Unit vector.
    pub direction: Vector,
}

/// Something that light may meet.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    Plane { point: Vector, normal: Vector },
    Sphere { center: Vector, radius: f64 },
}

/// What bends light.
#[derive(Clone, Copy, Debug)]
pub enum Bend<'a> {
    Nothing,
    Medium(Profile<'a, f64>),
    /// In the origin.
    Hole {
        mass: f64,
        steps: Steps<f64>,
    },
}

/// What bends light, and what it may meet.
#[derive(Clone, Debug)]
pub struct World<'a> {
    pub bend: Bend<'a>,
    pub targets: Vec<Target>,
}

/// Where a path ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    Surface { object: usize, point: Vector, direction: Vector, distance: f64 },
    Away(Vector),
    Captured,
    OutOfSteps,
}

/// A tracer of any scene.
pub type Any<'a, T> = Tracer<'a, T, { Effects::ALL.bits() }, 1, 1>;

impl World<'_> {
    /// Where a path ends that takes at most so many steps.
    pub fn follow<T: Number>(&self, start: &Start, steps: u16) -> End {
        self.with_tracer::<T, _>(|tracer| end(tracer.destination(&ray(start), steps)))
    }

    /// The fewest steps in which a path gets to its end; `None` if 65535 are too few.
    pub fn steps<T: Number>(&self, start: &Start) -> Option<u16> {
        self.with_tracer::<T, _>(|tracer| {
            let arrives = |steps| !matches!(tracer.destination(&ray::<T>(start), steps), Destination::OutOfSteps);
            let (mut low, mut high) = (0, 1);
            while !arrives(high) {
                low = high;
                high = high.checked_mul(2).or_else(|| (high < u16::MAX).then_some(u16::MAX))?;
            }
            // `high` are enough, and `low` are not, or are none.
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                *(if arrives(middle) { &mut high } else { &mut low }) = middle;
            }
            Some(high)
        })
    }

    /// Calls a function with the tracer of this world.
    pub fn with_tracer<T: Number, R>(&self, use_it: impl FnOnce(&Any<'_, T>) -> R) -> R {
        let white = Material::matte(Rgb::WHITE);
        let objects: Vec<_> = self.targets.iter().map(|target| Object::new(target.shape::<T>(), white)).collect();
        let (mut values, mut profiles) = (Vec::new(), Vec::new());
        if let Bend::Medium(profile) = &self.bend {
            if let Law::Table { values: table, .. } = profile.law {
                values = table.iter().map(|&x| T::of(x)).collect();
            }
            profiles.push(rounded(profile, &values));
        }
        let camera = Camera::with_half_height(T::vector(EYE), Vec3::ZERO, T::vector([0.0, 1.0, 0.0]), T::HALF);
        let mut scene = Scene::new(camera, Background::Solid(Rgb::WHITE)).with_objects(&objects);
        match self.bend {
            Bend::Nothing => {}
            Bend::Medium(_) => {
                let index = Index::Profile(0);
                scene = scene.with_profiles(&profiles).with_medium(Medium { index, ..Medium::VACUUM });
            }
            Bend::Hole { mass, steps } => {
                let hole = BlackHole { center: Vec3::ZERO, mass: T::of(mass), steps: steps_of(steps) };
                scene = scene.with_black_hole(hole);
            }
        }
        match Tracer::try_new(&scene) {
            Ok(tracer) => use_it(&tracer),
            Err(error) => panic!("{error}: {self:?}"),
        }
    }
}

/// Outside of every horizon; nothing is seen from here.
const EYE: Vector = [0.0, 0.0, 1e6];

impl Target {
    fn shape<T: Number>(&self) -> Shape<'static, T> {
        match *self {
            Self::Plane { point, normal } => Shape::plane(T::vector(point), T::vector(normal)),
            Self::Sphere { center, radius } => Shape::sphere(T::vector(center), T::of(radius)),
        }
    }
}

pub fn ray<T: Number>(start: &Start) -> Ray<T> {
    Ray { origin: T::vector(start.origin), direction: T::vector(start.direction) }
}

fn end<T: Number>(destination: Destination<T>) -> End {
    let double = |Vec3 { x, y, z }: Vec3<T>| [x, y, z].map(T::get);
    match destination {
        Destination::Surface(there) => End::Surface {
            object: there.object,
            point: double(there.point),
            direction: double(there.direction),
            distance: there.distance.get(),
        },
        Destination::Away(direction) => End::Away(double(direction)),
        Destination::Captured => End::Captured,
        Destination::OutOfSteps => End::OutOfSteps,
    }
}

/// A profile in another number type; `values` are those of its table, if it has one.
fn rounded<'b, T: Number>(profile: &Profile<'_, f64>, values: &'b [T]) -> Profile<'b, T> {
    let &Profile { level, from, to, law, method } = profile;
    let level = match level {
        Level::Height { origin, up } => Level::Height { origin: origin.map(T::of), up: up.map(T::of) },
        Level::Radius { center, radius } => Level::Radius { center: center.map(T::of), radius: T::of(radius) },
    };
    let method = match method {
        Method::Layers { thickness } => Method::Layers { thickness: T::of(thickness) },
        Method::Steps(steps) => Method::Steps(steps_of(steps)),
    };
    Profile { level, from: T::of(from), to: T::of(to), law: law_of(law, values), method }
}

fn law_of<'b, T: Number>(law: Law<'_, f64>, values: &'b [T]) -> Law<'b, T> {
    match law {
        Law::Polynomial { constant, linear, quadratic } => {
            Law::Polynomial { constant: T::of(constant), linear: T::of(linear), quadratic: T::of(quadratic) }
        }
        Law::Exponential { far, excess, scale } => {
            Law::Exponential { far: T::of(far), excess: T::of(excess), scale: T::of(scale) }
        }
        Law::Thermal { excess, ratio, scale } => {
            Law::Thermal { excess: T::of(excess), ratio: T::of(ratio), scale: T::of(scale) }
        }
        Law::Inversion { below, above, height, thickness } => Law::Inversion {
            below: T::of(below),
            above: T::of(above),
            height: T::of(height),
            thickness: T::of(thickness),
        },
        Law::FishEye { index, radius } => Law::FishEye { index: T::of(index), radius: T::of(radius) },
        Law::Table { spacing, .. } => Law::Table { spacing: T::of(spacing), values },
    }
}

fn steps_of<T: Number>(steps: Steps<f64>) -> Steps<T> {
    match steps {
        Steps::Fixed { length } => Steps::Fixed { length: T::of(length) },
        Steps::Controlled { tolerance } => Steps::Controlled { tolerance: T::of(tolerance) },
    }
}
