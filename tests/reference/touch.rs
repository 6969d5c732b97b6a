//! Which primitives a piece of a curve may meet.

use super::shapes::Primitive;
use super::vector::Vector;

/// All places within a distance of a line between two points.
#[derive(Clone, Copy, Debug)]
pub struct Capsule {
    pub from: Vector,
    pub to: Vector,
    pub radius: f64,
}

impl Capsule {
    /// The smallest distance of the line from a point, and the largest.
    fn distances(&self, point: Vector) -> [f64; 2] {
        let (along, to_point) = (self.to - self.from, point - self.from);
        let square = along.dot(along);
        let share = if square > 0.0 { (to_point.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        [(to_point - along * share).length(), to_point.length().max((point - self.to).length())]
    }

    fn meets_ball(&self, center: Vector, radius: f64) -> bool {
        self.distances(center)[0] <= radius + self.radius
    }

    fn meets_shell(&self, center: Vector, radius: f64) -> bool {
        self.meets_ball(center, radius) && self.distances(center)[1] >= radius - self.radius
    }

    fn meets_plane(&self, point: Vector, normal: Vector) -> bool {
        let [a, b] = [self.from, self.to].map(|end| (end - point).dot(normal));
        a.min(b) <= self.radius && a.max(b) >= -self.radius
    }

    /// A box, but not its inside.
    fn meets_faces(&self, min: Vector, max: Vector) -> bool {
        let ends = [self.from.axes(), self.to.axes()];
        let (mut apart, mut inside) = (false, true);
        for (axis, (low, high)) in min.axes().into_iter().zip(max.axes()).enumerate() {
            let (a, b) = (ends[0][axis].min(ends[1][axis]), ends[0][axis].max(ends[1][axis]));
            apart |= b + self.radius < low || a - self.radius > high;
            inside &= a - self.radius > low && b + self.radius < high;
        }
        !apart && !inside
    }
}

impl Primitive {
    /// Whether its surface may reach into a capsule; false only if it does not.
    pub fn may_touch(&self, capsule: &Capsule) -> bool {
        match self {
            Self::Sphere { center, radius } => capsule.meets_shell(*center, radius.abs()),
            Self::Plane { point, normal } => capsule.meets_plane(*point, *normal),
            Self::Disc { center, normal, radius } => {
                capsule.meets_plane(*center, *normal) && capsule.meets_ball(*center, *radius)
            }
            Self::Annulus { center, normal, outer, .. } => {
                capsule.meets_plane(*center, *normal) && capsule.meets_ball(*center, *outer)
            }
            Self::Box { min, max } => capsule.meets_faces(*min, *max),
            Self::Triangle { vertices: [a, b, c], .. } => {
                let normal = (*b - *a).cross(*c - *a);
                let center = (*a + *b + *c) * (1.0 / 3.0);
                let radius = [*a, *b, *c].map(|corner| (corner - center).length()).into_iter().fold(0.0, f64::max);
                let plane = normal.length() == 0.0 || capsule.meets_plane(*a, normal.normalized());
                plane && capsule.meets_ball(center, radius)
            }
            Self::Cone(cone) => {
                let (base, apex) = (Vector::from(cone.base), Vector::from(cone.apex));
                let widest = f64::from(cone.base_radius.abs().max(cone.apex_radius.abs()));
                capsule.meets_ball((base + apex) * 0.5, (0.5 * (apex - base).length()).hypot(widest))
            }
        }
    }
}
