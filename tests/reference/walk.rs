//! Bent paths as short straight spans, for what meets straight lines.

use super::path::{Piece, Place};
use super::shapes::Ray;
use super::touch::Capsule;
use super::vector::Vector;
use super::world::World;

/// How far a span near a primitive may be from the path, as a share of the length that goes with the bend.
const SAGITTA: f64 = 1e-9;

/// Halves of halves.
const MOST_DEPTH: u32 = 48;

/// A chord of a path.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    pub ray: Ray,
    pub length: f64,
    /// Its start, as a share of the piece.
    from: f64,
    to: f64,
    /// Whether a primitive may be in the way; if not, the span may be far from the path.
    pub near: bool,
    /// Of the path, by the length of the chord.
    pub stretch: f64,
}

impl Span {
    /// The reach for meetings: so far into the next span that none is lost between them by rounding, even where the path
    /// grazes a surface.
    pub fn reach(&self) -> f64 {
        self.length * (1.0 + 1e-9) + 1e-11 * self.ray.origin.largest()
    }

    /// The share of the piece at a distance from the span's start.
    pub fn share(&self, distance: f64) -> f64 {
        if self.length > 0.0 && self.length.is_finite() {
            self.from + (self.to - self.from) * (distance / self.length).min(1.0)
        } else {
            self.from
        }
    }
}

/// A piece of a path to walk along.
pub struct Walk<'a> {
    pub world: &'a World<'a>,
    pub piece: &'a Piece,
    /// Of the bend.
    pub scale: f64,
    /// The ray that the path starts with, if this is its first piece.
    pub start: Option<&'a Ray>,
}

impl Walk<'_> {
    /// The first thing that is found in one of the spans, in order, up to a share of the piece.
    pub fn find<T>(&self, to: f64, visit: &mut impl FnMut(&Span) -> Option<T>) -> Option<T> {
        if let Piece::Straight { start, length } = *self.piece {
            let length = if to < 1.0 { to * length } else { length };
            let ray = self.ray(start.point, start.direction, 0.0);
            return visit(&Span { ray, length, from: 0.0, to, near: true, stretch: 1.0 });
        }
        self.divide((0.0, self.piece.at(0.0)), (to, self.piece.at(to)), MOST_DEPTH, visit)
    }

    fn divide<T>(
        &self,
        start: (f64, Place),
        end: (f64, Place),
        depth: u32,
        visit: &mut impl FnMut(&Span) -> Option<T>,
    ) -> Option<T> {
        let ((from, a), (to, b)) = (start, end);
        let middle = (0.5 * (from + to), self.piece.at(0.5 * (from + to)));
        let chord = b.point - a.point;
        let length = chord.length();
        // More than the largest distance of the curve from the chord.
        let slack = [a, middle.1, b].map(|place| place.direction.cross(chord).length()).into_iter().fold(0.0, f64::max);
        let capsule = Capsule { from: a.point, to: b.point, radius: slack + 1e-14 * a.point.largest() };
        let near = self.world.primitives.iter().any(|(primitive, _)| primitive.may_touch(&capsule));
        if near && slack > SAGITTA * self.scale && depth > 0 {
            let found = self.divide(start, middle, depth - 1, visit);
            return found.or_else(|| self.divide(middle, end, depth - 1, visit));
        }
        // A chord as short as that has no direction.
        let direction = if length > 1e-12 * a.point.largest() { chord } else { a.direction };
        let arc = self.piece.length_to(to) - self.piece.length_to(from);
        let stretch = if length > 0.0 { arc / length } else { 1.0 };
        visit(&Span { ray: self.ray(a.point, direction, from), length, from, to, near, stretch })
    }

    fn ray(&self, origin: Vector, direction: Vector, from: f64) -> Ray {
        let ray = Ray::new(origin, direction);
        match self.start.filter(|_| from == 0.0) {
            Some(start) => Ray { left: start.left, skip: start.skip, ..ray },
            None => ray,
        }
    }
}
