//! Where rays start that leave a surface.

use std::fmt;

use whit::{Intersection, Ray, Vec3};

/// A way to keep a ray from meeting the surface that it leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Origin {
    /// None: the ray starts where the formula for the point puts it.
    Point,
    /// A fixed distance along the new ray, or what is the same, a smallest t.
    AlongRay(f32),
    /// A fixed distance along the normal.
    AlongNormal(f32),
    /// Along the normal by a bound on the error of the point: what the library does.
    ErrorBound,
}

impl Origin {
    /// The ways that the lecture on ray tracing names, and none.
    pub const ALL: [Self; 6] = [
        Self::Point,
        Self::AlongRay(1e-6),
        Self::AlongRay(1e-3),
        Self::AlongNormal(1e-6),
        Self::AlongNormal(1e-3),
        Self::ErrorBound,
    ];

    /// The ray that goes on in `direction` where `ray` has met a surface.
    #[must_use]
    pub fn leave(self, ray: &Ray<f32>, hit: &Intersection<f32>, direction: Vec3<f32>) -> Ray<f32> {
        let point = ray.at(hit.distance);
        let origin = match self {
            Self::Point => point,
            Self::AlongRay(distance) => point + direction * distance,
            Self::AlongNormal(distance) if direction.dot(hit.normal) > 0.0 => point + hit.normal * distance,
            Self::AlongNormal(distance) => point - hit.normal * distance,
            Self::ErrorBound => hit.leave(direction).origin,
        };
        Ray { origin, direction }
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Point => f.write_str("the point itself"),
            Self::AlongRay(distance) => write!(f, "{distance:e} along the ray"),
            Self::AlongNormal(distance) => write!(f, "{distance:e} along the normal"),
            Self::ErrorBound => f.write_str("by the error bound"),
        }
    }
}
