//! Boxes along the axes, in `f32` whatever the number type of the scene.

use crate::math::{LANES, Real, Vec3};
use crate::scene::{Shape, Sphere};

/// A box along the axes.
///
/// Its sides are as good as `f32` holds them. A search makes the boxes wider than by the roundings of all coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub low: [f32; 3],
    pub high: [f32; 3],
}

impl Bounds {
    pub(super) const NOTHING: Self = Self { low: [f32::MAX; 3], high: [f32::MIN; 3] };
    const EVERYTHING: Self = Self { low: [f32::MIN; 3], high: [f32::MAX; 3] };

    /// The box around part `part` of a shape; `None` past the last.
    pub(super) fn of_part<T: Real>(shape: &Shape<'_, T>, part: usize) -> Option<Self> {
        let Shape::Spheres(list) = shape else {
            return Self::of_f32_part(&shape.part(part, T::to_f32)?, 0);
        };
        let cluster = list.clusters.get(part)?;
        let spheres = (0..LANES).map_while(|lane| cluster.sphere(lane));
        let balls = spheres.map(|Sphere { center, radius }| Self::ball(center.map(T::to_f32), radius.to_f32()));
        Some(balls.fold(Self::NOTHING, Self::with))
    }

    /// The same of a shape in `f32`, in constant evaluation if asked there.
    #[allow(clippy::indexing_slicing)] // In range by the conditions; `get` is not const.
    pub(super) const fn of_f32_part(shape: &Shape<'_, f32>, part: usize) -> Option<Self> {
        match shape {
            Shape::Spheres(list) if part < list.clusters.len() => {
                let (mut bounds, mut lane) = (Self::NOTHING, 0);
                while let Some(Sphere { center, radius }) = list.clusters[part].sphere(lane) {
                    bounds = bounds.with(Self::ball(center, radius));
                    lane += 1;
                }
                Some(bounds)
            }
            Shape::Triangles(list) if part < list.len() => Some(Self::around(&list[part].vertices)),
            Shape::Spheres(_) | Shape::Triangles(_) => None,
            _ if part > 0 => None,
            Shape::Sphere(Sphere { center, radius }) => Some(Self::ball(*center, *radius)),
            Shape::Plane(_) => Some(Self::EVERYTHING),
            Shape::Disc(disc) => Some(Self::ball(disc.center, disc.radius)),
            Shape::Annulus(annulus) => Some(Self::ball(annulus.center, annulus.outer)),
            Shape::Box(axis_box) => Some(Self::around(&[axis_box.min, axis_box.max, axis_box.max])),
            Shape::Triangle(triangle) => Some(Self::around(&triangle.vertices)),
            Shape::SmoothTriangle(triangle) => Some(Self::around(&triangle.vertices)),
            Shape::Cone(c) => Some(Self::ball(c.base, c.base_radius).with(Self::ball(c.apex, c.apex_radius))),
        }
    }

    const fn ball(Vec3 { x, y, z }: Vec3<f32>, radius: f32) -> Self {
        let r = radius.abs();
        Self { low: [x - r, y - r, z - r], high: [x + r, y + r, z + r] }
    }

    const fn around([a, b, c]: &[Vec3<f32>; 3]) -> Self {
        Self::ball(*a, 0.0).with(Self::ball(*b, 0.0)).with(Self::ball(*c, 0.0))
    }

    /// The box around both.
    pub(super) const fn with(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.low, other.low);
        let low = [a.min(x), b.min(y), c.min(z)];
        let ([a, b, c], [x, y, z]) = (self.high, other.high);
        Self { low, high: [a.max(x), b.max(y), c.max(z)] }
    }

    /// Whether it has ends.
    pub(super) const fn is_finite(&self) -> bool {
        self.largest() < f32::MAX
    }

    /// The largest coordinate of a corner.
    pub(super) const fn largest(&self) -> f32 {
        let ([a, b, c], [x, y, z]) = (self.low, self.high);
        a.abs().max(b.abs()).max(c.abs()).max(x.abs()).max(y.abs()).max(z.abs())
    }

    /// Half of the surface.
    pub(super) const fn area(&self) -> f32 {
        let ([a, b, c], [x, y, z]) = (self.low, self.high);
        let (x, y, z) = (x - a, y - b, z - c);
        x * y + y * z + z * x
    }

    /// Twice the middle.
    pub(super) const fn middle(&self) -> [f32; 3] {
        let ([a, b, c], [x, y, z]) = (self.low, self.high);
        [a + x, b + y, c + z]
    }
}
