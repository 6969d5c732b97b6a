//! What a user describes.

mod background;
mod buffer;
mod camera;
mod effects;
mod light;
mod material;
#[cfg(feature = "nff")]
pub mod nff;
mod object;
mod packed_spheres;
mod pattern;
pub mod scenes;
mod shape;
mod validate;

pub use background::Background;
pub use buffer::{Full, SceneBuf, SceneStore};
pub use camera::{Aperture, Camera, Extent, Lens};
pub use effects::Effects;
pub use light::{Emitter, Falloff, Light};
pub use material::{Body, Exponent, Highlight, Interface, Lobe, Material};
pub use object::{Object, Shadow, Sides};
pub(crate) use packed_spheres::{Cluster, LANES};
pub use packed_spheres::{PackedSpheres, SphereList};
pub use pattern::Pattern;
pub use shape::{AxisBox, Cone, Disc, Plane, Shape, SmoothTriangle, Sphere, Triangle};
pub use validate::{Place, SceneError};

use crate::math::Real;

/// Everything that is rendered: a view over the caller's memory, flash or RAM.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scene<'a, T> {
    /// The eye.
    pub camera: Camera<T>,
    /// What rays see that meet nothing.
    pub background: Background<T>,
    /// Index of refraction of the medium that fills the space between the objects: 1 for a vacuum, and near enough
    /// for air.
    pub index: T,
    /// The objects. Where two are equally near to a ray's origin, the first one is seen.
    pub objects: &'a [Object<'a, T>],
    /// The lights.
    pub lights: &'a [Light<T>],
    /// From light to the values of pixels.
    pub tone: Tone<T>,
}

/// From light to the values of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tone<T> {
    /// Pixels hold linear light; the framebuffer encodes it (sRGB).
    Linear,
    /// Pixels hold `lift + gain · light`, already what the display shows; no encoding.
    Display {
        /// Factor.
        gain: T,
        /// What no light looks like.
        lift: T,
    },
}

impl<'a, T: Real> Scene<'a, T> {
    /// An empty scene in a vacuum, with linear pixels.
    pub const fn new(camera: Camera<T>, background: Background<T>) -> Self {
        Self { camera, background, index: T::ONE, objects: &[], lights: &[], tone: Tone::Linear }
    }

    /// The same scene with these objects.
    #[must_use]
    pub const fn with_objects(self, objects: &'a [Object<'a, T>]) -> Self {
        Self { objects, ..self }
    }

    /// The same scene with these lights.
    #[must_use]
    pub const fn with_lights(self, lights: &'a [Light<T>]) -> Self {
        Self { lights, ..self }
    }
}

impl<T: Real> Tone<T> {
    /// The same tone in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Tone<U> {
        match *self {
            Self::Linear => Tone::Linear,
            Self::Display { gain, lift } => Tone::Display { gain: f(gain), lift: f(lift) },
        }
    }
}
