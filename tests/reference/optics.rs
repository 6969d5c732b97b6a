//! The branches that a surface sends on, and their weights.

use whit::scene::Interface;

use super::vector::{Color, Vector};
use super::world::Hit;

/// The branches of light at a surface: weight and direction.
#[derive(Clone, Copy, Debug, Default)]
pub struct Branches {
    pub reflected: Option<(Color, Vector)>,
    pub transmitted: Option<(Color, Vector)>,
    /// Whether total internal reflection takes all of it.
    pub total_internal: bool,
}

/// The branches for the unit direction of the ray. `surroundings` is the index of refraction outside.
pub fn branches(hit: &Hit<'_>, direction: Vector, surroundings: f64) -> Branches {
    let reflected_by = |weight| Some((weight, reflect_to_front(direction, hit)));
    match hit.object.material.interface {
        Interface::Opaque => Branches::default(),
        Interface::Mirror { reflected } => Branches { reflected: reflected_by(reflected.into()), ..Default::default() },
        Interface::Metal { r0 } => {
            let cosine = incident_cosine(direction, hit.normal);
            Branches { reflected: reflected_by(Color::from(r0).map(|r0| schlick(r0, cosine))), ..Default::default() }
        }
        Interface::Constant { reflected, transmitted, index } => {
            let (reflected, transmitted) = (Color::from(reflected), Color::from(transmitted));
            match passage(direction, hit, surroundings, index.into()) {
                Some(passage) => Branches {
                    reflected: reflected_by(reflected),
                    transmitted: Some((transmitted, passage.direction)),
                    total_internal: false,
                },
                None => Branches {
                    reflected: reflected_by(reflected + transmitted),
                    transmitted: None,
                    total_internal: true,
                },
            }
        }
        Interface::Dielectric { index } => match passage(direction, hit, surroundings, index.into()) {
            Some(passage) => Branches {
                reflected: reflected_by(Color::grey(passage.reflectance)),
                transmitted: Some((Color::grey(1.0 - passage.reflectance), passage.direction)),
                total_internal: false,
            },
            None => Branches { reflected: reflected_by(Color::WHITE), transmitted: None, total_internal: true },
        },
    }
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

/// R = R₀ + (1 − R₀)·(1 − cos θ)⁵: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994.
pub fn schlick(r0: f64, cosine: f64) -> f64 {
    r0 + (1.0 - r0) * (1.0 - cosine).powi(5)
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

/// Refraction with Schlick's reflectance.
struct Passage {
    direction: Vector,
    reflectance: f64,
}

/// Refraction about the shading normal, or about the geometric one where the former would stay on this side. The
/// reflectance takes the cosine on the less dense side, about the same normal. None on total internal reflection.
fn passage(direction: Vector, hit: &Hit<'_>, surroundings: f64, inside: f64) -> Option<Passage> {
    let (n1, n2) = if hit.outside { (surroundings, inside) } else { (inside, surroundings) };
    let about = |normal| Some((refract(direction, normal, n1 / n2)?, normal));
    let (refracted, normal) = match about(hit.normal)? {
        through if through.0.dot(hit.geometric) < 0.0 => through,
        _ => about(hit.geometric)?,
    };
    let cosine = if n1 <= n2 { incident_cosine(direction, normal) } else { incident_cosine(refracted, normal) };
    let r0 = ((n1 - n2) / (n1 + n2)).powi(2);
    Some(Passage { direction: refracted, reflectance: schlick(r0, cosine) })
}
