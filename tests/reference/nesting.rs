//! Which medium is where, found at every place anew from what is inside of what.

use whit::scene::{Index, Interface, Object, Shape};

use super::medium::{Border, Medium};
use super::profile::Profile;
use super::shapes::Ray;
use super::vector::{Color, Vector};
use super::world::{Hit, World, own};

/// A primitive with the side of it that a point is taken to be on, if it is inside.
type Side = (usize, bool);

impl World<'_> {
    /// The media on both sides of a hit, or none where the medium stays the same because the object does not prevail.
    pub fn border(&self, ray: &Ray, hit: &Hit<'_>) -> Option<Border> {
        let own_medium = hit.object.material.interface.medium();
        if self.scene.media() == 0 {
            let own = own_medium.map_or(self.medium_at(None, hit.point), Medium::from);
            let (outside, inside) = (self.medium_at(None, hit.point), own);
            let (front, behind) = if hit.outside { (outside, inside) } else { (inside, outside) };
            return Some(Border { front, behind });
        }
        // Between the last surface before the hit and the hit, the other objects are what they are at the hit.
        let before = self.crossings(ray, hit.distance, |_| true).into_iter().fold(0.0, f64::max);
        let place = ray.at(0.5 * (before + hit.distance));
        let prevails = |inside| self.prevailing(place, Some((hit.surface.primitive, inside)), |_| true);
        let (front, behind) = (prevails(!hit.outside), prevails(hit.outside));
        let border = Border { front: self.medium_at(front, hit.point), behind: self.medium_at(behind, hit.point) };
        (own_medium.is_none() || front != behind).then_some(border)
    }

    /// The share of light per channel that is left on the way along a ray: e^(−c·x) for each piece of length x between
    /// the surfaces of the objects that count.
    pub fn clarity(&self, ray: &Ray, distance: f64, counts: impl Fn(&Object<'_, f32>) -> bool) -> Color {
        let attenuates = |medium: Medium| medium.attenuation != Color::BLACK;
        let transparent = (0..self.scene.objects.len()).filter(|&i| self.is_transparent(i));
        if !attenuates(self.medium(None)) && !transparent.map(Some).any(|i| attenuates(self.medium(i))) {
            return Color::WHITE;
        }
        let mut ends = self.crossings(ray, distance, &counts);
        ends.push(distance);
        ends.sort_by(f64::total_cmp);
        let mut clarity = Color::WHITE;
        let mut start = 0.0;
        for end in ends {
            // Past the last surface one place is as good as any other.
            let middle = if end.is_finite() { 0.5 * (start + end) } else { 2.0 * start + 1.0 };
            let medium = self.medium(self.prevailing(ray.at(middle), None, &counts));
            clarity = clarity * medium.attenuation.map(|c| if c == 0.0 { 1.0 } else { (-c * (end - start)).exp() });
            start = end;
        }
        clarity
    }

    /// Where the ray crosses surfaces of transparent objects, before a distance.
    fn crossings(&self, ray: &Ray, distance: f64, counts: impl Fn(&Object<'_, f32>) -> bool) -> Vec<f64> {
        let mut crossings = Vec::new();
        for (i, &(primitive, object)) in self.primitives.iter().enumerate() {
            if self.is_transparent(object) && counts(&self.scene.objects[object]) {
                primitive.meet(ray, own(ray, i), &mut |meeting| {
                    if meeting.distance > ray.skip && meeting.distance < distance {
                        crossings.push(meeting.distance);
                    }
                });
            }
        }
        crossings
    }

    /// The transparent object that a place belongs to: of those that hold it the one of the highest priority, of equal
    /// ones the last in the list.
    fn prevailing(
        &self,
        place: Vector,
        side: Option<Side>,
        counts: impl Fn(&Object<'_, f32>) -> bool,
    ) -> Option<usize> {
        (0..self.scene.objects.len())
            .filter(|&object| self.is_transparent(object) && counts(&self.scene.objects[object]))
            .filter(|&object| self.holds(object, place, side))
            .max_by_key(|&object| priority(&self.scene.objects[object].material.interface))
    }

    /// Whether a place is inside an object: of any of its solids or, for a list of triangles, where half lines from it
    /// cross an odd number of them.
    fn holds(&self, object: usize, place: Vector, side: Option<Side>) -> bool {
        let mut parts = self.primitives.iter().enumerate().filter(|(_, (_, of))| *of == object);
        let known = |i| side.filter(|(primitive, _)| *primitive == i).map(|(_, inside)| inside);
        if matches!(self.scene.objects[object].shape, Shape::Triangles(_)) {
            let on_side = parts.clone().find_map(|(i, _)| known(i));
            return on_side
                .unwrap_or_else(|| parts.map(|(_, (triangle, _))| triangle.crossings(place)).sum::<usize>() % 2 == 1);
        }
        parts.any(|(i, (solid, _))| known(i).unwrap_or_else(|| solid.holds(place)))
    }

    /// The transparent object that a ray starts in.
    pub fn ahead(&self, ray: &Ray) -> Option<usize> {
        if self.scene.media() == 0 {
            return None;
        }
        // Far from the surface that it leaves, for the rounding, and near, for what comes next.
        let near = 1e-9 * (1.0 + ray.origin.largest());
        let first = self.crossings(ray, near, |_| true).into_iter().fold(near, f64::min);
        self.prevailing(ray.at(0.5 * first), None, |_| true)
    }

    /// The profile of an object, or of the space between all of them, if the index varies there.
    pub fn profile(&self, object: Option<usize>) -> Option<&Profile> {
        match self.filling(object).index {
            Index::Profile(number) => Some(&self.profiles[usize::from(number)]),
            Index::Constant(_) | Index::Dispersive(_) => None,
        }
    }

    /// Of an object, or of the space between all of them; its index only if it does not vary.
    pub fn medium(&self, object: Option<usize>) -> Medium {
        self.filling(object).into()
    }

    /// The same, at a point.
    fn medium_at(&self, object: Option<usize>, point: Vector) -> Medium {
        let medium = self.medium(object);
        match self.profile(object) {
            Some(profile) => Medium { indices: [profile.index(point); 3], ..medium },
            None => medium,
        }
    }

    fn filling(&self, object: Option<usize>) -> whit::scene::Medium<f32> {
        let inside = object.and_then(|object| self.scene.objects[object].material.interface.medium());
        inside.unwrap_or(self.scene.medium)
    }

    fn is_transparent(&self, object: usize) -> bool {
        self.scene.objects[object].material.interface.medium().is_some()
    }
}

/// None is the lowest.
fn priority(interface: &Interface<f32>) -> Option<u8> {
    match interface {
        Interface::Constant { medium, .. } | Interface::Dielectric { medium, .. } => medium.priority,
        _ => None,
    }
}
