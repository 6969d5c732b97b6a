//! Which objects a piece of a bent path may meet.

use super::search::has;
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Object, Shape, Sphere};

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds<T> {
    low: Vec3<T>,
    high: Vec3<T>,
}

impl<T: Real> Bounds<T> {
    /// The box around some points, with room for the rounding of their coordinates.
    pub(crate) fn around(points: &[Vec3<T>]) -> Self {
        let mut bounds = Self { low: Vec3::splat(T::MAX), high: Vec3::splat(-T::MAX) };
        for point in points {
            bounds = Self { low: bounds.low.min(*point), high: bounds.high.max(*point) };
        }
        bounds.wider(bounds.low.largest().max(bounds.high.largest()) * (T::from_f32(32.0) * T::ROUNDOFF))
    }

    fn ball(center: Vec3<T>, radius: T) -> Self {
        Self { low: center, high: center }.wider(radius)
    }

    fn wider(self, by: T) -> Self {
        Self { low: self.low - Vec3::splat(by), high: self.high + Vec3::splat(by) }
    }

    fn overlaps(&self, other: &Self) -> bool {
        let apart = |low: T, high: T, from: T, to: T| low > to || high < from;
        !(apart(self.low.x, self.high.x, other.low.x, other.high.x)
            || apart(self.low.y, self.high.y, other.low.y, other.high.y)
            || apart(self.low.z, self.high.z, other.low.z, other.high.z))
    }

    /// Whether the plane through `point` across `normal` cuts the box.
    fn cuts(&self, point: Vec3<T>, normal: Vec3<T>) -> bool {
        let half = (self.high - self.low) * T::HALF;
        let height = (self.low + half - point).dot(normal);
        let rounding = normal.abs().dot(self.low.abs().max(self.high.abs()).max(point.abs()));
        height.abs() <= normal.abs().dot(half) + rounding * (T::from_f32(8.0) * T::ROUNDOFF)
    }

    /// A distance that no point of the box is nearer than.
    fn distance(&self, point: Vec3<T>) -> T {
        let outside = (self.low - point).max(point - self.high).max(Vec3::splat(T::ZERO)).length();
        let size = point.largest().max(self.low.largest()).max(self.high.largest());
        outside - size * (T::from_f32(16.0) * T::ROUNDOFF)
    }

    /// Whether the surface of a sphere reaches into the box.
    fn touches(&self, sphere: &Sphere<T>) -> bool {
        let zero = Vec3::splat(T::ZERO);
        let (below, above) = (self.low - sphere.center, sphere.center - self.high);
        let nearest = below.max(above).max(zero).length();
        let farthest = below.abs().max(above.abs()).length();
        let radius = sphere.radius.abs();
        let slack = (farthest + radius) * (T::from_f32(16.0) * T::ROUNDOFF);
        nearest <= radius + slack && farthest >= radius - slack
    }
}

/// A box that holds a shape, of those shapes for which a box says enough.
fn bounds_of<T: Real, const EFFECTS: u64>(shape: &Shape<'_, T>) -> Option<Bounds<T>> {
    Some(match shape {
        Shape::Disc(d) if has::<EFFECTS>(Effects::DISC) => Bounds::ball(d.center, d.radius),
        Shape::Annulus(a) if has::<EFFECTS>(Effects::ANNULUS) => Bounds::ball(a.center, a.outer),
        Shape::Box(b) if has::<EFFECTS>(Effects::BOX) => Bounds { low: b.min, high: b.max },
        Shape::Cone(c) if has::<EFFECTS>(Effects::CONE) => {
            let (base, apex) = (Bounds::ball(c.base, c.base_radius.abs()), Bounds::ball(c.apex, c.apex_radius.abs()));
            Bounds { low: base.low.min(apex.low), high: base.high.max(apex.high) }
        }
        Shape::Triangle(t) if has::<EFFECTS>(Effects::TRIANGLE) => Bounds::around(&t.vertices),
        Shape::SmoothTriangle(t) if has::<EFFECTS>(Effects::SMOOTH_TRIANGLE) => Bounds::around(&t.vertices),
        _ => return None,
    })
}

/// The plane that a flat shape lies in: a point of it and the direction across.
fn plane_of<T: Real, const EFFECTS: u64>(shape: &Shape<'_, T>) -> Option<(Vec3<T>, Vec3<T>)> {
    match shape {
        Shape::Plane(p) if has::<EFFECTS>(Effects::PLANE) => Some((p.point, p.normal)),
        Shape::Disc(d) if has::<EFFECTS>(Effects::DISC) => Some((d.center, d.normal)),
        Shape::Annulus(a) if has::<EFFECTS>(Effects::ANNULUS) => Some((a.center, a.normal)),
        _ => None,
    }
}

/// Whether an object may have a point in the box.
pub(crate) fn may_meet<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, bounds: &Bounds<T>) -> bool {
    match &object.shape {
        Shape::Sphere(s) if has::<EFFECTS>(Effects::SPHERE) => bounds.touches(s),
        Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => {
            (0..).map_while(|i| list.sphere(i)).any(|sphere| bounds.touches(&sphere))
        }
        Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => {
            list.iter().any(|t| Bounds::around(&t.vertices).overlaps(bounds))
        }
        shape => {
            bounds_of::<T, EFFECTS>(shape).is_none_or(|held| held.overlaps(bounds))
                && plane_of::<T, EFFECTS>(shape).is_none_or(|(point, normal)| bounds.cuts(point, normal))
        }
    }
}

/// A distance that no point of an object is nearer to a point than, with room for rounding. It may be below 0.
pub(crate) fn clearance<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, point: Vec3<T>) -> T {
    let nearest = |nearest: T, distance: T| nearest.min(distance);
    match &object.shape {
        Shape::Sphere(s) if has::<EFFECTS>(Effects::SPHERE) => from_sphere(s, point),
        Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => {
            (0..).map_while(|i| list.sphere(i)).map(|sphere| from_sphere(&sphere, point)).fold(T::MAX, nearest)
        }
        Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => {
            list.iter().map(|t| Bounds::around(&t.vertices).distance(point)).fold(T::MAX, nearest)
        }
        shape => {
            let from_box = bounds_of::<T, EFFECTS>(shape).map(|held| held.distance(point));
            let from_plane = plane_of::<T, EFFECTS>(shape).map(|(anchor, normal)| {
                let height = (point - anchor).dot(normal).abs() / normal.length();
                height - (point.largest() + anchor.largest()) * (T::from_f32(16.0) * T::ROUNDOFF)
            });
            match (from_box, from_plane) {
                (Some(a), Some(b)) => a.max(b),
                (Some(distance), None) | (None, Some(distance)) => distance,
                (None, None) => T::ZERO,
            }
        }
    }
}

fn from_sphere<T: Real>(sphere: &Sphere<T>, point: Vec3<T>) -> T {
    let (distance, radius) = ((point - sphere.center).length(), sphere.radius.abs());
    let rounding = (point.largest() + sphere.center.largest() + radius) * (T::from_f32(16.0) * T::ROUNDOFF);
    (distance - radius).abs() - rounding
}
