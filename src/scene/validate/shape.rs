//! Shapes.

use super::in_f32;
use super::number::{FARTHEST, Fault, POSITIVE, check, direction, ensure, length, minus, point, positive, within};
use crate::math::{Real, Vec3};
use crate::scene::{AxisBox, Cone, Disc, Plane, Shape, SmoothTriangle, Sphere, Triangle};

impl Sphere<f32> {
    #[inline(never)]
    const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.center, "center"));
        check(within(self.radius.abs(), 1e-12, FARTHEST), "radius", POSITIVE)
    }
}

impl Plane<f32> {
    const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.point, "point"));
        direction(self.normal, "normal")
    }
}

impl Disc<f32> {
    const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.center, "center"));
        ensure!(direction(self.normal, "normal"));
        positive(self.radius, "radius")
    }
}

impl AxisBox<f32> {
    const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.min, "min"));
        ensure!(point(self.max, "max"));
        let ordered = self.min.x <= self.max.x && self.min.y <= self.max.y && self.min.z <= self.max.z;
        check(ordered, "max", "a corner not below `min` on any axis")
    }
}

impl Triangle<f32> {
    const fn check(&self) -> Result<(), Fault> {
        corners(&self.vertices)
    }
}

impl SmoothTriangle<f32> {
    #[allow(clippy::indexing_slicing)] // Constant indices into arrays of three.
    const fn check(&self) -> Result<(), Fault> {
        ensure!(corners(&self.vertices));
        ensure!(direction(self.normals[0], "normals"));
        ensure!(direction(self.normals[1], "normals"));
        direction(self.normals[2], "normals")
    }
}

#[inline(never)]
#[allow(clippy::indexing_slicing)] // Constant indices into arrays of three.
const fn corners(vertices: &[Vec3<f32>; 3]) -> Result<(), Fault> {
    ensure!(point(vertices[0], "vertices"));
    ensure!(point(vertices[1], "vertices"));
    point(vertices[2], "vertices")
}

impl Cone<f32> {
    const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.base, "base"));
        ensure!(point(self.apex, "apex"));
        ensure!(direction(minus(self.apex, self.base), "apex"));
        ensure!(length(self.base_radius, "base_radius"));
        ensure!(length(self.apex_radius, "apex_radius"));
        let (base, apex) = (self.base_radius, self.apex_radius);
        let same_side = (base >= 0.0 && apex >= 0.0) || (base <= 0.0 && apex <= 0.0);
        ensure!(check(same_side, "apex_radius", "the sign of `base_radius`"));
        check(base.abs() + apex.abs() >= 1e-12, "base_radius", "a radius above 0 at one end")
    }
}

impl Shape<'_, f32> {
    #[allow(clippy::indexing_slicing)] // In range by the loops' conditions; iterators are not const.
    pub(super) const fn check(&self) -> Result<(), Fault> {
        match self {
            Shape::Sphere(sphere) => sphere.check(),
            Shape::Spheres(list) => {
                let mut i = 0;
                while let Some(sphere) = list.sphere(i) {
                    ensure!(sphere.check());
                    i += 1;
                }
                Ok(())
            }
            Shape::Plane(plane) => plane.check(),
            Shape::Disc(disc) => disc.check(),
            Shape::Box(b) => b.check(),
            Shape::Triangle(triangle) => triangle.check(),
            Shape::Triangles(list) => {
                let mut i = 0;
                while i < list.len() {
                    ensure!(list[i].check());
                    i += 1;
                }
                Ok(())
            }
            Shape::SmoothTriangle(triangle) => triangle.check(),
            Shape::Cone(cone) => cone.check(),
        }
    }
}

impl<T: Real> Shape<'_, T> {
    /// [`check`](Shape::check) for every number type.
    pub(super) fn validate(&self) -> Result<(), Fault> {
        let to_f32 = T::to_f32;
        let check_sphere = |sphere: &Sphere<T>| in_f32(sphere, |sphere| sphere.map(to_f32), Sphere::check);
        let check_triangle = |triangle: &Triangle<T>| in_f32(triangle, |t| t.map(to_f32), Triangle::check);
        match self {
            Shape::Sphere(sphere) => check_sphere(sphere),
            Shape::Spheres(list) => list.iter().try_for_each(|sphere| check_sphere(&sphere)),
            Shape::Plane(plane) => in_f32(plane, |plane| plane.map(to_f32), Plane::check),
            Shape::Disc(disc) => in_f32(disc, |disc| disc.map(to_f32), Disc::check),
            Shape::Box(b) => in_f32(b, |b| b.map(to_f32), AxisBox::check),
            Shape::Triangle(triangle) => check_triangle(triangle),
            Shape::Triangles(list) => list.iter().try_for_each(check_triangle),
            Shape::SmoothTriangle(triangle) => in_f32(triangle, |t| t.map(to_f32), SmoothTriangle::check),
            Shape::Cone(cone) => in_f32(cone, |cone| cone.map(to_f32), Cone::check),
        }
    }
}
