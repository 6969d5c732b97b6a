//! Which media a branch of light is inside of.

use core::ptr;

use crate::intersect::{Candidates, Hit, Ray, encloses, meets};
use crate::math::{Real, Rgb};
use crate::optics::transmittance;
use crate::scene::{Effects, Index, Medium, Object, Scene};

/// The transparent objects that enclose a place, as many as `MEDIA`, by their numbers in the scene's list. The first
/// one is the one the place belongs to: the highest in priority, of equal ones the last in the list.
///
/// With `MEDIA` = 0 nothing is remembered, and each transparent object is taken to border on the scene's medium.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Media<const MEDIA: usize>([u16; MEDIA]);

/// A ray that goes through a surface.
pub(super) struct Crossing<'c, 'a, T> {
    pub hit: &'c Hit<'a, T>,
    pub ray: &'c Ray<T>,
    /// How far behind the contact another surface may lie and count as crossed at once: the next ray starts behind it.
    pub reach: T,
}

/// Free places come last in the list; no object has this number.
const FREE: u16 = u16::MAX;

/// What lies on both sides of a surface.
pub(super) struct Border<T, const MEDIA: usize> {
    /// Index of refraction where the light comes from.
    pub before: Index<T>,
    /// Index of refraction behind the surface, if light gets there.
    pub behind: Option<Index<T>>,
    /// What encloses the places behind the surface.
    pub media: Media<MEDIA>,
    /// Whether the medium changes. It does not where another object outranks this one on both sides.
    pub is_real: bool,
    /// Whether there was no room for another medium.
    pub overflow: bool,
}

impl<const MEDIA: usize> Media<MEDIA> {
    pub(super) const NONE: Self = Self([FREE; MEDIA]);

    /// The media that the origin of a ray lies in, and whether there was no room for one of them.
    pub(super) fn around<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, ray: &Ray<T>) -> (Self, bool) {
        let (mut media, mut overflow) = (Self::NONE, false);
        // A hierarchy knows where there is nothing to be inside of.
        if MEDIA > 0 && scene.hierarchy.is_none_or(|hierarchy| hierarchy.has_media) {
            for (number, object) in (0..FREE).zip(scene.objects) {
                if object.material.interface.medium().is_some() && encloses::<T, EFFECTS>(object, ray) {
                    overflow |= !media.enter(scene, number);
                }
            }
        }
        (media, overflow)
    }

    /// The medium that a place so enclosed belongs to.
    pub(super) fn medium<T: Real>(&self, scene: &Scene<'_, T>) -> Medium<T> {
        self.0.first().and_then(|&number| medium_of(scene, number)).unwrap_or(scene.medium)
    }

    /// The share of light that is left after a distance here.
    pub(super) fn transmittance<T: Real>(&self, scene: &Scene<'_, T>, distance: T) -> Rgb<T> {
        match self.medium(scene).attenuation {
            Some(constant) => transmittance(constant, distance),
            None => Rgb::WHITE,
        }
    }

    /// What lies on both sides of a surface.
    #[inline(always)]
    pub(super) fn border<T: Real, const EFFECTS: u64>(
        &self,
        scene: &Scene<'_, T>,
        crossing: &Crossing<'_, '_, T>,
    ) -> Border<T, MEDIA> {
        let real = |before, behind| Border { before, behind, media: *self, is_real: true, overflow: false };
        let transparent = Effects::from_bits(EFFECTS).has(Effects::CONSTANT.with(Effects::DIELECTRIC));
        let hit = crossing.hit;
        // Where an index varies, it is the one at the contact that counts.
        let at = |index| match Effects::from_bits(EFFECTS).has(Effects::GRADED) {
            true => scene.index_for::<EFFECTS>(index, crossing.ray.at(hit.contact.t)),
            false => index,
        };
        let inside = if transparent { hit.object.material.interface.medium() } else { None };
        let Some(Medium { index: inside, .. }) = inside else {
            return real(at(self.medium(scene).index), None);
        };
        if MEDIA == 0 {
            let outside = scene.medium.index;
            return if hit.contact.front() { real(outside, Some(inside)) } else { real(inside, Some(outside)) };
        }
        let (media, overflow) = self.behind::<T, EFFECTS>(scene, crossing, |_| true);
        let is_real = self.0.first() != media.0.first();
        let (before, behind) = (at(self.medium(scene).index), Some(at(media.medium(scene).index)));
        Border { before, behind, media, is_real, overflow }
    }

    /// The media behind the surface of a transparent object, and whether there was no room for one of them.
    ///
    /// Other objects that `look_at` admits are entered or left with it where their surfaces coincide with it, as those of
    /// a glass and the water in it.
    pub(super) fn behind<T: Real, const EFFECTS: u64>(
        &self,
        scene: &Scene<'_, T>,
        crossing: &Crossing<'_, '_, T>,
        look_at: impl Fn(&Object<'_, T>) -> bool,
    ) -> (Self, bool) {
        let &Crossing { hit, ray, reach } = crossing;
        let (mut media, mut overflow) = (*self, false);
        let candidates = Candidates::new::<T, EFFECTS>(scene, ray, hit.contact.t + reach);
        for number in candidates.iter() {
            let Some(object) = scene.objects.get(usize::from(number)) else { break };
            let front = if ptr::eq(object, hit.object) {
                Some(hit.contact.front())
            } else if object.material.interface.medium().is_some() && look_at(object) {
                meets::<T, EFFECTS>(object, ray, hit.contact.t + reach)
            } else {
                None
            };
            match front {
                Some(true) => overflow |= !media.enter(scene, number),
                Some(false) => media.leave(scene, number),
                None => {}
            }
        }
        (media, overflow)
    }

    /// Puts an object into its place in the list; `false` when that pushes the lowest one out.
    fn enter<T: Real>(&mut self, scene: &Scene<'_, T>, number: u16) -> bool {
        let mut entering = number;
        for place in &mut self.0 {
            if *place == entering {
                return true;
            }
            if *place == FREE {
                *place = entering;
                return true;
            }
            if rank(scene, entering) > rank(scene, *place) {
                core::mem::swap(place, &mut entering);
            }
        }
        false
    }

    /// Takes an object out of the list. What was never entered, because a ray has slipped by its edge, is not there.
    fn leave<T: Real>(&mut self, scene: &Scene<'_, T>, number: u16) {
        let itself = self.0.iter().position(|&place| place == number);
        let found = itself.or_else(|| self.0.iter().position(|&place| is_same_mesh(scene, place, number)));
        let Some(found) = found else { return };
        // From the end on, each place takes what came after it.
        let mut next = FREE;
        for (_, place) in self.0.iter_mut().enumerate().rev().take_while(|(i, _)| *i >= found) {
            core::mem::swap(place, &mut next);
        }
    }

    /// The list without the objects that `keep` refuses.
    pub(super) fn filtered<T: Real>(&self, scene: &Scene<'_, T>, keep: impl Fn(&Object<'_, T>) -> bool) -> Self {
        let mut kept = Self::NONE;
        let numbers = self.0.iter().filter(|&&number| scene.objects.get(usize::from(number)).is_some_and(&keep));
        for (place, number) in kept.0.iter_mut().zip(numbers) {
            *place = *number;
        }
        kept
    }
}

fn medium_of<T: Real>(scene: &Scene<'_, T>, number: u16) -> Option<Medium<T>> {
    scene.objects.get(usize::from(number))?.material.interface.medium()
}

fn rank<T: Real>(scene: &Scene<'_, T>, number: u16) -> (Option<u8>, u16) {
    (medium_of(scene, number).and_then(|medium| medium.priority), number)
}

/// Whether two objects are triangles of one rank: a ray enters a mesh of single triangles by one and leaves it by
/// another.
fn is_same_mesh<T: Real>(scene: &Scene<'_, T>, a: u16, b: u16) -> bool {
    let is_triangle =
        |number: u16| scene.objects.get(usize::from(number)).is_some_and(|object| object.shape.is_triangle());
    is_triangle(a) && is_triangle(b) && rank(scene, a).0 == rank(scene, b).0
}

impl<T: Real, const MEDIA: usize> Border<T, MEDIA> {
    /// Whether light of all channels splits here.
    pub(super) fn is_dispersive<const EFFECTS: u64>(&self) -> bool {
        let effects = const { Effects::from_bits(EFFECTS) };
        let refracts = |behind: &Index<T>| self.before.is_dispersive() || behind.is_dispersive();
        effects.has(Effects::DISPERSION) && self.behind.as_ref().is_some_and(refracts)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;
    use crate::math::Vec3;
    use crate::path::next_surface;
    use crate::scene::{Background, Camera, Extent, Material, Shape, Triangle};

    const ALL: u64 = Effects::ALL.bits();

    fn scene<'a>(objects: &'a [Object<'a, f64>]) -> Scene<'a, f64> {
        let camera = Camera {
            eye: Vec3::ZERO,
            target: Vec3::new(1.0, 0.0, 0.0),
            up: Vec3::new(0.0, 1.0, 0.0),
            half_height: 1.0,
            extent: Extent::PixelEdges,
            lens: None,
        };
        Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(objects)
    }

    fn slab(from: f64, to: f64, medium: Medium<f64>) -> Object<'static, f64> {
        let shape = Shape::axis_box(Vec3::new(from, -1.0, -1.0), Vec3::new(to, 1.0, 1.0));
        Object::new(shape, Material::transparent(medium))
    }

    /// The surfaces of one object of a case: a triangle across the x axis for each event.
    fn surfaces(case: &Value, object: &Value) -> Vec<Triangle<f64>> {
        let events = case["events"].as_array().unwrap().iter().filter(|event| event["obj"] == object["id"]);
        let crossing = |x: f64, enters: bool| {
            let [a, b, c] = [(-2.0, -2.0), (-2.0, 4.0), (4.0, -2.0)].map(|(y, z)| Vec3::new(x, y, z));
            Triangle { vertices: if enters { [a, b, c] } else { [a, c, b] } }
        };
        let mut inside = case["initially_inside"].as_array().unwrap().contains(&object["id"]);
        let mut surfaces = Vec::new();
        for event in events {
            inside = event["kind"] == "enter";
            surfaces.push(crossing(event["t"].as_f64().unwrap(), inside));
        }
        if inside {
            surfaces.push(crossing(1e3, false));
        }
        surfaces
    }

    fn glass(object: &Value) -> Material<f64> {
        let medium = Medium::new(object["ior"].as_f64().unwrap());
        Material::transparent(medium.with_priority(object["priority"].as_u64().unwrap() as u8))
    }

    /// Every border on every line of the table: which object, whether the medium changes, and both indices.
    #[test]
    fn borders_are_those_of_the_definition() {
        let text = include_str!("../../tests/data/oracles/nested_priority.json");
        let cases: Value = serde_json::from_str(text).unwrap();
        let mut count = 0;
        for case in cases.as_array().unwrap() {
            let shapes: Vec<_> = case["objects"]
                .as_array()
                .unwrap()
                .iter()
                .map(|object| (surfaces(case, object), glass(object)))
                .collect();
            let objects: Vec<_> =
                shapes.iter().map(|(list, glass)| Object::new(Shape::Triangles(list), *glass)).collect();
            let scene = scene(&objects);
            let mut ray = Ray {
                origin: Vec3::new(case["start_t"].as_f64().unwrap(), 0.0, 0.0),
                direction: Vec3::new(1.0, 0.0, 0.0),
            };
            let (mut media, overflow) = Media::<8>::around::<f64, ALL>(&scene, &ray);
            assert!(!overflow);
            for event in case["events"].as_array().unwrap() {
                let hit = next_surface::<f64, ALL>(&scene, &ray).unwrap();
                assert!(ptr::eq(hit.object, &objects[event["obj"].as_u64().unwrap() as usize]), "{event}");
                assert_eq!(hit.contact.front(), event["kind"] == "enter", "{event}");
                let border = media.border::<f64, ALL>(&scene, &Crossing { hit: &hit, ray: &ray, reach: 0.0 });
                assert_eq!(Value::from(border.is_real), event["real"], "{event}");
                assert_eq!(Some(border.before.at(None)), event["n1"].as_f64(), "{event}");
                assert_eq!(border.behind.map(|index| index.at(None)), event["n2"].as_f64(), "{event}");
                media = border.media;
                ray = hit.surface::<ALL>(&ray, &scene.offset).leave(ray.direction, !hit.contact.front());
                count += 1;
            }
        }
        assert!(count > 800, "{count}");
    }

    /// The medium of the lowest priority is forgotten, and that is told.
    #[test]
    fn a_full_list_forgets_the_lowest() {
        let objects = [3, 1, 2].map(|n: u8| slab(0.0, 9.0, Medium::new(f64::from(n)).with_priority(n)));
        let scene = scene(&objects);
        let mut media = Media::<2>::NONE;
        assert!(media.enter(&scene, 1) && media.enter(&scene, 0));
        assert!(!media.enter(&scene, 2));
        assert_eq!(media, Media([0, 2]));
        media.leave(&scene, 0);
        media.leave(&scene, 1);
        assert_eq!(media, Media([2, FREE]));
        let ray = Ray { origin: Vec3::new(5.0, 0.0, 0.0), direction: Vec3::new(1.0, 0.0, 0.0) };
        assert_eq!(Media::<2>::around::<f64, ALL>(&scene, &ray), (Media([0, 2]), true));
        assert_eq!(Media::<3>::around::<f64, ALL>(&scene, &ray), (Media([0, 2, 1]), false));
    }

    /// Of equal priorities, and of none, the last one in the list counts, in whatever order they are entered.
    #[test]
    fn of_equals_the_last_counts() {
        let objects = [1.1, 1.2, 1.3].map(|n| slab(0.0, 9.0, Medium::new(n)));
        let scene = scene(&objects);
        for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
            let mut media = Media::<3>::NONE;
            for number in order {
                media.enter(&scene, number);
                media.enter(&scene, number);
            }
            assert_eq!(media, Media([2, 1, 0]));
        }
    }
}
