//! Scenes in which light is bent, for any number type.
//!
//! A world is described in `f64`; [`World::follow`] rounds it to the number type in question.

mod number;
mod rounded;

pub use number::Number;
use rounded::{profile_of, steps_of};
use whit::scene::{BlackHole, Index, Law, Medium, Profile, Steps};
use whit::{Background, Camera, Destination, Effects, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// A point or a direction.
pub type Vector = [f64; 3];

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

/// More steps than any path takes.
pub const ENOUGH: u16 = u16::MAX;

/// A tracer of certain effects.
pub type Certain<'a, T, const EFFECTS: u64> = Tracer<'a, T, EFFECTS, 1, 1>;
const ALL: u64 = Effects::ALL.bits();

impl World<'_> {
    /// Where a path ends that takes at most so many steps.
    pub fn follow<T: Number>(&self, start: &Start, steps: u16) -> End {
        self.with_tracer::<T, ALL, _>(|tracer| end(tracer.destination(&ray(start), steps)))
    }

    /// The fewest steps in which a path gets to its end; `None` if 65535 are too few.
    pub fn steps<T: Number>(&self, start: &Start) -> Option<u16> {
        self.with_tracer::<T, ALL, _>(|tracer| {
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
    pub fn with_tracer<T: Number, const EFFECTS: u64, R>(
        &self,
        use_it: impl FnOnce(&Certain<'_, T, EFFECTS>) -> R,
    ) -> R {
        let white = Material::matte(Rgb::WHITE);
        let objects: Vec<_> = self.targets.iter().map(|target| Object::new(target.shape::<T>(), white)).collect();
        let (mut values, mut profiles) = (Vec::new(), Vec::new());
        if let Bend::Medium(profile) = &self.bend {
            if let Law::Table { values: table, .. } = profile.law {
                values = table.iter().map(|&x| T::of(x)).collect();
            }
            profiles.push(profile_of(profile, &values));
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
            Err(error) => unreachable!("{error}: {self:?}"),
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
