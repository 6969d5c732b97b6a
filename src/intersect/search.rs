//! The search through a scene's objects.

use super::triangle::Shear;
use super::{Contact, Ray, Surface, axis_box, cone, plane, sphere, spheres, triangle};
use crate::math::Real;
use crate::scene::{Effects, Object, Shadow, Shape, Sides};

/// What a ray meets first.
pub(crate) struct Hit<'a, T> {
    pub object: &'a Object<'a, T>,
    /// Which primitive of the object's slice, if its shape is one.
    pub primitive: usize,
    pub contact: Contact<T>,
}

/// The nearest contact before `limit` with any object that `look_at` admits; of two that are equally near, to 32 roundings
/// of their distance, the first in the list.
#[inline]
pub(crate) fn nearest<'a, T: Real, const EFFECTS: u64>(
    objects: &'a [Object<'a, T>],
    ray: &Ray<T>,
    limit: T,
    look_at: impl Fn(&Object<'a, T>) -> bool,
) -> Option<Hit<'a, T>> {
    let search = Search::<T, EFFECTS>::new(ray);
    let mut best: Option<Hit<'a, T>> = None;
    let mut limit = limit;
    for object in objects.iter().filter(|object| look_at(object)) {
        if let Some((contact, primitive)) = search.nearest(object, limit) {
            // What is nearer by rounding alone is not nearer.
            limit = contact.t * (T::ONE - T::from_f32(32.0) * T::ROUNDOFF);
            best = Some(Hit { object, primitive, contact });
        }
    }
    best
}

/// Whether any object that casts shadows lies on the ray before `distance`.
#[inline]
pub(crate) fn occluded<T: Real, const EFFECTS: u64>(objects: &[Object<'_, T>], ray: &Ray<T>, distance: T) -> bool {
    let search = Search::<T, EFFECTS>::new(ray);
    objects.iter().any(|object| {
        let all_cast = !has::<EFFECTS>(Effects::SHADOWLESS.with(Effects::TINTED_SHADOW));
        let casts = all_cast || object.shadow == Shadow::Full;
        casts && search.any(object, distance)
    })
}

/// Whether a ray meets an object before `limit`, and then whether from outside.
pub(crate) fn meets<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, ray: &Ray<T>, limit: T) -> Option<bool> {
    let (contact, _) = Search::<T, EFFECTS>::new(ray).nearest(object, limit)?;
    Some(contact.front())
}

/// Whether the origin of a ray lies inside an object, for what has an inside: half-spaces and closed shapes.
pub(crate) fn encloses<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, ray: &Ray<T>) -> bool {
    match &object.shape {
        // A place on the plane is on the side that the ray goes to.
        Shape::Plane(plane) => {
            let height = (ray.origin - plane.point).dot(plane.normal);
            height < T::ZERO || (height == T::ZERO && ray.direction.dot(plane.normal) < T::ZERO)
        }
        Shape::Disc(_) | Shape::Triangle(_) | Shape::SmoothTriangle(_) => false,
        // Turned inside out, it encloses all the rest of space.
        Shape::Sphere(s) if s.radius < T::ZERO => (ray.origin - s.center).length() > -s.radius,
        _ => meets::<T, EFFECTS>(object, ray, T::MAX) == Some(false),
    }
}

impl<T: Real> Hit<'_, T> {
    /// The surface at the contact.
    #[inline(always)]
    pub(crate) fn surface<const EFFECTS: u64>(&self, ray: &Ray<T>) -> Surface<T> {
        let contact = &self.contact;
        match &self.object.shape {
            Shape::Sphere(s) if has::<EFFECTS>(Effects::SPHERE) => sphere::surface(s, ray, contact),
            Shape::Plane(p) if has::<EFFECTS>(Effects::PLANE) => plane::surface(p, ray, contact),
            Shape::Disc(d) if has::<EFFECTS>(Effects::DISC) => plane::disc_surface(d, ray, contact),
            Shape::Box(b) if has::<EFFECTS>(Effects::BOX) => axis_box::surface(b, ray, contact),
            Shape::Triangle(t) if has::<EFFECTS>(Effects::TRIANGLE) => triangle::surface(t, ray),
            Shape::SmoothTriangle(t) if has::<EFFECTS>(Effects::SMOOTH_TRIANGLE) => triangle::smooth_surface(t, ray),
            Shape::Cone(c) if has::<EFFECTS>(Effects::CONE) => cone::surface(c, ray, contact),
            Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => match list.sphere(self.primitive) {
                Some(s) => sphere::surface(&s, ray, contact),
                None => facing(ray, contact),
            },
            Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => match list.get(self.primitive) {
                Some(t) => triangle::surface(t, ray),
                None => facing(ray, contact),
            },
            _ => facing(ray, contact),
        }
    }
}

/// A surface across the ray: for shapes that a tracer's effects leave out, which it never meets.
fn facing<T: Real>(ray: &Ray<T>, contact: &Contact<T>) -> Surface<T> {
    let point = ray.at(contact.t);
    Surface::new(point, -ray.direction, point.abs() * T::ROUNDOFF)
}

const fn has<const EFFECTS: u64>(effects: Effects) -> bool {
    Effects::from_bits(EFFECTS).has(effects)
}

/// A ray with what its kinds of shapes need to know of it.
struct Search<'r, T, const EFFECTS: u64> {
    ray: &'r Ray<T>,
    shear: Option<Shear<T>>,
}

impl<'r, T: Real, const EFFECTS: u64> Search<'r, T, EFFECTS> {
    const TRIANGLES: bool = has::<EFFECTS>(Effects::TRIANGLE.with(Effects::TRIANGLES).with(Effects::SMOOTH_TRIANGLE));

    #[inline]
    fn new(ray: &'r Ray<T>) -> Self {
        Self { ray, shear: if Self::TRIANGLES { Some(Shear::new(ray.direction)) } else { None } }
    }

    /// The nearest contact with one object and the primitive it belongs to.
    #[inline]
    fn nearest(&self, object: &Object<'_, T>, limit: T) -> Option<(Contact<T>, usize)> {
        match &object.shape {
            Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => {
                spheres::intersect(list, self.ray, limit, Self::outside_only(object), false)
            }
            Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => {
                let (shear, outside_only) = (self.shear?, Self::outside_only(object));
                nearest_of(list, limit, |t, limit| {
                    triangle::intersect(&t.vertices, self.ray, &shear, limit, outside_only)
                })
            }
            _ => self.single(object, limit).map(|contact| (contact, 0)),
        }
    }

    /// Whether the ray meets the object before `limit`.
    #[inline]
    fn any(&self, object: &Object<'_, T>, limit: T) -> bool {
        let outside_only = Self::outside_only(object);
        match (&object.shape, self.shear) {
            (Shape::Spheres(list), _) if has::<EFFECTS>(Effects::SPHERES) => {
                spheres::intersect(list, self.ray, limit, outside_only, true).is_some()
            }
            (Shape::Triangles(list), Some(shear)) if has::<EFFECTS>(Effects::TRIANGLES) => {
                list.iter().any(|t| triangle::intersect(&t.vertices, self.ray, &shear, limit, outside_only).is_some())
            }
            _ => self.single(object, limit).is_some(),
        }
    }

    /// The contact with an object that is one primitive.
    #[inline(always)]
    fn single(&self, object: &Object<'_, T>, limit: T) -> Option<Contact<T>> {
        let (ray, outside_only) = (self.ray, Self::outside_only(object));
        match &object.shape {
            Shape::Sphere(s) if has::<EFFECTS>(Effects::SPHERE) => sphere::intersect(s, ray, limit, outside_only),
            Shape::Plane(p) if has::<EFFECTS>(Effects::PLANE) => plane::intersect(p, ray, limit, outside_only),
            Shape::Disc(d) if has::<EFFECTS>(Effects::DISC) => plane::intersect_disc(d, ray, limit, outside_only),
            Shape::Box(b) if has::<EFFECTS>(Effects::BOX) => axis_box::intersect(b, ray, limit, outside_only),
            Shape::Triangle(t) if has::<EFFECTS>(Effects::TRIANGLE) => {
                triangle::intersect(&t.vertices, ray, &self.shear?, limit, outside_only)
            }
            Shape::SmoothTriangle(t) if has::<EFFECTS>(Effects::SMOOTH_TRIANGLE) => {
                triangle::intersect(&t.vertices, ray, &self.shear?, limit, outside_only)
            }
            Shape::Cone(c) if has::<EFFECTS>(Effects::CONE) => cone::intersect(c, ray, limit, outside_only),
            _ => None,
        }
    }

    #[inline]
    fn outside_only(object: &Object<'_, T>) -> bool {
        has::<EFFECTS>(Effects::ONE_SIDED) && object.sides == Sides::Outside
    }
}

#[inline]
fn nearest_of<P, T: Real>(
    list: &[P],
    limit: T,
    intersect: impl Fn(&P, T) -> Option<Contact<T>>,
) -> Option<(Contact<T>, usize)> {
    let mut best = None;
    let mut limit = limit;
    for (i, primitive) in list.iter().enumerate() {
        if let Some(contact) = intersect(primitive, limit) {
            limit = contact.t;
            best = Some((contact, i));
        }
    }
    best
}
