//! Light in a medium of varying index: d/ds(n·dx/ds) = ∇n along the arc length s.
//! M. Born and E. Wolf, Principles of Optics, section 3.2.

use super::integrator::{Jet, between, growth, root, step};
use super::path::{Piece, Place};
use super::profile::{Level, Profile, Region};
use super::vector::Vector;

/// The largest error of a step, of the direction in radians and of the place as a share of lengths.
const TOLERANCE: f64 = 1e-13;

/// More pieces of a path than that are those of light that is caught in a layer.
const MOST: usize = 100_000;

/// A step: a polynomial of the arc length.
#[derive(Clone, Copy, Debug)]
pub struct Arc {
    pub start: Jet<Vector>,
    pub end: Jet<Vector>,
    pub length: f64,
}

impl Arc {
    pub fn at(&self, share: f64) -> Place {
        let [point, direction] = between(&self.start, &self.end, self.length, share);
        Place { point, direction: direction.normalized() }
    }
}

/// The pieces of a path, one after the other.
pub struct Course<'a> {
    profile: &'a Profile,
    region: Region,
    place: Place,
    /// The length to try next.
    h: f64,
    pieces: usize,
    ended: bool,
}

impl<'a> Course<'a> {
    pub fn new(profile: &'a Profile, place: Place) -> Self {
        let region = profile.region(place.point, place.direction);
        Self { profile, region, place, h: 1e-2 * profile.feature(), pieces: 0, ended: false }
    }

    /// How fast the level changes along the path.
    fn rate(&self, place: &Place) -> f64 {
        place.direction.dot(self.profile.level.gradient(place.point))
    }

    /// The distance to the border of a region of constant index.
    fn straight(&self) -> f64 {
        let [low, high] = self.profile.bounds(self.region);
        let rate = self.rate(&self.place);
        let reached = |border| self.profile.level.reached(border, self.place.point, self.place.direction);
        let round = matches!(self.profile.level, Level::Radius { .. });
        match self.region {
            Region::Below if rate > 0.0 || round => reached(high).map(|[_, last]| last),
            Region::Above if rate < 0.0 => reached(low).map(|[first, _]| first),
            _ => None,
        }
        .map_or(f64::INFINITY, |distance| distance.max(0.0))
    }

    /// The end of a step of length h by the law after a joint, and its error as a share of the one allowed.
    fn step(&self, number: usize, h: f64) -> (Place, f64) {
        let Place { point, direction } = self.place;
        let momentum = direction * self.profile.smooth(point, number).0;
        let parts = |&[x, y, z, p, q, r]: &[f64; 6]| (Vector::new(x, y, z), Vector::new(p, q, r));
        let step = step(
            |change| {
                let (moved, turned) = parts(change);
                let (n, gradient) = self.profile.smooth(point + moved, number);
                let rate = (momentum + turned) * n.recip();
                [rate.x, rate.y, rate.z, gradient.x, gradient.y, gradient.z]
            },
            h,
        );
        let ((moved, turned), (off, askew)) = (parts(&step.change), parts(&step.error));
        let error = (off.length() / (self.profile.feature() + h)).max(askew.length()) / TOLERANCE;
        let end = Place { point: point + moved, direction: (momentum + turned).normalized() };
        (end, if error.is_nan() { f64::INFINITY } else { error })
    }

    /// A step that is as long as the tolerance lets it be.
    fn controlled(&mut self, number: usize) -> (f64, Place) {
        let shortest = 1e-10 * self.profile.feature();
        loop {
            let h = self.h;
            let (end, error) = self.step(number, h);
            self.h = h * growth(error);
            if error <= 1.0 || h <= shortest {
                self.h = self.h.max(shortest);
                return (h, end);
            }
        }
    }

    /// A step that ends at the border of its region if it gets there.
    fn bent(&mut self, number: usize) -> Arc {
        let start = self.place;
        let (mut h, mut end) = self.controlled(number);
        let [low, high] = self.profile.bounds(self.region);
        let level = |place: &Place| self.profile.level.at(place.point);
        let outside = |place: &Place| level(place) < low || level(place) > high;
        if self.rate(&start) * self.rate(&end) < 0.0 {
            let turn = turn([level(&start), level(&end)], [self.rate(&start), self.rate(&end)], h);
            let there = self.step(number, turn).0;
            if outside(&end) || outside(&there) {
                (h, end) = (turn, there);
            }
        }
        if outside(&end) {
            let upwards = level(&end) > high;
            let border = if upwards { high } else { low };
            let rest = |h| {
                let end = self.step(number, h).0;
                [level(&end) - border, self.rate(&end)]
            };
            h = root(rest, 0.0, h, 1e-15 * (border.abs() + self.profile.feature()));
            end = self.step(number, h).0;
            self.region = self.profile.next(self.region, upwards);
        }
        self.place = end;
        Arc { start: self.jet(&start, number), end: self.jet(&end, number), length: h }
    }

    /// n·x″ = ∇n − x′·(x′·∇n)
    fn jet(&self, place: &Place, number: usize) -> Jet<Vector> {
        let (n, gradient) = self.profile.smooth(place.point, number);
        let second = (gradient - place.direction * place.direction.dot(gradient)) * n.recip();
        Jet { value: place.point, first: place.direction, second }
    }
}

impl Iterator for Course<'_> {
    type Item = Piece;

    fn next(&mut self) -> Option<Piece> {
        if self.ended {
            return None;
        }
        self.pieces += 1;
        let Region::Within(number) = self.region else {
            let start = self.place;
            let length = self.straight();
            self.ended = length == f64::INFINITY;
            if !self.ended {
                self.place.point = start.point + start.direction * length;
                self.region = self.profile.next(self.region, self.region == Region::Below);
            }
            return Some(Piece::Straight { start, length });
        };
        self.ended = self.pieces > MOST;
        Some(Piece::Graded(self.bent(number)))
    }
}

/// Where the cubic polynomial with these values and slopes at the ends of a step, of which the slopes have two signs,
/// turns.
fn turn([a, b]: [f64; 2], [a_slope, b_slope]: [f64; 2], h: f64) -> f64 {
    // Its slope, by share of the step: s₀ + 2·c·t + 3·d·t².
    let rise = (b - a) / h;
    let (c, d) = (3.0 * rise - 2.0 * a_slope - b_slope, a_slope + b_slope - 2.0 * rise);
    h * root(|t| [a_slope + (2.0 * c + 3.0 * d * t) * t, 2.0 * c + 6.0 * d * t], 0.0, 1.0, 1e-15 * a_slope.abs())
}
