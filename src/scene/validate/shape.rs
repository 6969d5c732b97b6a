//! Shapes.

use super::number::{FARTHEST, Fault, POSITIVE, check, direction, ensure, length, minus, point, positive, within};
use crate::math::Vec3;
use crate::scene::Shape;

#[inline(never)]
const fn round(center: Vec3<f32>, radius: f32) -> Result<(), Fault> {
    ensure!(point(center, "center"));
    check(within(radius.abs(), 1e-12, FARTHEST), "radius", POSITIVE)
}

#[inline(never)]
#[allow(clippy::indexing_slicing)] // Constant indices into arrays of three.
const fn corners(vertices: &[Vec3<f32>; 3]) -> Result<(), Fault> {
    ensure!(point(vertices[0], "vertices"));
    ensure!(point(vertices[1], "vertices"));
    point(vertices[2], "vertices")
}

impl Shape<'_, f32> {
    #[allow(clippy::indexing_slicing)] // In range by the loops' conditions; iterators are not const.
    pub(super) const fn check(&self) -> Result<(), Fault> {
        match self {
            Shape::Sphere(sphere) => round(sphere.center, sphere.radius),
            Shape::Spheres(list) => {
                let mut i = 0;
                while let Some(sphere) = list.sphere(i) {
                    ensure!(round(sphere.center, sphere.radius));
                    i += 1;
                }
                Ok(())
            }
            Shape::Plane(plane) => {
                ensure!(point(plane.point, "point"));
                direction(plane.normal, "normal")
            }
            Shape::Disc(disc) => {
                ensure!(point(disc.center, "center"));
                ensure!(direction(disc.normal, "normal"));
                positive(disc.radius, "radius")
            }
            Shape::Annulus(annulus) => {
                ensure!(point(annulus.center, "center"));
                ensure!(direction(annulus.normal, "normal"));
                ensure!(positive(annulus.outer, "outer"));
                check(within(annulus.inner, 0.0, annulus.outer), "inner", "a radius from 0 to `outer`")
            }
            Shape::Box(b) => {
                ensure!(point(b.min, "min"));
                ensure!(point(b.max, "max"));
                let ordered = b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z;
                check(ordered, "max", "a corner not below `min` on any axis")
            }
            Shape::Triangle(triangle) => corners(&triangle.vertices),
            Shape::Triangles(list) => {
                let mut i = 0;
                while i < list.len() {
                    ensure!(corners(&list[i].vertices));
                    i += 1;
                }
                Ok(())
            }
            Shape::SmoothTriangle(triangle) => {
                ensure!(corners(&triangle.vertices));
                ensure!(direction(triangle.normals[0], "normals"));
                ensure!(direction(triangle.normals[1], "normals"));
                direction(triangle.normals[2], "normals")
            }
            Shape::Cone(cone) => {
                ensure!(point(cone.base, "base"));
                ensure!(point(cone.apex, "apex"));
                ensure!(direction(minus(cone.apex, cone.base), "apex"));
                ensure!(length(cone.base_radius, "base_radius"));
                ensure!(length(cone.apex_radius, "apex_radius"));
                let (base, apex) = (cone.base_radius, cone.apex_radius);
                let same_side = (base >= 0.0 && apex >= 0.0) || (base <= 0.0 && apex <= 0.0);
                ensure!(check(same_side, "apex_radius", "the sign of `base_radius`"));
                check(base.abs() + apex.abs() >= 1e-12, "base_radius", "a radius above 0 at one end")
            }
        }
    }
}
