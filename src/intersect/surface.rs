//! A point on a surface, with a bound on how far rounding has moved it.

use super::Ray;
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Offset};

/// A point of a shape.
#[derive(Clone, Copy)]
pub(crate) struct Located<T> {
    /// The point, brought back onto the surface.
    pub point: Vec3<T>,
    /// Unit geometric normal, on the outside.
    pub normal: Vec3<T>,
    /// A bound on the absolute error of each coordinate of the point.
    pub error: Vec3<T>,
}

/// What is known of the point where a ray meets a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<T> {
    /// The point, brought back onto the surface.
    pub point: Vec3<T>,
    /// Unit geometric normal, on the outside.
    pub normal: Vec3<T>,
    /// Unit normal to shade with, on the outside; the geometric one but for smooth triangles.
    pub shading: Vec3<T>,
    /// From the point to the nearest place that is surely outside, along the normal.
    pub offset: Vec3<T>,
    /// The radius of curvature; `T::MAX` where the surface is flat.
    pub curvature_radius: T,
}

impl<T: Real> Surface<T> {
    /// The surface around a point, with this normal to shade with and this radius of curvature, left as the scene says.
    #[inline(always)]
    pub(crate) fn new<const EFFECTS: u64>(
        Located { point, normal, error }: Located<T>,
        shading: Vec3<T>,
        curvature_radius: T,
        offset: &Offset<T>,
    ) -> Self {
        let offset = match *offset {
            Offset::Fixed(distance) if Effects::from_bits(EFFECTS).has(Effects::FIXED_OFFSET) => normal * distance,
            _ => bounded(point, normal, error),
        };
        Self { point, normal, shading, offset, curvature_radius }
    }

    /// How far the normal may turn, as an angle, within the rounding of the point.
    pub(crate) fn turn(&self) -> T {
        let rounding = self.point.largest().roundings(8.0);
        if rounding < self.curvature_radius { rounding / self.curvature_radius } else { T::ONE }
    }

    /// The same place of a surface that is turned over unless a ray meets its front: what is outside is where the ray comes
    /// from.
    #[inline]
    pub(crate) fn facing(self, front: bool) -> Self {
        if front {
            return self;
        }
        Self { normal: -self.normal, shading: -self.shading, offset: -self.offset, ..self }
    }

    /// The normal to shade with, of which the compiler knows that it is the geometric one where no triangle is smooth.
    #[inline]
    pub(crate) fn shading<const EFFECTS: u64>(&self) -> Vec3<T> {
        if Effects::from_bits(EFFECTS).has(Effects::SMOOTH_TRIANGLE) { self.shading } else { self.normal }
    }

    /// How far along a ray in `direction`, from a contact at the distance `t`, the origin of the next ray may lie behind the
    /// surface, with room for the rounding of the contact.
    pub(crate) fn reach(&self, direction: Vec3<T>, t: T) -> T {
        let cosine = self.normal.dot(direction).abs().max(T::from_f32(1.0 / 16.0));
        T::from_f32(4.0) * self.offset.length() / cosine + t.roundings(if T::IS_FIXED { 16.0 } else { 64.0 })
    }

    /// A ray that leaves the surface: to the outside, or to the inside.
    #[inline]
    pub(crate) fn leave(&self, direction: Vec3<T>, outside: bool) -> Ray<T> {
        let origin = self.point + if outside { self.offset } else { -self.offset };
        Ray { origin, direction }
    }
}

/// The shift along the normal that takes a point with these errors surely across its surface.
///
/// The point lies in a box of half-sides `error` around the true one, which reaches Σ|nᵢ|·errorᵢ along the normal
/// (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 6.8.6). Adding the shift rounds each
/// coordinate once more, by up to u·|pᵢ|; twice that is added. No constant of the scene's size is involved.
#[inline]
fn bounded<T: Real>(point: Vec3<T>, normal: Vec3<T>, error: Vec3<T>) -> Vec3<T> {
    let rounding = point.abs().map(T::spacing);
    normal * normal.abs().dot(error + rounding)
}
