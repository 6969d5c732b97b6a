//! What an interface does to a ray: where the two branches go and what they weigh.

use super::film::reflectance_of_film;
use crate::intersect::Surface;
use crate::math::{Complex, Real, Rgb, Vec3};
use crate::optics::{
    fresnel_conductor, fresnel_dielectric, reflect, refract, schlick, schlick_dielectric, transmitted_cosine,
};
use crate::scene::{Effects, Fresnel, Interface};

/// The two branches at an interface, each a unit direction and a weight.
pub(super) struct Split<T> {
    pub reflected: Option<(Vec3<T>, Rgb<T>)>,
    pub transmitted: Option<(Vec3<T>, Rgb<T>)>,
    /// The share of the light that gets through to the body.
    pub body: T,
    /// Whether all light is reflected although some could have been transmitted.
    pub is_total: bool,
}

/// A surface and a ray that comes from its outside.
pub(super) struct Facing<'s, T> {
    pub surface: &'s Surface<T>,
    pub incident: Vec3<T>,
    /// The number of bounces before.
    pub depth: u8,
}

/// Weight of the reflected branch; weight of the transmitted branch and the cosine of its angle.
type Weights<T> = (Rgb<T>, Option<(Rgb<T>, T)>);

impl<T: Real> Facing<'_, T> {
    /// How far the cosine of the angle of incidence may be off. Each bounce leaves the direction good to 8 roundings: 3 of
    /// the new direction, as many of its length, and 2 of the normal, which turns within the rounding of the point as well.
    #[cold]
    fn uncertainty(&self) -> T {
        let bounces = T::from_u32(u32::from(self.depth) + 1);
        bounces * (T::ONE.roundings(8.0) + self.surface.turn())
    }

    /// What an interface between media of these indices does. `n2` is not looked at where nothing is transmitted.
    pub(super) fn split<const EFFECTS: u64>(
        &self,
        interface: &Interface<T>,
        fresnel: Fresnel,
        n1: T,
        n2: T,
    ) -> Split<T> {
        let effects = const { Effects::from_bits(EFFECTS) };
        if effects.has(Effects::CONSTANT.with(Effects::DIELECTRIC)) && interface.medium().is_some() {
            return self.both::<EFFECTS>(interface, fresnel, n1, n2);
        }
        let cosine = self.cosine(self.surface.shading::<EFFECTS>());
        let mut body = T::ONE;
        let weight = match *interface {
            Interface::Mirror { reflected } if effects.has(Effects::MIRROR) => reflected,
            Interface::Metal { r0 } if effects.has(Effects::METAL) => r0.map(|r0| schlick(r0, cosine)),
            Interface::Conductor { index, extinction, film: Some(film) } if effects.has(Effects::CONDUCTOR_FILM) => {
                let base = index.zip(extinction, |re, im| Complex { re, im });
                reflectance_of_film::<T, EFFECTS>(&film, self.surface.point, n1, base, cosine)
            }
            Interface::Conductor { index, extinction, .. } if effects.has(Effects::CONDUCTOR) => {
                index.zip(extinction, |index, extinction| fresnel_conductor(index / n1, extinction / n1, cosine).mean())
            }
            Interface::Coat { index } if effects.has(Effects::COAT) => {
                let r = coat::<T, EFFECTS>(fresnel, n1, index, cosine);
                body = T::ONE - r;
                Rgb::grey(r)
            }
            _ => return Split { reflected: None, transmitted: None, body, is_total: false },
        };
        Split { reflected: Some((self.reflected::<EFFECTS>(), weight)), transmitted: None, body, is_total: false }
    }

    /// The cosine of the angle of incidence; 0 for a shading normal that faces away from the ray.
    fn cosine(&self, normal: Vec3<T>) -> T {
        (-self.incident.dot(normal)).max(T::ZERO).min(T::ONE)
    }

    /// The reflected direction, at the geometric normal where the shading normal would send it into the surface.
    fn reflected<const EFFECTS: u64>(&self) -> Vec3<T> {
        let (normal, shading) = (self.surface.normal, self.surface.shading::<EFFECTS>());
        let direction = self.mirror(shading, -self.incident.dot(shading));
        if direction.dot(normal) > T::ZERO { direction } else { self.mirror(normal, self.cosine(normal)) }
    }

    /// The direction mirrored at a normal.
    fn mirror(&self, normal: Vec3<T>, cosine: T) -> Vec3<T> {
        reflect(self.incident, normal, cosine).normalized()
    }

    /// What an interface does that reflects and transmits.
    fn both<const EFFECTS: u64>(&self, interface: &Interface<T>, fresnel: Fresnel, n1: T, n2: T) -> Split<T> {
        let at = |normal| self.both_at::<EFFECTS>(normal, interface, fresnel, n1, n2);
        let (normal, shading) = (self.surface.normal, self.surface.shading::<EFFECTS>());
        if !Effects::from_bits(EFFECTS).has(Effects::SMOOTH_TRIANGLE) {
            return at(normal);
        }
        if shading.dot(self.incident) < T::ZERO {
            let split = at(shading);
            // A shading normal can send the refracted ray to the wrong side; the geometric normal cannot.
            if !split.transmitted.is_some_and(|(direction, _)| direction.dot(normal) >= T::ZERO) {
                return split;
            }
        }
        at(normal)
    }

    fn both_at<const EFFECTS: u64>(
        &self,
        normal: Vec3<T>,
        interface: &Interface<T>,
        fresnel: Fresnel,
        n1: T,
        n2: T,
    ) -> Split<T> {
        let cosine = self.cosine(normal);
        let weights = |cosine| self.weights::<EFFECTS>(interface, fresnel, n1, n2, cosine);
        let (reflected, transmitted) = match weights(cosine) {
            // Total reflection that rounding may have made is none: what has entered glass through its surface gets out
            // through the surface opposite.
            (_, None) => weights((cosine + self.uncertainty()).min(T::ONE)),
            certain => certain,
        };
        let transmitted = transmitted.map(|(weight, transmitted_cosine)| {
            (refract(self.incident, normal, n1 / n2, cosine, transmitted_cosine).normalized(), weight)
        });
        let is_total = transmitted.is_none();
        Split { reflected: Some((self.reflected::<EFFECTS>(), reflected)), transmitted, body: T::ONE, is_total }
    }

    /// The weights of both branches at a cosine of the angle of incidence; of the reflected one alone where reflection is
    /// total.
    fn weights<const EFFECTS: u64>(
        &self,
        interface: &Interface<T>,
        fresnel: Fresnel,
        n1: T,
        n2: T,
        cosine: T,
    ) -> Weights<T> {
        let effects = const { Effects::from_bits(EFFECTS) };
        let (r, transmitted_cosine) = match interface {
            Interface::Constant { reflected, transmitted, .. } if effects.has(Effects::CONSTANT) => {
                return match transmitted_cosine(n1, n2, cosine) {
                    Some(transmitted_cosine) => (*reflected, Some((*transmitted, transmitted_cosine))),
                    None => (*reflected + *transmitted, None),
                };
            }
            Interface::Dielectric { film: Some(film), .. } if effects.has(Effects::DIELECTRIC_FILM) => {
                let Some(transmitted_cosine) = transmitted_cosine(n1, n2, cosine) else { return (Rgb::WHITE, None) };
                let base = Rgb::grey(Complex { re: n2, im: T::ZERO });
                let r = reflectance_of_film::<T, EFFECTS>(film, self.surface.point, n1, base, cosine);
                (r, transmitted_cosine)
            }
            _ if effects.has(Effects::FRESNEL.with(Effects::SCHLICK)) => {
                let Some((r, transmitted_cosine)) = reflectance::<T, EFFECTS>(fresnel, n1, n2, cosine) else {
                    return (Rgb::WHITE, None);
                };
                (Rgb::grey(r), transmitted_cosine)
            }
            _ => return (Rgb::WHITE, None),
        };
        (r, Some((r.map(|r| T::ONE - r), transmitted_cosine)))
    }
}

/// The reflectance of a clear coat.
fn coat<T: Real, const EFFECTS: u64>(fresnel: Fresnel, outer: T, coat: T, cosine: T) -> T {
    reflectance::<T, EFFECTS>(fresnel, outer, coat, cosine).map_or(T::ONE, |(r, _)| r)
}

/// The reflectance between two dielectrics and the cosine behind; `None` on total internal reflection.
fn reflectance<T: Real, const EFFECTS: u64>(fresnel: Fresnel, n1: T, n2: T, cosine: T) -> Option<(T, T)> {
    let effects = const { Effects::from_bits(EFFECTS) };
    let exact = !effects.has(Effects::SCHLICK) || (fresnel == Fresnel::Exact && effects.has(Effects::FRESNEL));
    if exact {
        let (polarized, transmitted_cosine) = fresnel_dielectric(n1, n2, cosine)?;
        return Some((polarized.mean(), transmitted_cosine));
    }
    schlick_dielectric(n1, n2, cosine)
}
