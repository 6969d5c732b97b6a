//! All primitives of a scene, tried one by one.

use whit::scene::{Object, Scene, Shadow, Sides};

use super::hole::Hole;
use super::profile::Profile;
use super::shapes::{Primitive, Ray, Surface};
use super::vector::Vector;

/// A scene, taken apart.
pub struct World<'a> {
    pub scene: &'a Scene<'a, f32>,
    /// Each with the place of its object in the scene's list.
    pub primitives: Vec<(Primitive, usize)>,
    pub profiles: Vec<Profile>,
    pub hole: Option<Hole>,
}

/// What a ray sees.
#[derive(Clone, Copy, Debug)]
pub struct Hit<'a> {
    pub object: &'a Object<'a, f32>,
    pub surface: Surface,
    pub distance: f64,
    pub point: Vector,
    /// Whether the ray comes from outside.
    pub outside: bool,
    /// Geometric normal on the side that the ray comes from.
    pub geometric: Vector,
    /// Shading normal, turned over together with the geometric one.
    pub normal: Vector,
    /// The `skip` of a ray that starts here.
    skip: f64,
}

impl Hit<'_> {
    /// A ray from the point.
    pub fn leave(&self, direction: Vector) -> Ray {
        Ray { left: Some(self.surface), skip: self.skip, ..Ray::new(self.point, direction) }
    }
}

impl<'a> World<'a> {
    pub fn new(scene: &'a Scene<'a, f32>) -> Self {
        let parts = |(place, object)| Primitive::all(object).into_iter().map(move |primitive| (primitive, place));
        Self {
            scene,
            primitives: scene.objects.iter().enumerate().flat_map(parts).collect(),
            profiles: scene.profiles.iter().map(Profile::from).collect(),
            hole: scene.black_hole.as_ref().map(Hole::from),
        }
    }

    /// The nearest primitive that the ray meets, the first one of several.
    pub fn nearest(&self, ray: &Ray) -> Option<Hit<'a>> {
        self.nearest_before(ray, f64::INFINITY)
    }

    /// The same, of those nearer than a distance.
    pub fn nearest_before(&self, ray: &Ray, mut reach: f64) -> Option<Hit<'a>> {
        let mut nearest = None;
        for (i, (primitive, object)) in self.primitives.iter().enumerate() {
            let object = &self.scene.objects[*object];
            primitive.meet(ray, own(ray, i), &mut |meeting| {
                let seen = object.sides == Sides::Both || ray.direction.dot(meeting.outward) < 0.0;
                if seen && meeting.distance > ray.skip && meeting.distance < reach {
                    reach = meeting.distance;
                    nearest = Some((i, object, meeting));
                }
            });
        }
        let (primitive, object, meeting) = nearest?;
        let point = ray.at(meeting.distance);
        let outside = ray.direction.dot(meeting.outward) <= 0.0;
        let side = if outside { 1.0 } else { -1.0 };
        Some(Hit {
            object,
            surface: Surface { primitive, part: meeting.part },
            distance: meeting.distance,
            point,
            outside,
            geometric: meeting.outward * side,
            normal: meeting.smooth * side,
            // The rounding error of the point is some 1e-16 of the numbers that it comes from.
            skip: 1e-13 * point.largest().max(ray.origin.largest()).max(meeting.distance),
        })
    }

    /// Whether an object with a full shadow lies on the ray before the distance.
    pub fn is_blocked(&self, ray: &Ray, distance: f64) -> bool {
        let objects = self.primitives.iter().map(|(primitive, object)| (primitive, &self.scene.objects[*object]));
        objects.enumerate().filter(|(_, (_, object))| object.shadow == Shadow::Full).any(|(i, (primitive, object))| {
            let mut blocked = false;
            primitive.meet(ray, own(ray, i), &mut |meeting| {
                let seen = object.sides == Sides::Both || ray.direction.dot(meeting.outward) < 0.0;
                blocked |= seen && meeting.distance > ray.skip && meeting.distance < distance - ray.skip;
            });
            blocked
        })
    }
}

/// The part of primitive `i` that the ray starts on.
pub fn own(ray: &Ray, i: usize) -> Option<usize> {
    ray.left.filter(|surface| surface.primitive == i).map(|surface| surface.part)
}
