//! The objects around a bent path.

use core::slice;

use super::arrival::Landing;
use super::piece::Piece;
use crate::intersect::{Hit, Ray, Wanted, clearance, may_meet, search};
use crate::math::{Real, Vec3};
use crate::scene::Object;

/// The objects around a path, which are looked at as it goes on.
///
/// Where a path has been searched, the distance to the nearest object is remembered; as long as it has not gone so far, no
/// object is looked at. Then only those are that are near. So a path of many steps does not cost steps times objects.
pub(super) struct Around<'a, T> {
    objects: &'a [Object<'a, T>],
    wanted: Wanted,
    /// No object is nearer to where the path is than this.
    clear: T,
}

impl<'a, T: Real> Around<'a, T> {
    pub(super) fn new(objects: &'a [Object<'a, T>], wanted: Wanted) -> Self {
        Self { objects, wanted, clear: T::ZERO }
    }

    /// Whether the path is clear of objects for this long. If so, it goes there; if not, it has to be searched.
    fn goes(&mut self, way: T) -> bool {
        self.clear -= way * T::from_f32(1.001);
        self.clear > T::ZERO
    }

    /// Remembers how far from all objects the path has come out of a search.
    fn look<const EFFECTS: u64>(&mut self, point: Vec3<T>) {
        let nearest = |nearest: T, object| nearest.min(clearance::<T, EFFECTS>(object, point));
        self.clear = self.objects.iter().fold(T::MAX, nearest);
    }

    /// What a ray meets before `limit`, of a path that then goes on from `way` along it.
    pub(super) fn straight<const EFFECTS: u64>(&mut self, ray: &Ray<T>, way: T, limit: T) -> Option<Hit<'a, T>> {
        if self.goes(limit) {
            return None;
        }
        let found = search::<T, EFFECTS>(self.objects, ray, limit, self.wanted);
        if found.is_none() && limit < T::FARTHEST {
            self.look::<EFFECTS>(ray.at(way));
        }
        found
    }

    /// The first surface that a piece meets, taken as so many chords, `before` being the length of the path so far.
    pub(super) fn curved<const EFFECTS: u64>(
        &mut self,
        piece: &Piece<T>,
        chords: u32,
        before: T,
    ) -> Option<Landing<'a, T>> {
        if self.goes(piece.reach()) {
            return None;
        }
        let bounds = piece.bounds();
        let mut best: Option<Found<'a, T>> = None;
        for object in self.objects.iter().filter(|object| may_meet::<T, EFFECTS>(object, &bounds)) {
            let found = self.on_chords::<EFFECTS>(object, piece, chords, best.as_ref());
            best = found.or(best);
        }
        let Some(Found { hit, chord, number, length }) = best else {
            self.look::<EFFECTS>(piece.at(T::ONE));
            return None;
        };
        let share = (T::from_u32(number) + (hit.contact.t / length).min(T::ONE)) / T::from_u32(chords);
        let direction = piece.tangent(share).normalized_or(chord.direction);
        Some(Landing { hit, chord, direction, distance: before + piece.length(share) })
    }

    /// The first contact of the chords of a piece with an object, if it comes before the best one so far.
    fn on_chords<const EFFECTS: u64>(
        &self,
        object: &'a Object<'a, T>,
        piece: &Piece<T>,
        chords: u32,
        best: Option<&Found<'a, T>>,
    ) -> Option<Found<'a, T>> {
        let last = best.map_or(chords.saturating_sub(1), |best| best.number);
        (0..=last).find_map(|number| {
            let (chord, length) = piece.chord(number, chords);
            // A little more than the chord, so that no surface is between it and the next.
            let slack = chord.origin.largest() * (T::from_f32(8.0) * T::ROUNDOFF);
            let limit = match best {
                Some(best) if number == last => best.hit.contact.t * (T::ONE - T::from_f32(32.0) * T::ROUNDOFF),
                _ => length + slack,
            };
            let hit = search::<T, EFFECTS>(slice::from_ref(object), &chord, limit, self.wanted)?;
            Some(Found { hit, chord, number, length })
        })
    }
}

/// A contact with a chord.
struct Found<'a, T> {
    hit: Hit<'a, T>,
    chord: Ray<T>,
    /// Which of the chords, and how long it is.
    number: u32,
    length: T,
}
