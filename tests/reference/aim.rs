//! Bent paths from a point to a light, by shooting.

use super::integrator::root;
use super::light::frame;
use super::path::{Bend, Piece, Place};
use super::vector::Vector;

/// How near to the light a path has to end, in radians seen from the point.
const TOLERANCE: f64 = 1e-10;

/// Of the derivatives by the direction.
const DIFFERENCE: f64 = 1e-6;

const MOST_TRIALS: usize = 40;

/// What a path is to reach.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    Point(Vector),
    /// At infinity.
    Direction(Vector),
}

/// A path up to the light.
pub struct Path {
    /// At its start.
    pub direction: Vector,
    pub pieces: Vec<Piece>,
    /// Where the last piece ends, as a share of it.
    pub last: f64,
}

/// Where to aim from, and at what.
struct Shot<'a> {
    bend: Bend<'a>,
    origin: Vector,
    target: Target,
    /// The straight direction, and two across it.
    axes: [Vector; 3],
}

/// A bent path from a point that ends at the target, near the straight one.
pub fn aim(bend: Bend<'_>, origin: Vector, target: Target) -> Option<Path> {
    let straight = match target {
        Target::Point(point) => (point - origin).normalized(),
        Target::Direction(direction) => direction,
    };
    let (across, other) = frame(straight);
    let shot = Shot { bend, origin, target, axes: [straight, across, other] };
    shot.starts().into_iter().find_map(|start| shot.solve(start))
}

impl Shot<'_> {
    /// Offsets from the straight direction to start from. What starts there may get lost, in a black hole or in a layer; the
    /// others are away from the hole, on the side where the straight line is, or to both sides along the gradient.
    fn starts(&self) -> Vec<[f64; 2]> {
        let (away, signs) = match self.bend {
            Bend::Hole(hole) => (self.origin - hole.center, vec![1.0]),
            Bend::Graded(profile) => (profile.level.gradient(self.origin), vec![1.0, -1.0]),
        };
        let [a, b] = [away.dot(self.axes[1]), away.dot(self.axes[2])];
        let length = a.hypot(b);
        let mut starts = vec![[0.0; 2]];
        if length > 1e-9 * away.length() {
            let offsets = (1..=60).map(|i| (0.025 * f64::from(i)).tan() / length);
            starts.extend(offsets.flat_map(|share| signs.iter().map(move |sign| [a * share * sign, b * share * sign])));
        }
        starts
    }

    fn direction(&self, [a, b]: [f64; 2]) -> Vector {
        (self.axes[0] + self.axes[1] * a + self.axes[2] * b).normalized()
    }

    fn solve(&self, start: [f64; 2]) -> Option<Path> {
        let mut at = start;
        let (mut off, mut path) = self.shoot(at)?;
        for _ in 0..MOST_TRIALS {
            if size(off) <= TOLERANCE {
                return Some(path);
            }
            let change = self.newton(at, off)?;
            // The longest of the whole step, a half of it and so on that helps.
            let halves = (0..12).map(|i| 0.5_f64.powi(i));
            (at, (off, path)) = halves
                .filter_map(|share| {
                    let next = [at[0] - share * change[0], at[1] - share * change[1]];
                    Some((next, self.shoot(next)?))
                })
                .find(|(_, (next, _))| size(*next) < size(off))?;
        }
        None
    }

    /// What to take from the offsets by Newton's method.
    fn newton(&self, [a, b]: [f64; 2], off: [f64; 2]) -> Option<[f64; 2]> {
        let by = |next: [f64; 2]| {
            let (there, _) = self.shoot(next)?;
            Some([0, 1].map(|i| (there[i] - off[i]) / DIFFERENCE))
        };
        let ([p, q], [r, s]) = (by([a + DIFFERENCE, b])?, by([a, b + DIFFERENCE])?);
        let determinant = p * s - r * q;
        let change = [(off[0] * s - r * off[1]) / determinant, (p * off[1] - q * off[0]) / determinant];
        change.iter().all(|x| x.is_finite()).then_some(change)
    }

    /// How far from the target the path ends that starts with these offsets.
    fn shoot(&self, offsets: [f64; 2]) -> Option<([f64; 2], Path)> {
        let direction = self.direction(offsets);
        let mut course = self.bend.course(Place { point: self.origin, direction });
        let mut pieces = Vec::new();
        let [straight, across, other] = self.axes;
        for piece in course.by_ref() {
            if let Target::Point(target) = self.target {
                let distance = (target - self.origin).length();
                if let Some((piece, last)) = cut(&piece, target, straight) {
                    let off = piece.at(last).point - target;
                    pieces.push(piece);
                    let path = Path { direction, pieces, last };
                    return Some(([off.dot(across) / distance, off.dot(other) / distance], path));
                }
            }
            pieces.push(piece);
        }
        let (Target::Direction(_), false) = (self.target, course.captured()) else { return None };
        let Some(Piece::Straight { start, .. }) = pieces.last() else { return None };
        let end = start.direction;
        let path = Path { direction, pieces, last: 1.0 };
        (end.dot(straight) > 0.0).then(|| ([end.dot(across), end.dot(other)], path))
    }
}

/// A piece up to the plane through a point, and the share of it where it gets there.
fn cut(piece: &Piece, target: Vector, normal: Vector) -> Option<(Piece, f64)> {
    let before = |point: Vector| (point - target).dot(normal);
    if let Piece::Straight { start, length } = *piece {
        let distance = -before(start.point) / start.direction.dot(normal);
        return (0.0..=length).contains(&distance).then_some((Piece::Straight { start, length: distance }, 1.0));
    }
    let [a, b] = [0.0, 1.0].map(|share| before(piece.at(share).point));
    (a <= 0.0 && b >= 0.0).then(|| {
        let share = root(|share| [before(piece.at(share).point), b - a], 0.0, 1.0, 1e-15 * target.largest());
        (*piece, share)
    })
}

fn size([a, b]: [f64; 2]) -> f64 {
    a.hypot(b)
}
