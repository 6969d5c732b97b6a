//! The same scene with a hierarchy around its objects.

use whit::scene::{Hierarchy, Leaf, Node};
use whit::{Intersection, Ray, Real, Shape, Vec3};

use super::{Everything, Fault, LARGE, Order, require};

impl<T: Real> Order<'_, T> {
    /// Every ray meets what it meets in the list of objects.
    pub(super) fn check_hierarchy<const MEDIA: usize>(
        &self,
        tracer: &Everything<'_, T, LARGE, MEDIA>,
    ) -> Result<(), Fault> {
        let parts = self.scene.parts();
        let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts]);
        let hierarchy = Hierarchy::build(self.scene, &mut nodes, &mut leaves).map_err(|full| full.to_string())?;
        let scene = self.scene.with_hierarchy(hierarchy);
        let by_boxes = Everything::<T, LARGE, MEDIA>::try_new(&scene).map_err(|error| error.to_string())?;
        for ray in self.eye_rays().iter().chain(&self.rays) {
            let (one, other) = (tracer.intersect(ray), by_boxes.intersect(ray));
            let is_same = what(&one) == what(&other)
                || one.zip(other).is_some_and(|(one, other)| is_as_near(one.distance, other.distance))
                || one.is_some_and(|there| self.is_elsewhere(&there, ray));
            require(is_same, || format!("{:?}, by boxes {:?} of {ray:?}", what(&one), what(&other)))?;
        }
        Ok(())
    }

    /// Whether a shape is said to be met where it is not. A triangle without area is, by rounding, by rays that meet the line it
    /// lies on far away, and a cone that is millions of times as wide as it is high is by rays from far above.
    fn is_elsewhere(&self, there: &Intersection<T>, ray: &Ray<T>) -> bool {
        let Some(object) = self.scene.objects.get(there.object) else { return false };
        let (corners, radius) = match &object.shape {
            Shape::Triangle(triangle) => (triangle.vertices, T::ZERO),
            Shape::SmoothTriangle(triangle) => (triangle.vertices, T::ZERO),
            Shape::Triangles(list) => match list.get(there.primitive) {
                Some(triangle) => (triangle.vertices, T::ZERO),
                None => return false,
            },
            Shape::Cone(cone) => {
                ([cone.base, cone.apex, cone.apex], cone.base_radius.abs().max(cone.apex_radius.abs()))
            }
            _ => return false,
        };
        let point = ray.at(there.distance);
        let away = |axis: fn(Vec3<T>) -> T| {
            let [a, b, c] = corners.map(axis);
            (a.min(b).min(c) - axis(point)).max(axis(point) - a.max(b).max(c))
        };
        let away = away(|v| v.x).max(away(|v| v.y)).max(away(|v| v.z)) - radius;
        away > (there.distance + ray.origin.x.abs() + ray.origin.y.abs() + ray.origin.z.abs()) * T::from_f32(1e-4)
    }
}

/// Of three surfaces of which the first and the second are as near, and the second and the third, but not the first and the
/// third, the order in which they are found decides.
fn is_as_near<T: Real>(one: T, other: T) -> bool {
    (one - other).abs() <= one * (T::from_f32(64.0) * T::ROUNDOFF)
}

fn what<T: Real>(intersection: &Option<Intersection<T>>) -> Option<(usize, usize, T)> {
    intersection.as_ref().map(|there| (there.object, there.primitive, there.distance))
}
