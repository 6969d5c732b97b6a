//! What a user describes.

mod background;
mod buffer;
mod camera;
mod effects;
mod film;
mod hierarchy;
mod interface;
mod light;
mod material;
mod medium;
mod neighbours;
#[cfg(feature = "nff")]
pub mod nff;
mod object;
mod offset;
mod packed_spheres;
mod packing;
mod pattern;
mod profile;
pub mod scenes;
mod shape;
mod structure;
mod validate;

pub use background::Background;
pub use buffer::{Full, SceneBuf, SceneStore};
pub use camera::{Aperture, Camera, Extent, Lens};
pub use effects::Effects;
pub use film::{Film, Spectrum, Thickness};
pub(crate) use hierarchy::{Child, LEVELS, WIDTH};
pub use hierarchy::{Hierarchy, HierarchyBuf, Leaf, Node};
pub use interface::{Fresnel, Interface};
pub use light::{Emitter, Falloff, Light};
pub use material::{Balance, Body, Exponent, Highlight, Lobe, Material};
pub use medium::{Channel, Index, Medium};
pub use object::{Object, Shadow, Sides};
pub use offset::Offset;
pub(crate) use packed_spheres::{Around, Cluster};
pub use packed_spheres::{PackedSpheres, SphereList};
pub use pattern::Pattern;
pub(crate) use profile::Layers;
pub use profile::{BlackHole, Law, Level, Method, Profile, ShadowRays, Steps};
pub use shape::{Annulus, AxisBox, Cone, Disc, Plane, Shape, SmoothTriangle, Sphere, Triangle};
pub use validate::{Place, SceneError};

use crate::math::{Real, Vec3};

/// Everything that is rendered: a view over the caller's memory, flash or RAM.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scene<'a, T> {
    /// The eye.
    pub camera: Camera<T>,
    /// What rays see that meet nothing.
    pub background: Background<T>,
    /// What fills the space between the objects.
    pub medium: Medium<T>,
    /// How the reflectance of dielectrics and coats is computed.
    pub fresnel: Fresnel,
    /// The objects. Of surfaces that are equally near to a ray's origin, to 32 roundings of the distance, that of the first
    /// object is seen.
    pub objects: &'a [Object<'a, T>],
    /// The lights.
    pub lights: &'a [Light<T>],
    /// From light to the values of pixels.
    pub tone: Tone<T>,
    /// The profiles of media whose index of refraction varies; the media name them by number.
    pub profiles: &'a [Profile<'a, T>],
    /// A black hole.
    pub black_hole: Option<BlackHole<T>>,
    /// How shadow rays go where light is bent.
    pub shadow_rays: ShadowRays,
    /// How far from a surface the next ray starts.
    pub offset: Offset<T>,
    /// Boxes around the objects, for scenes of many.
    pub hierarchy: Option<Hierarchy<'a>>,
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
    /// An empty scene in a vacuum, with exact Fresnel reflectance and linear pixels.
    pub const fn new(camera: Camera<T>, background: Background<T>) -> Self {
        Self {
            camera,
            background,
            medium: Medium::VACUUM,
            fresnel: Fresnel::Exact,
            objects: &[],
            lights: &[],
            tone: Tone::Linear,
            profiles: &[],
            black_hole: None,
            shadow_rays: ShadowRays::Straight,
            offset: Offset::Bounded,
            hierarchy: None,
        }
    }

    /// The same scene with these objects, and no hierarchy.
    #[must_use]
    pub const fn with_objects(self, objects: &'a [Object<'a, T>]) -> Self {
        Self { objects, hierarchy: None, ..self }
    }

    /// The same scene with a hierarchy around its objects.
    #[must_use]
    pub const fn with_hierarchy(self, hierarchy: Hierarchy<'a>) -> Self {
        Self { hierarchy: Some(hierarchy), ..self }
    }

    /// The same scene with these lights.
    #[must_use]
    pub const fn with_lights(self, lights: &'a [Light<T>]) -> Self {
        Self { lights, ..self }
    }

    /// The same scene in another medium.
    #[must_use]
    pub const fn with_medium(self, medium: Medium<T>) -> Self {
        Self { medium, ..self }
    }

    /// The same scene with these profiles for its media to name.
    #[must_use]
    pub const fn with_profiles(self, profiles: &'a [Profile<'a, T>]) -> Self {
        Self { profiles, ..self }
    }

    /// The same scene with a black hole.
    #[must_use]
    pub const fn with_black_hole(self, hole: BlackHole<T>) -> Self {
        Self { black_hole: Some(hole), ..self }
    }

    /// The same scene with shadow rays that are bent as all light is.
    #[must_use]
    pub const fn with_bent_shadows(self) -> Self {
        Self { shadow_rays: ShadowRays::Bent, ..self }
    }

    /// The same scene with rays that start so far from the surfaces that they leave.
    #[must_use]
    pub const fn with_offset(self, offset: Offset<T>) -> Self {
        Self { offset, ..self }
    }

    /// The profile that an index of refraction names, if it names one.
    #[inline]
    pub(crate) fn profile(&self, index: &Index<T>) -> Option<&'a Profile<'a, T>> {
        match index {
            Index::Profile(number) => self.profiles.get(usize::from(*number)),
            Index::Constant(_) | Index::Dispersive(_) => None,
        }
    }

    /// An index of refraction at a point: one that names a profile as a constant, any other as it is.
    pub fn index_at(&self, index: Index<T>, point: Vec3<T>) -> Index<T> {
        self.index_for::<{ Effects::ALL.bits() }>(index, point)
    }

    /// An index of refraction at a point, by a tracer of these effects.
    #[inline]
    pub(crate) fn index_for<const EFFECTS: u64>(&self, index: Index<T>, point: Vec3<T>) -> Index<T> {
        match self.profile(&index) {
            Some(profile) if Effects::from_bits(EFFECTS).has(Effects::GRADED) => {
                Index::Constant(profile.index_at::<EFFECTS>(point))
            }
            _ => index,
        }
    }

    /// The same scene with the reflectance of dielectrics computed in another way.
    #[must_use]
    pub const fn with_fresnel(self, fresnel: Fresnel) -> Self {
        Self { fresnel, ..self }
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
