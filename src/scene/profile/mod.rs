//! Media whose index of refraction changes from place to place.

mod law;
mod layers;
mod steps;
mod table;

pub use law::Law;
pub(crate) use layers::Layers;
pub use steps::{BlackHole, Method, ShadowRays, Steps};

use super::Effects;
use crate::math::{Real, Vec3};

/// How the index of refraction of a medium varies, and how light is taken through it: air over a hot road, the
/// atmosphere of a planet, a lens of graded glass.
///
/// A scene lists its profiles ([`Scene::with_profiles`](crate::Scene::with_profiles)); a medium names one of them by its
/// number ([`Medium::graded`](super::Medium::graded)).
///
/// ```
/// use whit::scene::{Law, Level, Medium, Method, Profile, Steps};
/// use whit::{Background, Camera, Rgb, Scene, Vec3};
/// const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
/// // Air of 27 °C, 30 K hotter at the ground; the heat is gone some centimetres above it.
/// const AIR: [Profile<'static, f32>; 1] = [Profile {
///     level: Level::Height { origin: Vec3::ZERO, up: UP },
///     from: 0.0,
///     to: 0.3,
///     law: Law::warm_air(300.0, 30.0, 0.02),
///     method: Method::Steps(Steps::Controlled { tolerance: 1e-5 }),
/// }];
/// const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 1.5, 0.0), Vec3::new(0.0, 1.5, -1.0), UP, 2.0);
/// const SCENE: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(Rgb::WHITE))
///     .with_profiles(&AIR)
///     .with_medium(Medium::graded(0));
/// let tracer = whit::tracer!(SCENE);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile<'a, T> {
    /// What the index depends on.
    pub level: Level<T>,
    /// The lowest level at which it varies, in scene units; below, the index is what it is here.
    pub from: T,
    /// The highest level at which it varies, in scene units; above, the index is what it is here.
    pub to: T,
    /// The index by level.
    pub law: Law<'a, T>,
    /// How light is taken through it.
    pub method: Method<T>,
}

/// A number for every place, in scene units, that an index of refraction depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level<T> {
    /// The height (p − origin)·up: for layers of air that are flat.
    Height {
        /// Where it is 0.
        origin: Vec3<T>,
        /// Unit vector.
        up: Vec3<T>,
    },
    /// The height |p − centre| − radius over a ball: for an atmosphere, or, with the radius 0, for a lens.
    Radius {
        /// Centre.
        center: Vec3<T>,
        /// Where the level is 0.
        radius: T,
    },
}

/// The square of an index of refraction, less 1, and how fast it changes with the level. Air differs from a vacuum by
/// less than 3·10⁻⁴, so that n itself would have few digits left for what bends light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Square<T> {
    /// n² − 1
    pub excess: T,
    /// d(n²)/dℓ, in 1/scene unit.
    pub slope: T,
}

impl<T: Real> Profile<'_, T> {
    /// The index of refraction at a point; where the medium is cut into layers, that of the layer.
    pub fn index(&self, point: Vec3<T>) -> T {
        self.index_at::<{ Effects::ALL.bits() }>(point)
    }

    /// The index of refraction at a point, by a tracer of these effects.
    pub(crate) fn index_at<const EFFECTS: u64>(&self, point: Vec3<T>) -> T {
        let level = self.level.of::<EFFECTS>(point);
        let held = match self.method {
            Method::Layers { thickness } if Effects::from_bits(EFFECTS).has(Effects::LAYERS) => {
                self.layers(thickness).level_at(level)
            }
            _ => level.max(self.from).min(self.to),
        };
        (T::ONE + self.square::<EFFECTS>(held).excess).sqrt()
    }

    /// The layers that the medium is cut into.
    pub(crate) fn layers(&self, thickness: T) -> Layers<T> {
        let span = self.to - self.from;
        let count = (span / thickness).floor().max(T::ONE);
        Layers { from: self.from, to: self.to, count, thickness: span / count }
    }

    /// The square of the index at a level between `from` and `to`, and by the same law near them.
    #[inline]
    pub(crate) fn square<const EFFECTS: u64>(&self, level: T) -> Square<T> {
        self.law.square::<EFFECTS>(level, self.from)
    }

    /// The same profile in another number type; `None` for a table.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Option<Profile<'static, U>> {
        Some(self.map_with_law(self.law.map(&f)?, f))
    }

    /// The same profile in another number type, with a law that is already.
    pub(crate) fn map_with_law<'b, U: Real>(&self, law: Law<'b, U>, f: impl Fn(T) -> U) -> Profile<'b, U> {
        let level = match self.level {
            Level::Height { origin, up } => Level::Height { origin: origin.map(&f), up: up.map(&f) },
            Level::Radius { center, radius } => Level::Radius { center: center.map(&f), radius: f(radius) },
        };
        Profile { level, from: f(self.from), to: f(self.to), law, method: self.method.map(f) }
    }

    /// The smallest length over which the index changes its ways.
    pub(crate) fn feature(&self) -> T {
        self.law.feature().min(self.to - self.from)
    }
}

impl<T: Real> Level<T> {
    /// The level of a point.
    pub fn at(&self, point: Vec3<T>) -> T {
        self.of::<{ Effects::ALL.bits() }>(point)
    }

    /// The level of a point, by a tracer of these effects.
    #[inline]
    pub(crate) fn of<const EFFECTS: u64>(&self, point: Vec3<T>) -> T {
        match *self {
            Self::Height { origin, up } if Effects::from_bits(EFFECTS).has(Effects::HEIGHT_PROFILE) => {
                (point - origin).dot(up)
            }
            Self::Radius { center, radius } if Effects::from_bits(EFFECTS).has(Effects::RADIUS_PROFILE) => {
                (point - center).length() - radius
            }
            _ => T::ZERO,
        }
    }
}
