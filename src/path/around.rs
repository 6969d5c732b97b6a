//! The objects around a bent path.

use core::{mem, slice};

use super::arrival::Landing;
use super::chords::{Chords, Part};
use super::piece::Piece;
use crate::intersect::{Hit, Ray, Wanted, clearance, may_meet, search};
use crate::math::{Real, Vec3};
use crate::scene::Object;

/// The objects around a path, which are looked at as it goes on.
///
/// Where a path has been searched, the objects that are nearest are remembered, and the distance to the nearest of the others.
/// As long as it has not gone so far, only the few are looked at. So a path of many steps does not cost steps times objects.
pub(super) struct Around<'a, T> {
    objects: &'a [Object<'a, T>],
    wanted: Wanted,
    near: Near,
    /// No other object is nearer to where the path is than this.
    clear: T,
}

/// The numbers of some objects in ascending order, and then `FREE` ones.
type Near = [u16; 4];

/// No object has this number.
const FREE: u16 = u16::MAX;

impl<'a, T: Real> Around<'a, T> {
    pub(super) fn new(objects: &'a [Object<'a, T>], wanted: Wanted) -> Self {
        Self { objects, wanted, near: [FREE; 4], clear: T::ZERO }
    }

    /// Whether the path is clear of the other objects for this long. If so, it goes there; if not, all have to be searched.
    fn goes(&mut self, way: T) -> bool {
        self.clear -= way * T::from_f32(1.001);
        self.clear > T::ZERO
    }

    /// Remembers what is near where the path has come to, and how far it is from all else.
    fn look<const EFFECTS: u64>(&mut self, point: Vec3<T>) {
        let mut nearest = self.near.map(|_| (T::MAX, FREE));
        self.clear = T::MAX;
        for (number, object) in (0..FREE).zip(self.objects) {
            let (farther, _) = insert(&mut nearest, (clearance::<T, EFFECTS>(object, point), number));
            self.clear = self.clear.min(farther);
        }
        // Of surfaces that are equally near, the first in the list counts.
        self.near = [FREE; 4];
        for (_, number) in nearest {
            insert(&mut self.near, number);
        }
    }

    /// What a ray meets before `limit`, of a path that then goes on from `way` along it.
    pub(super) fn straight<const EFFECTS: u64>(&mut self, ray: &Ray<T>, way: T, limit: T) -> Option<Hit<'a, T>> {
        if self.goes(limit) {
            return self.of_the_near::<EFFECTS>(ray, limit);
        }
        let found = search::<T, EFFECTS>(self.objects, ray, limit, self.wanted);
        if found.is_none() && limit < T::FARTHEST {
            self.look::<EFFECTS>(ray.at(way));
        }
        found
    }

    /// What a ray meets of the objects that are near.
    fn of_the_near<const EFFECTS: u64>(&self, ray: &Ray<T>, limit: T) -> Option<Hit<'a, T>> {
        let mut best = None;
        let mut limit = limit;
        for object in self.near.iter().filter_map(|number| self.objects.get(usize::from(*number))) {
            if let Some(hit) = search::<T, EFFECTS>(slice::from_ref(object), ray, limit, self.wanted) {
                limit = just_before(hit.contact.t);
                best = Some(hit);
            }
        }
        best
    }

    /// The first surface that a piece meets, taken in chords, `before` being the length of the path so far.
    pub(super) fn curved<const EFFECTS: u64>(
        &mut self,
        piece: &Piece<T>,
        chords: Chords<T>,
        before: T,
    ) -> Option<Landing<'a, T>> {
        let all = !self.goes(piece.reach());
        let bounds = piece.bounds();
        let wanted = self.wanted;
        let mut best: Option<Found<'a, T>> = None;
        let mut meet = |object: &'a Object<'a, T>| {
            if may_meet::<T, EFFECTS>(object, &bounds) {
                best = on_chords::<T, EFFECTS>(object, piece, chords, wanted, best.as_ref()).or(best.take());
            }
        };
        if all {
            self.objects.iter().for_each(&mut meet);
        } else {
            self.near.iter().filter_map(|number| self.objects.get(usize::from(*number))).for_each(&mut meet);
        }
        let Some(mut found) = best else {
            if all {
                self.look::<EFFECTS>(piece.at(T::ONE));
            }
            return None;
        };
        if chords.too_few {
            found = found.closer::<EFFECTS>(piece, wanted);
        }
        let share = found.share();
        let Found { hit, chord, .. } = found;
        let direction = piece.direction(share);
        Some(Landing { hit, chord, direction, distance: before + piece.length(share) })
    }
}

/// Puts an item into a sorted list; gives the one that has no more room.
fn insert<X: PartialOrd, const COUNT: usize>(sorted: &mut [X; COUNT], mut item: X) -> X {
    for place in sorted {
        if item < *place {
            mem::swap(&mut item, place);
        }
    }
    item
}

/// The limit that keeps out what is nearer by rounding alone.
fn just_before<T: Real>(t: T) -> T {
    t * (T::ONE - T::from_f32(32.0) * T::ROUNDOFF)
}

/// The first contact of the chords of a piece with an object, if it comes before the best one so far.
fn on_chords<'a, T: Real, const EFFECTS: u64>(
    object: &'a Object<'a, T>,
    piece: &Piece<T>,
    chords: Chords<T>,
    wanted: Wanted,
    best: Option<&Found<'a, T>>,
) -> Option<Found<'a, T>> {
    let last = best.map_or(T::ONE, |best| best.part.from);
    chords.take_while(|part| part.from <= last).find_map(|part| {
        let (chord, length) = piece.chord(part)?;
        // A little more than the chord, so that no surface is between it and the next.
        let slack = (chord.origin.largest() + length) * (T::from_f32(8.0) * T::ROUNDOFF);
        let limit = match best {
            Some(best) if part.from == last => just_before(best.hit.contact.t),
            _ => length + slack,
        };
        let hit = search::<T, EFFECTS>(slice::from_ref(object), &chord, limit, wanted)?;
        Some(Found { hit, chord, part, length })
    })
}

/// A contact with a chord.
struct Found<'a, T> {
    hit: Hit<'a, T>,
    chord: Ray<T>,
    /// The part of the piece that the chord belongs to, and the length of the chord.
    part: Part<T>,
    length: T,
}

impl<'a, T: Real> Found<'a, T> {
    /// Where on the piece the contact is.
    fn share(&self) -> T {
        let Part { from, to } = self.part;
        from + (to - from) * (self.hit.contact.t / self.length).min(T::ONE)
    }

    /// The same contact with ever shorter chords around it, for a piece that bends too much for the most chords there are.
    fn closer<const EFFECTS: u64>(mut self, piece: &Piece<T>, wanted: Wanted) -> Self {
        for _ in 0..2 {
            let (share, half) = (self.share(), (self.part.to - self.part.from) * T::from_f32(0.125));
            let part = Part { from: (share - half).max(T::ZERO), to: (share + half).min(T::ONE) };
            let Some((chord, length)) = piece.chord(part) else { break };
            let found = search::<T, EFFECTS>(slice::from_ref(self.hit.object), &chord, length, wanted);
            match found {
                Some(hit) if hit.contact.front() == self.hit.contact.front() => {
                    self = Self { hit, chord, part, length };
                }
                _ => break,
            }
        }
        self
    }
}
