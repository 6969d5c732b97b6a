//! The way around a black hole.

use super::around::Around;
use super::arrival::{Arrival, Landing, StepsLeft};
use super::curve::{Curve, Pace};
use super::field::{Field, Orbit};
use super::piece::{Phase, Piece};
use crate::intersect::Ray;
use crate::math::{Real, Vec3};
use crate::scene::{BlackHole, Steps};

/// A path around a black hole.
pub(super) struct Passage<'p, 'a, T> {
    pub around: Around<'a, T>,
    pub hole: &'p BlackHole<T>,
    /// How far it may go.
    pub limit: T,
}

impl<'a, T: Real> Passage<'_, 'a, T> {
    /// Follows the path to its end.
    pub(super) fn follow<const EFFECTS: u64>(mut self, ray: &Ray<T>, steps: &mut StepsLeft) -> Arrival<'a, T> {
        let hole = self.hole;
        let field = Orbit::new(hole, ray.origin, ray.direction);
        let horizon = hole.mass + hole.mass;
        let acceleration = field.acceleration(ray.origin);
        let phase = Phase { position: ray.origin, momentum: ray.direction, acceleration };
        let mut curve = Curve { field, phase, pace: Pace::new::<EFFECTS>(hole.steps) };
        let mut distance = T::ZERO;
        if curve.field.distance(ray.origin) <= horizon {
            return Arrival::Captured;
        }
        loop {
            if let Some(direction) = leaving(&curve) {
                return self.straight::<EFFECTS>(&Ray { origin: curve.phase.position, direction }, distance);
            }
            let Some(piece) = curve.step::<EFFECTS>(steps) else {
                return Arrival::OutOfSteps(curve.direction());
            };
            let (piece, captured) = before_horizon(&curve, piece, horizon);
            let chords = curve.pace.chords(&piece, distance);
            if let Some(landing) = self.around.curved::<EFFECTS>(&piece, chords, distance) {
                return Arrival::Surface(landing);
            }
            if captured {
                return Arrival::Captured;
            }
            let (way, left) = (piece.length(T::ONE), self.limit - distance);
            distance += way;
            if way >= left {
                return Arrival::at_limit(self.limit, piece.ray(left / way));
            }
        }
    }

    /// Straight on, where hardly anything bends light any more.
    fn straight<const EFFECTS: u64>(&mut self, ray: &Ray<T>, distance: T) -> Arrival<'a, T> {
        let left = self.limit - distance;
        match self.around.straight::<EFFECTS>(ray, left, left) {
            Some(hit) => Arrival::Surface(Landing::straight(hit, ray, distance)),
            None => Arrival::at_limit(self.limit, Ray { origin: ray.at(left), ..*ray }),
        }
    }
}

/// The piece up to the horizon, and whether it gets there.
fn before_horizon<T: Real>(curve: &Curve<T, Orbit<'_, T>>, piece: Piece<T>, horizon: T) -> (Piece<T>, bool) {
    if curve.field.distance(curve.phase.position) > horizon {
        return (piece, false);
    }
    let share = piece.crossing(|point| horizon - curve.field.distance(point));
    (piece.up_to(share), true)
}

/// The direction that light ends in, where what the hole still bends it by is known well enough without more steps.
///
/// To first order in M, light with the impact parameter b that moves away at the distance r is still bent by
/// (M/b)(2 − √(1 − x)·(2 + x)) with x = b²/r²; the next order is smaller by about 5M/r. It is written here without a
/// difference of equal numbers.
fn leaving<T: Real>(curve: &Curve<T, Orbit<'_, T>>) -> Option<Vec3<T>> {
    let (field, phase) = (&curve.field, &curve.phase);
    let number = T::from_f32;
    let away = phase.position - field.hole.center;
    let outwards = away.dot(phase.momentum);
    if outwards <= T::ZERO {
        return None;
    }
    let r = away.length();
    let speed = phase.momentum.length();
    let mass = field.hole.mass / r;
    let b = field.angular_momentum / (r * speed);
    let x = (b * b).min(T::ONE);
    let rest = mass * x * b * (number(3.0) + x) / (T::TWO + (T::ONE - x).sqrt() * (T::TWO + x));
    let tolerance = match field.hole.steps {
        Steps::Controlled { tolerance } => tolerance,
        Steps::Fixed { .. } => number(FIXED_TOLERANCE),
    };
    if rest * (number(5.0) * mass).max(number(0.125)) > tolerance {
        return None;
    }
    let direction = phase.momentum * (T::ONE / speed);
    let sideways = (direction * away.dot(direction) - away).normalized();
    Some((direction + sideways * rest).normalized())
}

/// With which error, in radians, light leaves a hole around which it goes in steps of fixed length.
const FIXED_TOLERANCE: f32 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;

    /// The angular momentum h, and x′² − 2M·h²/r³, which is twice the energy: by how much they change at most along an orbit,
    /// as shares.
    fn changes(steps: Steps<f64>, b: f64) -> [f64; 2] {
        let hole = BlackHole { center: Vec3::new(0.3, -0.2, 0.1), mass: 1.0, steps };
        let position = hole.center + Vec3::new(-60.0, b, 0.0);
        let momentum = Vec3::new(1.0, 0.0, 0.0);
        let field = Orbit::new(&hole, position, momentum);
        let phase = Phase { position, momentum, acceleration: field.acceleration(position) };
        let mut curve = Curve { field, phase, pace: Pace::new::<{ u64::MAX }>(steps) };
        let kept = |phase: &Phase<f64>| {
            let away = phase.position - hole.center;
            let h = away.cross(phase.momentum).length();
            [h, phase.momentum.length_squared() - 2.0 * h * h / away.length().powi(3)]
        };
        let start = kept(&phase);
        let (mut most, mut left) = ([0.0_f64; 2], StepsLeft::new(10_000));
        while curve.field.distance(curve.phase.position) < 70.0 && curve.step::<{ u64::MAX }>(&mut left).is_some() {
            for ((most, now), before) in most.iter_mut().zip(kept(&curve.phase)).zip(start) {
                *most = most.max((now / before - 1.0).abs());
            }
        }
        assert!(!left.were_too_few);
        most
    }

    /// The method of Störmer and Verlet keeps the angular momentum to rounding; the condition that light's way has no length in
    /// space and time is kept to the method's order, and by controlled steps to the tolerance.
    #[test]
    fn angular_momentum_and_the_null_condition_are_kept() {
        for b in [5.3, 6.0, 10.0] {
            let [coarse, fine] = [0.04, 0.02].map(|length| changes(Steps::Fixed { length }, b));
            assert!(coarse[0] < 1e-13 && fine[0] < 1e-13, "{b}: {coarse:?} {fine:?}");
            assert!(fine[1] < 1e-3 && (3.0..5.0).contains(&(coarse[1] / fine[1])), "{b}: {coarse:?} {fine:?}");
            for tolerance in [1e-4, 1e-6] {
                let [angular, energy] = changes(Steps::Controlled { tolerance }, b);
                assert!(
                    angular < 20.0 * tolerance && energy < 20.0 * tolerance,
                    "{b} {tolerance}: {angular:e} {energy:e}"
                );
            }
        }
    }
}
