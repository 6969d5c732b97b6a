//! Which places are inside a primitive, by its geometry.

use super::shapes::{Meeting, Primitive, Ray};
use super::vector::Vector;

/// In no special direction, so that no line through a point of interest hits an edge.
const ANYWHERE: Vector = Vector::new(0.297_341, 0.618_977, -0.726_903);

impl Primitive {
    /// Whether the point is inside a solid: within it, or without it if its outside is turned inwards; behind a plane.
    /// A cone without caps holds what it would hold with them. Flat pieces have no inside.
    pub fn holds(&self, point: Vector) -> bool {
        match self {
            Self::Sphere { center, radius } => ((point - *center).length() < radius.abs()) == (*radius > 0.0),
            Self::Plane { point: on, normal } => (point - *on).dot(*normal) < 0.0,
            Self::Box { min, max } => {
                (0..3).all(|i| point.axes()[i] > min.axes()[i] && point.axes()[i] < max.axes()[i])
            }
            Self::Cone(cone) => {
                let (base, apex) = (Vector::from(cone.base), Vector::from(cone.apex));
                let (base_radius, apex_radius) = (f64::from(cone.base_radius), f64::from(cone.apex_radius));
                let axis = (apex - base).normalized();
                let along = (point - base).dot(axis);
                let share = along / (apex - base).length();
                let radius = base_radius.abs() * (1.0 - share) + apex_radius.abs() * share;
                let across = (point - base - axis * along).length();
                let within = (0.0..1.0).contains(&share) && across < radius;
                within == (base_radius >= 0.0 && apex_radius >= 0.0)
            }
            Self::Disc { .. } | Self::Annulus { .. } | Self::Triangle { .. } => false,
        }
    }

    /// How often a half line from the point crosses the primitive.
    pub fn crossings(&self, point: Vector) -> usize {
        let mut crossings = 0;
        self.meet(&Ray::new(point, ANYWHERE), None, &mut |meeting: Meeting| {
            crossings += usize::from(meeting.distance > 0.0);
        });
        crossings
    }
}
