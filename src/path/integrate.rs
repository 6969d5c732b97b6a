//! One step along a bent path.

use super::field::Field;
use super::piece::Phase;
use crate::math::{Real, Vec3};

/// A step of the method of Störmer and Verlet: half of the change of momentum, the way, the other half.
pub(super) fn verlet<T: Real>(field: &impl Field<T>, phase: &Phase<T>, tau: T) -> Phase<T> {
    let half = phase.momentum + phase.acceleration * (tau * T::HALF);
    let position = phase.position + half * tau;
    let acceleration = field.acceleration(position);
    Phase { position, momentum: half + acceleration * (tau * T::HALF), acceleration }
}

/// A step of the Runge-Kutta-Nyström method RKN4(3)4FM of Dormand, El-Mikkawy and Prince ("Families of Runge-Kutta-Nyström
/// formulae", 1987), and its error: of the way, as a share of it, or of the direction, in radians, whichever is larger.
///
/// It takes three new accelerations; the last one is the first of the next step. The error is that of the embedded method of
/// third order.
pub(super) fn nystrom<T: Real>(field: &impl Field<T>, phase: &Phase<T>, tau: T) -> (Phase<T>, T) {
    let &Phase { position, momentum, acceleration: first } = phase;
    let number = T::from_f32;
    let square = tau * tau;
    let place = |share: T, bend: Vec3<T>| position + (momentum * (tau * share) + bend * square);
    let second = field.acceleration(place(number(0.25), first * number(1.0 / 32.0)));
    let third = field.acceleration(place(number(0.7), first * number(0.007) + second * number(0.238)));
    let bend = first * number(1.0 / 14.0) + second * number(8.0 / 27.0) + third * number(25.0 / 189.0);
    let position = place(T::ONE, bend);
    let last = field.acceleration(position);
    let sum = |[a, b, c, d]: [f32; 4]| first * number(a) + second * number(b) + third * number(c) + last * number(d);
    let turn = sum([1.0 / 14.0, 32.0 / 81.0, 250.0 / 567.0, 5.0 / 54.0]) * tau;
    // What the two methods differ by, 1/14 + 7/150 and so on; that of the way over τ, which has no unit.
    let off_way = sum([0.118_095_24, -0.150_370_37, -0.017_724_868, 0.05]) * tau;
    let off_turn = sum([-0.547_619_05, 1.135_802_5, -1.014_109_3, 0.425_925_93]) * tau;
    let size = momentum.length();
    let error = off_way.length().max(off_turn.length()) / size;
    (Phase { position, momentum: momentum + turn, acceleration: last }, error)
}

/// The next step after one of such an error: the largest that keeps to the tolerance, with a margin, and not very different.
pub(super) fn next_step<T: Real>(tau: T, error: T, tolerance: T) -> T {
    let most = T::from_f32(4.0);
    // The error of the direction grows with the fourth power of the step, that of the way, as a share of it, with the third.
    let factor = if error > T::ZERO { (tolerance / error).sqrt().sqrt() * T::from_f32(0.9) } else { most };
    tau * factor.max(T::from_f32(0.125)).min(most)
}
