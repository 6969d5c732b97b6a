//! What an interface does to a ray: where the two branches go and what they weigh.

use crate::intersect::Surface;
use crate::math::{Real, Rgb, Vec3};
use crate::optics::{reflect, refract, schlick, schlick_dielectric, transmitted_cosine_squared};
use crate::scene::{Effects, Interface};

/// The two branches at an interface, each a unit direction and a weight.
pub(super) struct Split<T> {
    pub reflected: Option<(Vec3<T>, Rgb<T>)>,
    pub transmitted: Option<(Vec3<T>, Rgb<T>)>,
    /// Whether all light is reflected although some could have been transmitted.
    pub is_total: bool,
}

/// Weight of the reflected branch; weight of the transmitted branch and the cosine of its angle.
type Weights<T> = (Rgb<T>, Option<(Rgb<T>, T)>);

impl<T: Real> Split<T> {
    pub(super) fn new<const EFFECTS: u64>(
        interface: &Interface<T>,
        outer_index: T,
        surface: &Surface<T>,
        front: bool,
        incident: Vec3<T>,
    ) -> Self {
        let effects = const { Effects::from_bits(EFFECTS) };
        let facing = Facing::new(surface, front, incident);
        match *interface {
            Interface::Mirror { reflected } if effects.has(Effects::MIRROR) => facing.mirror(|_| reflected),
            Interface::Metal { r0 } if effects.has(Effects::METAL) => {
                facing.mirror(|cosine| r0.map(|r0| schlick(r0, cosine)))
            }
            Interface::Constant { reflected, transmitted, index } if effects.has(Effects::CONSTANT) => {
                facing.split(outer_index, index, |n1, n2, cosine| {
                    let square = transmitted_cosine_squared(n1 / n2, cosine);
                    if square < T::ZERO {
                        return (reflected + transmitted, None);
                    }
                    (reflected, Some((transmitted, square.sqrt())))
                })
            }
            Interface::Dielectric { index } if effects.has(Effects::DIELECTRIC) => {
                facing.split(outer_index, index, |n1, n2, cosine| match schlick_dielectric(n1, n2, cosine) {
                    Some((r, transmitted_cosine)) => (Rgb::grey(r), Some((Rgb::grey(T::ONE - r), transmitted_cosine))),
                    None => (Rgb::WHITE, None),
                })
            }
            _ => Self { reflected: None, transmitted: None, is_total: false },
        }
    }
}

/// A surface seen from the side of the incident ray.
struct Facing<T> {
    geometric: Vec3<T>,
    normal: Vec3<T>,
    incident: Vec3<T>,
    front: bool,
}

impl<T: Real> Facing<T> {
    fn new(surface: &Surface<T>, front: bool, incident: Vec3<T>) -> Self {
        let (geometric, normal) = surface.normals(front);
        Self { geometric, normal, incident, front }
    }

    /// The cosine of the angle of incidence; 0 for a shading normal that faces away from the ray.
    fn cosine(&self, normal: Vec3<T>) -> T {
        (-self.incident.dot(normal)).max(T::ZERO).min(T::ONE)
    }

    /// The reflected direction, at the geometric normal where the shading normal would send it into the surface.
    fn reflected(&self) -> Vec3<T> {
        let direction = reflect(self.incident, self.normal, -self.incident.dot(self.normal)).normalized();
        if direction.dot(self.geometric) > T::ZERO {
            return direction;
        }
        reflect(self.incident, self.geometric, self.cosine(self.geometric)).normalized()
    }

    fn mirror(&self, weight: impl FnOnce(T) -> Rgb<T>) -> Split<T> {
        let weight = weight(self.cosine(self.normal));
        Split { reflected: Some((self.reflected(), weight)), transmitted: None, is_total: false }
    }

    /// Two branches by weights(n₁, n₂, cosine) = (reflected, transmitted with its cosine unless reflection is total).
    fn split(&self, outer_index: T, inner_index: T, weights: impl Fn(T, T, T) -> Weights<T>) -> Split<T> {
        let (n1, n2) = if self.front { (outer_index, inner_index) } else { (inner_index, outer_index) };
        let at = |normal: Vec3<T>| {
            let cosine = self.cosine(normal);
            let (reflected, transmitted) = weights(n1, n2, cosine);
            let transmitted = transmitted.map(|(weight, transmitted_cosine)| {
                (refract(self.incident, normal, n1 / n2, cosine, transmitted_cosine).normalized(), weight)
            });
            let is_total = transmitted.is_none();
            Split { reflected: Some((self.reflected(), reflected)), transmitted, is_total }
        };
        if self.normal.dot(self.incident) >= T::ZERO {
            return at(self.geometric);
        }
        let split = at(self.normal);
        match split.transmitted {
            // A shading normal can send the refracted ray to the wrong side; the geometric normal cannot.
            Some((direction, _)) if direction.dot(self.geometric) >= T::ZERO => at(self.geometric),
            _ => split,
        }
    }
}
