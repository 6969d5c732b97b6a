//! A curve that light goes along, step by step.

use super::arrival::StepsLeft;
use super::chords::Chords;
use super::field::Field;
use super::integrate::{next_step, nystrom, verlet};
use super::piece::{Phase, Piece};
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Steps};

/// A curve that light goes along.
pub(super) struct Curve<T, F> {
    pub field: F,
    pub phase: Phase<T>,
    pub pace: Pace<T>,
}

/// How long the steps are.
pub(super) enum Pace<T> {
    Fixed {
        length: T,
    },
    /// `next` is the step that is tried next; `None` at first.
    Controlled {
        tolerance: T,
        next: Option<T>,
    },
}

impl<T: Real> Pace<T> {
    /// The pace of a method, for a tracer of such effects.
    pub(super) fn new<const EFFECTS: u64>(steps: Steps<T>) -> Self {
        let controlled = Effects::from_bits(EFFECTS).has(Effects::CONTROLLED_STEPS);
        match steps {
            Steps::Controlled { tolerance } if controlled => Self::Controlled { tolerance, next: None },
            Steps::Fixed { length } => Self::Fixed { length },
            // Not in a scene that the tracer was compiled for.
            Steps::Controlled { .. } => Self::Fixed { length: T::ONE },
        }
    }

    /// The chords of a piece after such a way: one for a step of fixed length, as many as the tolerance calls for else.
    pub(super) fn chords(&self, piece: &Piece<T>, before: T) -> Chords<T> {
        match *self {
            Self::Fixed { .. } => Chords::one(),
            Self::Controlled { tolerance, .. } => Chords::within(tolerance, piece, before),
        }
    }
}

impl<T: Real, F: Field<T>> Curve<T, F> {
    /// Where it goes now.
    pub(super) fn direction(&self) -> Vec3<T> {
        self.phase.momentum.normalized()
    }

    /// Goes one step on; `None` when there are no steps left, or when a step of fixed length is so long for its field that it
    /// leaves the range of numbers. A step that is tried and found too long counts as well.
    pub(super) fn step<const EFFECTS: u64>(&mut self, steps: &mut StepsLeft) -> Option<Piece<T>> {
        let effects = const { Effects::from_bits(EFFECTS) };
        match &mut self.pace {
            Pace::Fixed { length } if effects.has(Effects::FIXED_STEPS) => {
                let tau = *length * self.field.unit(self.phase.position) / self.phase.momentum.length();
                let next = steps.take().then(|| verlet(&self.field, &self.phase, tau))?;
                self.go_to(next, tau, steps)
            }
            Pace::Controlled { tolerance, next } if effects.has(Effects::CONTROLLED_STEPS) => {
                let longest = self.field.longest(&self.phase);
                let mut tau = next.unwrap_or(longest * T::from_f32(0.25)).min(longest);
                let tolerance = *tolerance;
                while steps.take() {
                    let (there, error) = nystrom(&self.field, &self.phase, tau);
                    let advised = next_step(tau, error, tolerance);
                    if error <= tolerance {
                        *next = Some(advised);
                        return self.go_to(there, tau, steps);
                    }
                    tau = advised;
                }
                None
            }
            _ => None,
        }
    }

    fn go_to(&mut self, there: Phase<T>, tau: T, steps: &mut StepsLeft) -> Option<Piece<T>> {
        let piece = Piece::new(&self.phase, &there, tau);
        let square = there.momentum.length_squared();
        let is_sound = piece.is_near() && square >= T::SMALLEST && square <= T::MAX;
        if !is_sound {
            steps.give_up();
            return None;
        }
        self.phase = there;
        Some(piece)
    }
}
