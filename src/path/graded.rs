//! The way through a medium whose index of refraction varies between two levels, and not outside of them.

use super::around::Around;
use super::arrival::{Arrival, Landing, StepsLeft};
use super::curve::{Curve, Pace};
use super::field::{Field, Graded};
use super::layers::Layered;
use super::level;
use super::piece::{Phase, Piece};
use crate::intersect::Ray;
use crate::math::{Real, Vec3};
use crate::scene::{Effects, Method, Profile};

/// Where a point is: between the levels where the index varies, or on one side of them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Zone {
    Below,
    Between,
    Above,
}

/// A path on its way.
pub(super) struct Journey<'p, 'a, T> {
    pub profile: &'p Profile<'a, T>,
    pub around: Around<'a, T>,
    pub distance: T,
    /// How far it may go.
    pub limit: T,
}

/// How a leg of a path ended.
pub(super) enum Leg<'a, T> {
    End(Arrival<'a, T>),
    /// At a border, in another zone.
    Border(Ray<T>, Zone),
}

impl<'a, T: Real> Journey<'_, 'a, T> {
    /// Follows the path to its end.
    pub(super) fn follow<const EFFECTS: u64>(mut self, mut ray: Ray<T>, steps: &mut StepsLeft) -> Arrival<'a, T> {
        let mut zone = self.zone::<EFFECTS>(ray.origin);
        let mut before = zone;
        loop {
            let leg = match zone {
                Zone::Between => self.bend::<EFFECTS>(&ray, before, steps),
                Zone::Below | Zone::Above => self.straight::<EFFECTS>(&ray, zone, steps),
            };
            match leg {
                Leg::End(arrival) => return arrival,
                Leg::Border(next, there) => (ray, before, zone) = (next, zone, there),
            }
        }
    }

    fn zone<const EFFECTS: u64>(&self, point: Vec3<T>) -> Zone {
        let height = self.profile.level.of::<EFFECTS>(point);
        if height < self.profile.from {
            Zone::Below
        } else if height > self.profile.to {
            Zone::Above
        } else {
            Zone::Between
        }
    }

    /// Straight on, to the levels where the index varies.
    fn straight<const EFFECTS: u64>(&mut self, ray: &Ray<T>, zone: Zone, steps: &mut StepsLeft) -> Leg<'a, T> {
        if !steps.take() {
            return Leg::End(Arrival::OutOfSteps(ray.direction));
        }
        let profile = self.profile;
        let border = match zone {
            Zone::Below => level::up_to::<T, EFFECTS>(&profile.level, profile.from, ray),
            _ => level::down_to::<T, EFFECTS>(&profile.level, profile.to, ray),
        };
        match self.stretch::<EFFECTS>(ray, border) {
            Ok(there) => Leg::Border(there, Zone::Between),
            Err(arrival) => Leg::End(arrival),
        }
    }

    /// Straight on to a border, if there is one on the way and nothing before it.
    pub(super) fn stretch<const EFFECTS: u64>(
        &mut self,
        ray: &Ray<T>,
        border: Option<T>,
    ) -> Result<Ray<T>, Arrival<'a, T>> {
        let left = self.limit - self.distance;
        let way = border.unwrap_or(T::FARTHEST);
        // A little past the border, so that no surface is between this part and the next.
        let (_, up) = level::with_gradient::<T, EFFECTS>(&self.profile.level, ray.origin);
        let speed = ray.direction.dot(up).abs().max(T::from_f32(1.0 / 1024.0));
        let slack = (way + ray.origin.largest() / speed) * (T::from_f32(8.0) * T::ROUNDOFF);
        if let Some(hit) = self.around.straight::<EFFECTS>(ray, way.min(left), (way + slack).min(left)) {
            return Err(Arrival::Surface(Landing::straight(hit, ray, self.distance)));
        }
        self.distance += way;
        if way >= left {
            return Err(Arrival::at_limit(self.limit, Ray { origin: ray.at(left), ..*ray }));
        }
        Ok(Ray { origin: ray.at(way), ..*ray })
    }

    /// On through the levels where the index varies, from the zone `before`.
    fn bend<const EFFECTS: u64>(&mut self, ray: &Ray<T>, before: Zone, steps: &mut StepsLeft) -> Leg<'a, T> {
        let effects = const { Effects::from_bits(EFFECTS) };
        let profile = self.profile;
        match profile.method {
            Method::Layers { thickness } if effects.has(Effects::LAYERS) => {
                Layered::new::<EFFECTS>(profile, thickness, ray, before).follow::<EFFECTS>(self, steps)
            }
            Method::Steps(way) if effects.has(Effects::FIXED_STEPS.with(Effects::CONTROLLED_STEPS)) => {
                let field = Graded::<T, EFFECTS>(profile);
                let phase = Phase {
                    position: ray.origin,
                    momentum: ray.direction * profile.index_at::<EFFECTS>(ray.origin),
                    acceleration: field.acceleration(ray.origin),
                };
                self.curve::<EFFECTS>(Curve { field, phase, pace: Pace::new::<EFFECTS>(way) }, steps)
            }
            _ => Leg::End(Arrival::Away(ray.direction)),
        }
    }

    /// Where a piece leaves the levels where the index varies, and to which side.
    fn border<const EFFECTS: u64>(&self, piece: &Piece<T>) -> Option<(T, Zone)> {
        let &Profile { level, from, to, .. } = self.profile;
        let end = level.of::<EFFECTS>(piece.at(T::ONE));
        if end > to {
            Some((piece.crossing(|point| level.of::<EFFECTS>(point) - to), Zone::Above))
        } else if end < from {
            Some((piece.crossing(|point| from - level.of::<EFFECTS>(point)), Zone::Below))
        } else {
            None
        }
    }

    /// On along a curve.
    fn curve<const EFFECTS: u64>(
        &mut self,
        mut curve: Curve<T, Graded<'_, 'a, T, EFFECTS>>,
        steps: &mut StepsLeft,
    ) -> Leg<'a, T> {
        loop {
            let Some(mut piece) = curve.step::<EFFECTS>(steps) else {
                return Leg::End(Arrival::OutOfSteps(curve.direction()));
            };
            let border = self.border::<EFFECTS>(&piece);
            let mut direction = curve.direction();
            if let Some((share, _)) = border {
                direction = piece.direction(share);
                piece = piece.up_to(share);
            }
            let chords = curve.pace.chords(&piece, self.distance);
            if let Some(landing) = self.around.curved::<EFFECTS>(&piece, chords, self.distance) {
                return Leg::End(Arrival::Surface(landing));
            }
            let (way, left) = (piece.length(T::ONE), self.limit - self.distance);
            self.distance += way;
            if way >= left {
                return Leg::End(Arrival::at_limit(self.limit, piece.ray(left / way)));
            }
            if let Some((_, zone)) = border {
                return Leg::Border(Ray { origin: piece.at(T::ONE), direction }, zone);
            }
        }
    }
}
