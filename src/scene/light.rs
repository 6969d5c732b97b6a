//! Where light comes from.

use crate::math::{Real, Rgb, Vec3};

/// A light of one colour.
///
/// A surface that a light lies on, to 2⁻¹³ of the light's distance, does not hide it from other surfaces; the surface itself
/// is not lit by a light in its plane, nor a point by a light that is just there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light<T> {
    /// Where it is.
    pub emitter: Emitter<T>,
    /// Colour and intensity L; without a falloff, what arrives at any distance.
    pub color: Rgb<T>,
    /// Attenuation by distance.
    pub falloff: Option<Falloff<T>>,
}

/// The place and the form of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emitter<T> {
    /// A point.
    Point {
        /// Where.
        position: Vec3<T>,
    },
    /// A direction at infinity.
    Directional {
        /// Towards the light, of any length but zero.
        towards: Vec3<T>,
    },
    /// A ball, not seen itself, not by an eye inside it either; sampled as the disc that a point sees of it. One shadow ray is sent per surface point: soft shadows
    /// come from several samples a pixel.
    Sphere {
        /// Centre.
        center: Vec3<T>,
        /// Radius.
        radius: T,
    },
    /// A parallelogram that shines to both sides, sampled evenly, one shadow ray per surface point.
    Parallelogram {
        /// A corner.
        corner: Vec3<T>,
        /// The edge from that corner in one direction.
        edge_u: Vec3<T>,
        /// The edge from that corner in the other direction.
        edge_v: Vec3<T>,
    },
}

/// Attenuation by distance d: L/(constant + linear·d + quadratic·d²). Directional lights have none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Falloff<T> {
    /// Constant part, above 0 so that a light on a surface stays finite.
    pub constant: T,
    /// Linear part, in 1/scene unit.
    pub linear: T,
    /// Quadratic part, in 1/scene unit².
    pub quadratic: T,
}

impl<T: Real> Light<T> {
    /// A point light of the same intensity at any distance.
    pub const fn point(position: Vec3<T>, color: Rgb<T>) -> Self {
        Self { emitter: Emitter::Point { position }, color, falloff: None }
    }

    /// A light at infinity.
    pub const fn directional(towards: Vec3<T>, color: Rgb<T>) -> Self {
        Self { emitter: Emitter::Directional { towards }, color, falloff: None }
    }

    /// A ball of light.
    pub const fn sphere(center: Vec3<T>, radius: T, color: Rgb<T>) -> Self {
        Self { emitter: Emitter::Sphere { center, radius }, color, falloff: None }
    }

    /// The same light, attenuated by distance.
    #[must_use]
    pub const fn with_falloff(self, falloff: Falloff<T>) -> Self {
        Self { falloff: Some(falloff), ..self }
    }

    /// The same light in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Light<U> {
        Light {
            emitter: match self.emitter {
                Emitter::Point { position } => Emitter::Point { position: position.map(&f) },
                Emitter::Directional { towards } => Emitter::Directional { towards: towards.map(&f) },
                Emitter::Sphere { center, radius } => Emitter::Sphere { center: center.map(&f), radius: f(radius) },
                Emitter::Parallelogram { corner, edge_u, edge_v } => {
                    Emitter::Parallelogram { corner: corner.map(&f), edge_u: edge_u.map(&f), edge_v: edge_v.map(&f) }
                }
            },
            color: self.color.map(&f),
            falloff: self.falloff.map(|falloff| Falloff {
                constant: f(falloff.constant),
                linear: f(falloff.linear),
                quadratic: f(falloff.quadratic),
            }),
        }
    }
}
