//! What a ray meets first, and the surface there.

use super::search::has;
use super::{Contact, Ray, Surface, axis_box, cone, plane, sphere, triangle};
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Object, Offset, Shape, Sphere};

/// What a ray meets first.
pub(crate) struct Hit<'a, T> {
    pub object: &'a Object<'a, T>,
    /// Which primitive of the object's slice, if its shape is one.
    pub primitive: usize,
    /// The weights of a triangle's corners at the contact, not yet divided by their sum.
    pub(super) weights: [T; 3],
    pub contact: Contact<T>,
}

impl<T: Real> Hit<'_, T> {
    /// The surface at the contact. Shapes that a tracer's effects leave out, which it never meets, have none that is right.
    #[inline]
    pub(crate) fn surface<const EFFECTS: u64>(&self, ray: &Ray<T>, offset: &Offset<T>) -> Surface<T> {
        let contact = &self.contact;
        let mut shading = None;
        let mut curvature_radius = T::MAX;
        let located = if let Some(sphere) = self.sphere::<EFFECTS>() {
            curvature_radius = sphere.radius.abs();
            sphere::locate(&sphere, ray, contact)
        } else if let Some(vertices) = self.triangle::<EFFECTS>() {
            let (located, shares) = triangle::locate(vertices, ray, contact, self.weights);
            if let (Shape::SmoothTriangle(t), true) = (&self.object.shape, has::<EFFECTS>(Effects::SMOOTH_TRIANGLE)) {
                shading = Some(triangle::shading(&t.normals, shares, located.normal));
            }
            located
        } else {
            match &self.object.shape {
                Shape::Box(b) if has::<EFFECTS>(Effects::BOX) => axis_box::locate(b, ray, contact),
                Shape::Cone(c) if has::<EFFECTS>(Effects::CONE) && contact.part() == cone::SIDE => {
                    let (located, radius) = cone::locate(c, ray, contact);
                    curvature_radius = radius;
                    located
                }
                _ => {
                    let (anchor, direction) = self.plane::<EFFECTS>(ray);
                    plane::locate(ray.at(contact.t), anchor, direction)
                }
            }
        };
        let normal = located.normal;
        Surface::new::<EFFECTS>(located, shading.unwrap_or(normal), curvature_radius, offset)
    }

    /// The flat face that is met: a point of it and the direction across.
    #[inline]
    fn plane<const EFFECTS: u64>(&self, ray: &Ray<T>) -> (Vec3<T>, Vec3<T>) {
        match &self.object.shape {
            Shape::Plane(p) if has::<EFFECTS>(Effects::PLANE) => (p.point, p.normal),
            Shape::Disc(d) if has::<EFFECTS>(Effects::DISC) => (d.center, d.normal),
            Shape::Annulus(a) if has::<EFFECTS>(Effects::ANNULUS) => (a.center, a.normal),
            Shape::Cone(c) if has::<EFFECTS>(Effects::CONE) => cone::cap(c, &self.contact),
            _ => (ray.origin, ray.direction),
        }
    }

    /// The sphere that is met.
    #[inline]
    fn sphere<const EFFECTS: u64>(&self) -> Option<Sphere<T>> {
        match &self.object.shape {
            Shape::Sphere(s) if has::<EFFECTS>(Effects::SPHERE) => Some(*s),
            Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => list.sphere(self.primitive),
            _ => None,
        }
    }

    /// The corners of the triangle that is met.
    #[inline]
    fn triangle<const EFFECTS: u64>(&self) -> Option<&[Vec3<T>; 3]> {
        match &self.object.shape {
            Shape::Triangle(t) if has::<EFFECTS>(Effects::TRIANGLE) => Some(&t.vertices),
            Shape::SmoothTriangle(t) if has::<EFFECTS>(Effects::SMOOTH_TRIANGLE) => Some(&t.vertices),
            Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => Some(&list.get(self.primitive)?.vertices),
            _ => None,
        }
    }
}
