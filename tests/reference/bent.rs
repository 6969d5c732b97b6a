//! What a ray meets where light is bent.

use super::path::{Bend, Piece, Place};
use super::shapes::Ray;
use super::vector::{Color, Vector};
use super::walk::Walk;
use super::world::{Hit, World};

/// The end of a path.
pub enum Arrival<'a> {
    /// The ray is the tangent at the hit, from some way before it.
    Surface {
        ray: Ray,
        hit: Hit<'a>,
        length: f64,
    },
    /// In a direction, far away.
    Away {
        direction: Vector,
    },
    Captured,
}

impl<'a> World<'a> {
    /// What bends the light of a ray.
    pub fn bend(&self, ray: &Ray) -> Option<Bend<'_>> {
        if let Some(hole) = &self.hole {
            return Some(Bend::Hole(hole));
        }
        if self.profiles.is_empty() {
            return None;
        }
        self.profile(self.ahead(ray)).map(Bend::Graded)
    }

    /// Follows a bent ray up to the first surface.
    pub fn travel(&self, bend: Bend<'_>, ray: &Ray) -> Arrival<'a> {
        let mut course = bend.course(Place { point: ray.origin, direction: ray.direction });
        let mut length = 0.0;
        let mut start = Some(ray);
        let mut direction = ray.direction;
        for piece in course.by_ref() {
            let walk = Walk { world: self, piece: &piece, scale: bend.scale(), start: start.take() };
            let found = walk.find(1.0, &mut |span| {
                let hit = span.near.then(|| self.nearest_before(&span.ray, span.reach())).flatten()?;
                let share = span.share(hit.distance);
                let within = if let Piece::Straight { .. } = piece { hit.distance } else { piece.length_to(share) };
                Some((arriving(&span.ray, &hit, piece.at(share).direction), hit, length + within))
            });
            if let Some((ray, hit, length)) = found {
                return Arrival::Surface { ray, hit, length };
            }
            length += piece.length();
            direction = match piece {
                Piece::Straight { start, .. } => start.direction,
                piece => piece.at(1.0).direction,
            };
        }
        if course.captured() { Arrival::Captured } else { Arrival::Away { direction } }
    }

    /// The share of light that is left after a length of the medium that a ray starts in.
    pub fn clarity_ahead(&self, ray: &Ray, length: f64) -> Color {
        let medium = self.medium(self.ahead(ray));
        medium.attenuation.map(|c| if c == 0.0 { 1.0 } else { (-c * length).exp() })
    }
}

/// The tangent of the path at a hit, or the chord where the tangent comes from the other side of the surface.
fn arriving(chord: &Ray, hit: &Hit<'_>, tangent: Vector) -> Ray {
    let direction = if tangent.dot(hit.geometric) < 0.0 { tangent } else { chord.direction };
    Ray { origin: hit.point - direction * hit.distance, direction, ..*chord }
}
