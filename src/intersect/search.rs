//! The search through a scene's objects.

use core::slice;

use super::triangle::Shear;
use super::walk::walk;
use super::{Contact, Hit, Ray, axis_box, cone, plane, sphere, spheres, triangle};
use crate::math::Real;
use crate::scene::{Effects, Hierarchy, Leaf, Object, Scene, Shadow, Shape, Sides, SmoothTriangle, Triangle};

/// What a search is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// The nearest contact of all.
    Nearest,
    /// The nearest contact with an object that has a tinted shadow.
    NearestTinted,
    /// Any contact with an object that has a full shadow.
    Shadow,
}

/// The contact before `limit` that is wanted; of two that are equally near, to 32 roundings of their distance, the first in
/// the list.
///
/// One function for all that is wanted, so that the code for each shape is in a program once.
pub(crate) fn search<'a, T: Real, const EFFECTS: u64>(
    objects: &'a [Object<'a, T>],
    ray: &Ray<T>,
    limit: T,
    wanted: Wanted,
) -> Option<Hit<'a, T>> {
    let search = Search::<T, EFFECTS>::new(ray, wanted == Wanted::Shadow);
    let mut best = None;
    let mut limit = limit;
    for object in objects.iter().filter(|object| is_wanted::<T, EFFECTS>(object, wanted)) {
        if let Some((contact, primitive, weights)) = search.contact(object, limit) {
            best = Some(Hit { object, primitive, weights, contact });
            if search.any {
                break;
            }
            // What is nearer by rounding alone is not nearer.
            limit = contact.t.lowered(32.0);
        }
    }
    best
}

/// The same in a scene, by its hierarchy if it has one.
#[inline]
pub(crate) fn search_scene<'a, T: Real, const EFFECTS: u64>(
    scene: &Scene<'a, T>,
    ray: &Ray<T>,
    limit: T,
    wanted: Wanted,
) -> Option<Hit<'a, T>> {
    match &scene.hierarchy {
        Some(hierarchy) if has::<EFFECTS>(Effects::HIERARCHY) => {
            search_hierarchy::<T, EFFECTS>(scene.objects, hierarchy, ray, limit, wanted)
        }
        _ => search::<T, EFFECTS>(scene.objects, ray, limit, wanted),
    }
}

/// The contact that a search through the list finds, whatever the order in which contacts are found.
fn search_hierarchy<'a, T: Real, const EFFECTS: u64>(
    objects: &'a [Object<'a, T>],
    hierarchy: &Hierarchy<'a>,
    ray: &Ray<T>,
    limit: T,
    wanted: Wanted,
) -> Option<Hit<'a, T>> {
    let search = Search::<T, EFFECTS>::new(ray, wanted == Wanted::Shadow);
    let (mut best, mut number, mut reach) = (None::<Hit<'a, T>>, 0, limit);
    let mut look = |leaf: &Leaf| {
        let object = objects.get(leaf.object as usize).filter(|object| is_wanted::<T, EFFECTS>(object, wanted));
        let Some(object) = object else { return Some(reach) };
        let Some((contact, primitive, weights)) = search.part(object, leaf.part as usize, reach) else {
            return Some(reach);
        };
        let is_first = |best: &Hit<'_, T>| {
            let (one, other) = (contact.t, best.contact.t);
            comes_first((leaf.object, primitive, one), (number, best.primitive, other))
        };
        if best.as_ref().is_none_or(is_first) {
            best = Some(Hit { object, primitive, weights, contact });
            number = leaf.object;
        }
        // What is as near as the nearest, by rounding, may come first in the list.
        reach = reach.min(contact.t.raised(33.0));
        if search.any { None } else { Some(reach) }
    };
    let unbounded = hierarchy.leaves.iter().take(hierarchy.unbounded);
    if let Some(reach) = unbounded.map(&mut look).try_fold(limit, |_, reach| reach) {
        walk(hierarchy, ray, reach, look);
    }
    best
}

/// Whether a contact is the one to be seen, and not the other; each is an object, a primitive of it, and a distance. Within an
/// object it is the nearer one, or of two as near the first; of two objects the nearer one, or of two as near to 32 roundings the
/// first.
fn comes_first<T: Real>((object, primitive, t): (u32, usize, T), other: (u32, usize, T)) -> bool {
    if object == other.0 {
        return t < other.2 || (t == other.2 && primitive < other.1);
    }
    t < other.2.lowered(32.0) || (object < other.0 && t.lowered(32.0) <= other.2)
}

#[inline]
fn is_wanted<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, wanted: Wanted) -> bool {
    match wanted {
        Wanted::NearestTinted if has::<EFFECTS>(Effects::TINTED_SHADOW) => object.shadow == Shadow::Tinted,
        Wanted::Shadow if has::<EFFECTS>(Effects::SHADOWLESS.with(Effects::TINTED_SHADOW)) => {
            object.shadow == Shadow::Full
        }
        _ => true,
    }
}

/// Whether a ray meets an object before `limit`, and then whether from outside.
pub(crate) fn meets<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, ray: &Ray<T>, limit: T) -> Option<bool> {
    let hit = search::<T, EFFECTS>(slice::from_ref(object), ray, limit, Wanted::Nearest)?;
    Some(hit.contact.front())
}

/// Whether the origin of a ray lies inside an object, for what has an inside: half-spaces and closed shapes.
pub(crate) fn encloses<T: Real, const EFFECTS: u64>(object: &Object<'_, T>, ray: &Ray<T>) -> bool {
    match &object.shape {
        // A place on the plane is on the side that the ray goes to.
        Shape::Plane(plane) => {
            let height = (ray.origin - plane.point).dot(plane.normal);
            height < T::ZERO || (height == T::ZERO && ray.direction.dot(plane.normal) < T::ZERO)
        }
        Shape::Disc(_) | Shape::Annulus(_) | Shape::Triangle(_) | Shape::SmoothTriangle(_) => false,
        // Turned inside out, it encloses all the rest of space.
        Shape::Sphere(s) if s.radius < T::ZERO => (ray.origin - s.center).length() > -s.radius,
        _ => meets::<T, EFFECTS>(object, ray, T::MAX) == Some(false),
    }
}

pub(super) const fn has<const EFFECTS: u64>(effects: Effects) -> bool {
    Effects::from_bits(EFFECTS).has(effects)
}

/// A ray with what its kinds of shapes need to know of it.
struct Search<'r, T, const EFFECTS: u64> {
    ray: &'r Ray<T>,
    shear: Option<Shear<T>>,
    /// Whether any contact will do, and not only the nearest.
    any: bool,
}

impl<'r, T: Real, const EFFECTS: u64> Search<'r, T, EFFECTS> {
    const TRIANGLES: Effects = Effects::TRIANGLE.with(Effects::TRIANGLES).with(Effects::SMOOTH_TRIANGLE);

    #[inline]
    fn new(ray: &'r Ray<T>, any: bool) -> Self {
        let shear = if has::<EFFECTS>(Self::TRIANGLES) { Some(Shear::new(ray.direction)) } else { None };
        Self { ray, shear, any }
    }

    /// The contact with one part of an object, as of [`Leaf`].
    #[inline]
    fn part(&self, object: &Object<'_, T>, part: usize, limit: T) -> Option<(Contact<T>, usize, [T; 3])> {
        let (ray, any) = (self.ray, self.any);
        let outside_only = has::<EFFECTS>(Effects::ONE_SIDED) && object.sides == Sides::Outside;
        match &object.shape {
            Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => {
                let (contact, primitive) = spheres::intersect_cluster(list, part, ray, limit, outside_only, any)?;
                Some((contact, primitive, [T::ZERO; 3]))
            }
            Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => {
                let triangle = list.get(part)?;
                let (contact, weights) =
                    triangle::intersect(&triangle.vertices, ray, &self.shear?, limit, outside_only)?;
                Some((contact, part, weights))
            }
            _ => self.contact(object, limit),
        }
    }

    /// The contact with one object and the primitive it belongs to.
    #[inline(always)]
    fn contact(&self, object: &Object<'_, T>, limit: T) -> Option<(Contact<T>, usize, [T; 3])> {
        let (ray, any) = (self.ray, self.any);
        let outside_only = has::<EFFECTS>(Effects::ONE_SIDED) && object.sides == Sides::Outside;
        let single = match &object.shape {
            Shape::Sphere(s) if has::<EFFECTS>(Effects::SPHERE) => sphere::intersect(s, ray, limit, outside_only),
            Shape::Plane(p) if has::<EFFECTS>(Effects::PLANE) => plane::intersect(p, ray, limit, outside_only),
            Shape::Disc(d) if has::<EFFECTS>(Effects::DISC) => plane::intersect_disc(d, ray, limit, outside_only),
            Shape::Annulus(a) if has::<EFFECTS>(Effects::ANNULUS) => {
                plane::intersect_annulus(a, ray, limit, outside_only)
            }
            Shape::Box(b) if has::<EFFECTS>(Effects::BOX) => axis_box::intersect(b, ray, limit, outside_only),
            Shape::Cone(c) if has::<EFFECTS>(Effects::CONE) => cone::intersect(c, ray, limit, outside_only),
            Shape::Spheres(list) if has::<EFFECTS>(Effects::SPHERES) => {
                let (contact, primitive) = spheres::intersect(list, ray, limit, outside_only, any)?;
                return Some((contact, primitive, [T::ZERO; 3]));
            }
            Shape::Triangles(list) if has::<EFFECTS>(Effects::TRIANGLES) => {
                return triangle::intersect_list(list, ray, &self.shear?, limit, outside_only, any);
            }
            Shape::Triangle(Triangle { vertices }) | Shape::SmoothTriangle(SmoothTriangle { vertices, .. })
                if has::<EFFECTS>(Effects::TRIANGLE.with(Effects::SMOOTH_TRIANGLE)) =>
            {
                let (contact, weights) = triangle::intersect(vertices, ray, &self.shear?, limit, outside_only)?;
                return Some((contact, 0, weights));
            }
            _ => None,
        };
        single.map(|contact| (contact, 0, [T::ZERO; 3]))
    }
}
