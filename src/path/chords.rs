//! The chords that a piece of a bent path is searched in.

use super::piece::Piece;
use crate::math::Real;

/// The most chords of a piece, about.
const MOST: f32 = 256.0;

/// The chords of a piece one after another, as shares of it.
///
/// An arc of the angle φ is off its chord by φ/8 of its length. Each chord is as long as it may be for that to be a tolerance
/// of the piece, and of the way from where the path starts: so what is near there is seen where it is.
#[derive(Clone, Copy)]
pub(super) struct Chords<T> {
    /// The length of the first chord of a path, as a share of the piece.
    unit: T,
    /// The way before the piece, as a share of the piece.
    before: T,
    /// The longest chord: √unit, and at most what bends by a quarter of a radian.
    longest: T,
    /// Where the next chord starts.
    next: T,
    /// Whether the tolerance calls for more chords than there may be.
    pub too_few: bool,
}

/// A part of a piece, from one share of it to another.
#[derive(Clone, Copy)]
pub(super) struct Part<T> {
    pub from: T,
    pub to: T,
}

impl<T: Real> Chords<T> {
    /// A single chord.
    pub(super) const fn one() -> Self {
        Self { unit: T::TWO, before: T::ZERO, longest: T::ONE, next: T::ZERO, too_few: false }
    }

    /// The chords of a piece that starts after such a way.
    pub(super) fn within(tolerance: T, piece: &Piece<T>, before: T) -> Self {
        let wish = T::from_f32(8.0) * tolerance / piece.bend.max(tolerance);
        let least = T::from_f32(4.0 / (MOST * MOST));
        let before = before / piece.reach().max(T::SMALLEST);
        let unit = wish.max(least);
        let longest = unit.sqrt().min(T::from_f32(0.25) / piece.bend.max(T::from_f32(0.25)));
        Self { unit, before, longest, next: T::ZERO, too_few: wish < least }
    }
}

impl<T: Real> Iterator for Chords<T> {
    type Item = Part<T>;

    fn next(&mut self) -> Option<Part<T>> {
        let from = self.next;
        if from >= T::ONE {
            return None;
        }
        // The width w has w² = unit·(before + from + w).
        let half = self.unit * T::HALF;
        let width = half + (half * half + self.unit * (self.before + from)).sqrt();
        self.next = (from + width.min(self.longest)).min(T::ONE);
        Some(Part { from, to: self.next })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(unit: f64, before: f64) -> usize {
        Chords { unit, before, longest: 1.0, next: 0.0, too_few: false }.count()
    }

    /// They go on from one to the next to the end, no more than there may be, and fewer the longer the way before.
    #[test]
    fn they_fill_the_piece() {
        let least = 4.0 / f64::from(MOST * MOST);
        for (unit, before) in [(least, 0.0), (1e-3, 0.0), (1e-3, 5.0), (0.3, 0.1)] {
            let mut end = 0.0;
            for Part { from, to } in (Chords { unit, before, longest: 1.0, next: 0.0, too_few: false }) {
                assert!(from == end && to > from);
                let width = to - from;
                assert!(to == 1.0 || (width * width / (unit * (before + to)) - 1.0).abs() < 1e-9);
                end = to;
            }
            assert_eq!(end, 1.0);
        }
        assert!(count(least, 0.0) <= MOST as usize + 1);
        assert!(count(1e-3, 5.0) < count(1e-3, 0.0) / 4);
        assert_eq!(Chords::<f64>::one().count(), 1);
    }
}
