//! Light around a black hole that does not turn: in Schwarzschild's coordinates it stays in a plane and has
//! u″ + u = 3·M·u² with u = 1/r by the azimuth φ. C. Misner, K. Thorne and J. Wheeler, Gravitation, section 25.6.

use whit::scene;

use super::integrator::{Jet, between, growth, root, step};
use super::path::{Piece, Place};
use super::vector::Vector;

/// The largest error of a step of u and of its slope, as a share of their size.
const TOLERANCE: f64 = 1e-14;

/// The longest step, in radians, and how much u may change in it.
const LONGEST: f64 = 0.1;
const MOST_CHANGE: f64 = 0.2;

/// Light that will be bent by less goes straight on.
const LEAST_BEND: f64 = 1e-11;

/// More pieces of a path than that go round and round.
const MOST: usize = 100_000;

/// u·M at the horizon.
pub const HORIZON: f64 = 0.5;

/// A black hole in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    pub center: Vector,
    pub mass: f64,
}

impl Hole {
    /// Whether a straight line gets behind the horizon before a distance.
    pub fn blocks(&self, origin: Vector, direction: Vector, distance: f64) -> bool {
        let to_center = self.center - origin;
        let nearest = to_center.dot(direction).clamp(0.0, distance);
        (to_center - direction * nearest).length() <= self.mass / HORIZON
    }
}

impl From<&scene::BlackHole<f32>> for Hole {
    fn from(hole: &scene::BlackHole<f32>) -> Self {
        Self { center: hole.center.into(), mass: hole.mass.into() }
    }
}

/// u·M and its slope by φ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    pub u: f64,
    pub slope: f64,
}

impl Orbit {
    /// A step of so many radians, and its error as a share of the one allowed.
    pub fn step(&self, h: f64) -> (Self, f64) {
        let at = |&[du, dv]: &[f64; 2]| Self { u: self.u + du, slope: self.slope + dv };
        let step = step(|change| [at(change).slope, at(change).second()], h);
        let error = step.error[0].hypot(step.error[1]) / (TOLERANCE * self.u.hypot(self.slope));
        (at(&step.change), if error.is_nan() { f64::INFINITY } else { error })
    }

    /// A step that is as long as the tolerance lets it be, from the length to try first, which becomes that of the next
    /// step.
    pub fn controlled(&self, next: &mut f64, longest: f64) -> (f64, Self) {
        loop {
            let h = next.min(longest);
            let (end, error) = self.step(h);
            *next = h * growth(error);
            if error <= 1.0 {
                return (h, end);
            }
        }
    }

    fn second(&self) -> f64 {
        (3.0 * self.u - 1.0) * self.u
    }

    /// M²/b², which stays the same along the orbit; b is what the smallest distance would be without the hole.
    pub fn constant(&self) -> f64 {
        self.slope * self.slope + self.u * self.u * (1.0 - 2.0 * self.u)
    }

    /// Whether next to nothing is left of the bend of light that goes away: ¾·M·b³/r⁴, far out.
    fn is_over(&self) -> bool {
        self.slope < 0.0 && 0.75 * self.constant().powf(-1.5) * self.u.powi(4) < LEAST_BEND
    }

    fn jet(&self) -> Jet<f64> {
        Jet { value: self.u, first: self.slope, second: self.second() }
    }
}

/// The plane of an orbit.
#[derive(Clone, Copy, Debug)]
struct Plane {
    hole: Hole,
    /// Where φ is 0, and where it is 90°.
    axes: [Vector; 2],
}

impl Plane {
    fn place(&self, phi: f64, Orbit { u, slope }: Orbit) -> Place {
        let [a, b] = self.axes;
        let (sine, cosine) = phi.sin_cos();
        let (away, around) = (a * cosine + b * sine, b * cosine - a * sine);
        // dr/dφ = −M·u′/u²
        let direction = (around * u - away * slope).normalized();
        Place { point: self.hole.center + away * (self.hole.mass / u), direction }
    }
}

/// A step: a polynomial for u.
#[derive(Clone, Copy, Debug)]
pub struct Arc {
    plane: Plane,
    phi: f64,
    h: f64,
    start: Orbit,
    end: Orbit,
}

impl Arc {
    fn orbit(&self, share: f64) -> Orbit {
        let [u, slope] = between(&self.start.jet(), &self.end.jet(), self.h, share);
        Orbit { u, slope }
    }

    pub fn at(&self, share: f64) -> Place {
        self.plane.place(self.phi + share * self.h, self.orbit(share))
    }

    /// How long the curve is up to there: ds/dφ = M·√(u² + u′²)/u², by Gauss's rule with five points.
    pub fn length_to(&self, share: f64) -> f64 {
        const POINTS: [[f64; 2]; 5] = [
            [-0.906_179_845_938_664, 0.236_926_885_056_189_08],
            [-0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
            [0.0, 0.568_888_888_888_888_9],
            [0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
            [0.906_179_845_938_664, 0.236_926_885_056_189_08],
        ];
        let rate = |share| {
            let Orbit { u, slope } = self.orbit(share);
            self.plane.hole.mass * u.hypot(slope) / (u * u)
        };
        0.5 * share * self.h * POINTS.iter().map(|[x, weight]| weight * rate(0.5 * share * (1.0 + x))).sum::<f64>()
    }
}

/// The pieces of a path, one after the other.
pub struct Course {
    /// None for light that goes straight to the hole or away from it.
    plane: Option<Plane>,
    hole: Hole,
    place: Place,
    phi: f64,
    orbit: Orbit,
    /// The step to try next, in radians.
    h: f64,
    pieces: usize,
    ended: bool,
    pub captured: bool,
}

impl Course {
    pub fn new(hole: &Hole, place: Place) -> Self {
        let from_center = place.point - hole.center;
        let (distance, away) = (from_center.length(), from_center.normalized());
        let radial = place.direction.dot(away);
        let across = place.direction - away * radial;
        let transverse = across.length();
        let u = hole.mass / distance;
        let captured = u >= HORIZON;
        let plane = (transverse > 1e-14).then(|| Plane { hole: *hole, axes: [away, across.normalized()] });
        let orbit = Orbit { u, slope: -u * radial / transverse };
        Self { plane, hole: *hole, place, phi: 0.0, orbit, h: LONGEST, pieces: 0, ended: captured, captured }
    }

    /// The whole path of light in line with the hole.
    fn radial(&mut self) -> Piece {
        self.ended = true;
        self.captured = (self.hole.center - self.place.point).dot(self.place.direction) > 0.0;
        let distance = (self.hole.center - self.place.point).length() - self.hole.mass / HORIZON;
        Piece::Straight { start: self.place, length: if self.captured { distance } else { f64::INFINITY } }
    }

    fn bent(&mut self, plane: Plane) -> Arc {
        let start = self.orbit;
        let longest = LONGEST.min(MOST_CHANGE * start.u / start.slope.abs());
        let (mut h, mut end) = start.controlled(&mut self.h, longest);
        if end.u >= HORIZON {
            let rest = |h| {
                let (end, _) = start.step(h);
                [end.u - HORIZON, end.slope]
            };
            h = root(rest, 0.0, h, 1e-15);
            end = start.step(h).0;
            (self.captured, self.ended) = (true, true);
        }
        let arc = Arc { plane, phi: self.phi, h, start, end };
        self.phi += h;
        self.orbit = end;
        self.place = plane.place(self.phi, end);
        arc
    }
}

impl Iterator for Course {
    type Item = Piece;

    fn next(&mut self) -> Option<Piece> {
        if self.ended {
            return None;
        }
        let Some(plane) = self.plane else { return Some(self.radial()) };
        self.pieces += 1;
        if self.orbit.is_over() || self.pieces > MOST {
            self.ended = true;
            return Some(Piece::Straight { start: self.place, length: f64::INFINITY });
        }
        Some(Piece::Orbit(self.bent(plane)))
    }
}
