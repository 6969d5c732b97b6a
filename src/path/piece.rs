//! A short piece of a bent path.

use super::chords::Part;
use crate::intersect::{Bounds, Ray};
use crate::math::{Real, Vec3};

/// A place on a bent path.
///
/// The path is followed in the parameter τ with dτ = ds/n, in which the ray equation d/ds(n·dx/ds) = ∇n reads
/// x″ = ½∇(n²), without the direction in it (Sharma, Kumar and Ghatak, "Tracing rays through graded-index media", 1982).
#[derive(Clone, Copy, Debug)]
pub(super) struct Phase<T> {
    /// x
    pub position: Vec3<T>,
    /// x′, which is as long as the index of refraction.
    pub momentum: Vec3<T>,
    /// x″
    pub acceleration: Vec3<T>,
}

/// A path between two places on it: the cubic curve that has their positions and directions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<T> {
    /// Its Bézier points; the curve lies between them.
    points: [Vec3<T>; 4],
    /// The Bézier points of its momentum. Differences of its points would have few digits on a short piece far from the origin.
    momenta: [Vec3<T>; 3],
    /// How much it bends, in radians, roughly.
    pub bend: T,
}

impl<T: Real> Piece<T> {
    /// The piece between two places that are τ apart.
    pub(super) fn new(from: &Phase<T>, to: &Phase<T>, tau: T) -> Self {
        let third = tau * T::from_f32(1.0 / 3.0);
        let points =
            [from.position, from.position + from.momentum * third, to.position - to.momentum * third, to.position];
        let (before, after) = (from.acceleration * tau, to.acceleration * tau);
        let middle = (from.momentum + to.momentum + (before - after) * T::HALF) * T::HALF;
        let momenta = [from.momentum, middle, to.momentum];
        let bend = (to.momentum - from.momentum).length() / from.momentum.length();
        Self { points, momenta, bend }
    }

    /// Whether it is as near as anything that can be seen.
    pub(super) fn is_near(&self) -> bool {
        let near = |x: T| x.abs() <= T::FARTHEST;
        self.points.iter().all(|p| near(p.x) && near(p.y) && near(p.z))
    }

    /// The point at a share of the piece.
    pub(super) fn at(&self, share: T) -> Vec3<T> {
        let [a, b, c, d] = self.points;
        let rest = T::ONE - share;
        let three = T::TWO + T::ONE;
        a * (rest * rest * rest)
            + b * (three * rest * rest * share)
            + c * (three * rest * share * share)
            + d * (share * share * share)
    }

    /// The derivative by the share.
    fn tangent(&self, share: T) -> Vec3<T> {
        let [a, b, c, d] = self.points;
        let rest = T::ONE - share;
        let half = (b - a) * (rest * rest) + (c - b) * (T::TWO * rest * share) + (d - c) * (share * share);
        half * (T::TWO + T::ONE)
    }

    /// Where it goes at a share, a unit vector.
    pub(super) fn direction(&self, share: T) -> Vec3<T> {
        let [a, b, c] = self.momenta;
        let rest = T::ONE - share;
        (a * (rest * rest) + b * (T::TWO * rest * share) + c * (share * share)).normalized()
    }

    /// The length up to a share, by Simpson's rule.
    pub(super) fn length(&self, share: T) -> T {
        let [from, middle, to] = [T::ZERO, share * T::HALF, share].map(|share| self.tangent(share).length());
        (from + T::from_f32(4.0) * middle + to) * (share * T::from_f32(1.0 / 6.0))
    }

    /// Where it is at a share, and where it goes there.
    pub(super) fn ray(&self, share: T) -> Ray<T> {
        Ray { origin: self.at(share), direction: self.direction(share) }
    }

    /// A distance that no point of it is farther from its start than.
    pub(super) fn reach(&self) -> T {
        let [a, b, c, d] = self.points;
        (b - a).length() + (c - b).length() + (d - c).length()
    }

    /// The piece up to a share of it (de Casteljau's division).
    pub(super) fn up_to(&self, share: T) -> Self {
        let [a, b, c, d] = self.points;
        let mix = |from: Vec3<T>, to: Vec3<T>| from + (to - from) * share;
        let (ab, bc, cd) = (mix(a, b), mix(b, c), mix(c, d));
        let (abc, bcd) = (mix(ab, bc), mix(bc, cd));
        let [from, middle, to] = self.momenta;
        let (before, after) = (mix(from, middle), mix(middle, to));
        let momenta = [from, before, mix(before, after)];
        Self { points: [a, ab, abc, mix(abc, bcd)], momenta, bend: self.bend * share }
    }

    /// Where `height` is 0 on a piece where it is not above 0 first and above 0 at last: by regula falsi, with the Illinois
    /// rule, which takes a few trials to the last digits.
    pub(super) fn crossing(&self, height: impl Fn(Vec3<T>) -> T) -> T {
        let (mut low, mut high) = (T::ZERO, T::ONE);
        let (mut below, mut above) = (height(self.at(low)).min(T::ZERO), height(self.at(high)));
        for _ in 0..12 {
            let width = above - below;
            if width <= T::ZERO {
                break;
            }
            let share = low - (high - low) * below / width;
            let found = height(self.at(share));
            if found > T::ZERO {
                (high, above) = (share, found);
                below *= T::HALF;
            } else {
                (low, below) = (share, found);
                above *= T::HALF;
            }
        }
        high
    }

    pub(super) fn bounds(&self) -> Bounds<T> {
        Bounds::around(&self.points)
    }

    /// The chord of a part, and its length; `None` where it is too short to have a direction.
    pub(super) fn chord(&self, part: Part<T>) -> Option<(Ray<T>, T)> {
        let origin = self.at(part.from);
        let way = self.at(part.to) - origin;
        // Short chords of small scenes have squares that are too small for the number type.
        let size = way.largest();
        (size >= T::SMALLEST).then(|| {
            let scaled = way * (T::ONE / size);
            let length = scaled.length();
            (Ray { origin, direction: scaled * (T::ONE / length) }, length * size)
        })
    }
}
