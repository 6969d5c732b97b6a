//! The branches that a surface sends on, and their weights.

use whit::scene::{Channel, Fresnel, Interface};

use super::complex::Complex;
use super::film;
use super::fresnel::{conductor, dielectric, schlick};
use super::medium::{Border, mask};
use super::vector::{Color, Vector};
use super::world::Hit;

/// The branches of light at a surface.
#[derive(Clone, Debug)]
pub struct Branches {
    /// Weight and direction.
    pub reflected: Option<(Color, Vector)>,
    /// Several where light is dispersed.
    pub transmitted: Vec<Transmitted>,
    /// Whether total internal reflection takes all of it.
    pub total_internal: bool,
    /// The share of light that a coat leaves to the body.
    pub body: Color,
}

/// A transmitted branch.
#[derive(Clone, Copy, Debug)]
pub struct Transmitted {
    pub weight: Color,
    pub direction: Vector,
    /// What it carries from here on, if not all channels.
    pub channel: Option<Channel>,
}

impl Branches {
    const NONE: Self = Self { reflected: None, transmitted: Vec::new(), total_internal: false, body: Color::WHITE };
}

/// The branches for the unit direction of the ray, which carries one channel or all of them.
pub fn branches(
    hit: &Hit<'_>,
    direction: Vector,
    border: &Border,
    fresnel: Fresnel,
    channel: Option<Channel>,
) -> Branches {
    let reflected = |weight| Branches { reflected: Some((weight, reflect_to_front(direction, hit))), ..Branches::NONE };
    let cosine = incident_cosine(direction, hit.normal);
    let n1 = border.front.index(channel);
    match hit.object.material.interface {
        Interface::Opaque => Branches::NONE,
        Interface::Mirror { reflected: weight } => reflected(weight.into()),
        Interface::Metal { r0 } => reflected(Color::from(r0).map(|r0| schlick(r0, cosine))),
        Interface::Conductor { index, extinction, film } => {
            let (Color(index), Color(extinction)) = (index.into(), extinction.into());
            let metal = [0, 1, 2].map(|i| Complex::new(index[i], extinction[i]));
            reflected(match film {
                None => Color(metal.map(|metal| conductor(metal / n1.into(), cosine))),
                Some(film) => film::reflectance(&film, hit.point, n1, cosine, metal),
            })
        }
        Interface::Coat { index } => {
            let share = dielectric(fresnel, n1, index.into(), cosine);
            Branches { body: Color::grey(1.0 - share), ..reflected(Color::grey(share)) }
        }
        Interface::Constant { reflected, transmitted, .. } => {
            let (reflected, transmitted) = (Color::from(reflected), Color::from(transmitted));
            divide(hit, direction, border, channel, |passage, _| match passage {
                Some(_) => (reflected, transmitted),
                None => (reflected + transmitted, Color::BLACK),
            })
        }
        Interface::Dielectric { film, .. } => divide(hit, direction, border, channel, |passage, channel| {
            let reflected = match (passage, film) {
                (None, _) => Color::WHITE,
                (Some(passage), None) => {
                    let (n1, n2) = (border.front.index(channel), border.behind.index(channel));
                    Color::grey(dielectric(fresnel, n1, n2, passage.cosine))
                }
                (Some(passage), Some(film)) => {
                    let outer = border.front.index(channel);
                    film::reflectance(&film, hit.point, outer, passage.cosine, border.behind.base())
                }
            };
            (reflected, Color::WHITE + reflected * -1.0)
        }),
    }
}

/// The branches at a transparent surface. `shares` gives the weights of the reflected and the transmitted one for light
/// of one channel, or of all of them.
fn divide(
    hit: &Hit<'_>,
    direction: Vector,
    border: &Border,
    channel: Option<Channel>,
    shares: impl Fn(Option<&Passage>, Option<Channel>) -> (Color, Color),
) -> Branches {
    let mut sum = Color::BLACK;
    let mut branches = Branches::NONE;
    for channel in border.channels(channel) {
        let passage = passage(direction, hit, border.front.index(channel), border.behind.index(channel));
        let (reflected, transmitted) = shares(passage.as_ref(), channel);
        sum += reflected * mask(channel);
        if let Some(passage) = passage {
            let weight = transmitted * mask(channel);
            branches.transmitted.push(Transmitted { weight, direction: passage.direction, channel });
        }
    }
    branches.reflected = Some((sum, reflect_to_front(direction, hit)));
    branches.total_internal = branches.transmitted.is_empty();
    branches
}

/// F = D + 2·c₁·N with c₁ = −D·N.
pub fn reflect(direction: Vector, normal: Vector) -> Vector {
    direction - normal * (2.0 * direction.dot(normal))
}

/// R = η·D + (η·c₁ − √(1 − η²(1 − c₁²)))·N with η = n₁/n₂; a negative radicand is total internal reflection.
pub fn refract(direction: Vector, normal: Vector, eta: f64) -> Option<Vector> {
    let c1 = -direction.dot(normal);
    let radicand = 1.0 - eta * eta * (1.0 - c1 * c1);
    (radicand >= 0.0).then(|| direction * eta + normal * (eta * c1 - radicand.sqrt()))
}

/// Held between 0 and 1: a shading normal may look away from the ray.
fn incident_cosine(direction: Vector, normal: Vector) -> f64 {
    (-direction.dot(normal)).clamp(0.0, 1.0)
}

/// Reflection about the shading normal, or about the geometric one where the former would lead through the surface.
fn reflect_to_front(direction: Vector, hit: &Hit<'_>) -> Vector {
    let reflected = reflect(direction, hit.normal);
    if reflected.dot(hit.geometric) > 0.0 { reflected } else { reflect(direction, hit.geometric) }
}

/// Refraction, and the cosine of the angle of incidence about the same normal.
struct Passage {
    direction: Vector,
    cosine: f64,
}

/// Refraction about the shading normal, or about the geometric one where the former would stay on this side. None on
/// total internal reflection.
fn passage(direction: Vector, hit: &Hit<'_>, n1: f64, n2: f64) -> Option<Passage> {
    let about = |normal| {
        Some(Passage { direction: refract(direction, normal, n1 / n2)?, cosine: incident_cosine(direction, normal) })
    };
    let passage = about(hit.normal)?;
    if passage.direction.dot(hit.geometric) < 0.0 { Some(passage) } else { about(hit.geometric) }
}
