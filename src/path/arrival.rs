//! Where a bent path ends.

use crate::intersect::{Hit, Ray};
use crate::math::{Real, Vec3};

/// Where a bent path ends.
pub(crate) enum Arrival<'a, T> {
    /// At a surface.
    Surface(Landing<'a, T>),
    /// Nowhere: it goes on for ever in this direction.
    Away(Vec3<T>),
    /// As far as it was asked to go: there it is, and so it goes on.
    Limit(Ray<T>),
    /// Behind the horizon of a black hole.
    Captured,
    /// It took all of its steps; so far it goes in this direction.
    OutOfSteps(Vec3<T>),
}

/// Where a bent path meets a surface.
pub(crate) struct Landing<'a, T> {
    pub hit: Hit<'a, T>,
    /// The chord of the path that meets it; the contact is on this ray.
    pub chord: Ray<T>,
    /// Where the path itself goes there.
    pub direction: Vec3<T>,
    /// The length of the path.
    pub distance: T,
}

/// The steps that a path may take, counted down.
pub(crate) struct StepsLeft {
    left: u16,
    most: u16,
    /// Whether a path ended because it could take no more.
    pub were_too_few: bool,
}

impl StepsLeft {
    /// So many.
    pub(crate) fn new(most: u16) -> Self {
        Self { left: most, most, were_too_few: false }
    }

    /// How many were taken.
    pub(crate) fn taken(&self) -> u32 {
        u32::from(self.most.saturating_sub(self.left))
    }

    /// Takes a step, if there is one.
    pub(super) fn take(&mut self) -> bool {
        self.were_too_few |= self.left == 0;
        self.left = self.left.saturating_sub(1);
        !self.were_too_few
    }

    /// No step would lead on.
    pub(super) fn give_up(&mut self) {
        self.were_too_few = true;
    }
}

impl<'a, T: Real> Arrival<'a, T> {
    /// As far as a limit of the whole path lets it go, which may be infinitely far: there it is, and so it goes on.
    pub(super) fn at_limit(limit: T, there: Ray<T>) -> Self {
        if limit < T::FARTHEST { Self::Limit(there) } else { Self::Away(there.direction) }
    }
}

impl<'a, T: Real> Landing<'a, T> {
    /// At the end of a straight way.
    pub(super) fn straight(hit: Hit<'a, T>, ray: &Ray<T>, before: T) -> Self {
        let distance = before + hit.contact.t;
        Self { hit, chord: *ray, direction: ray.direction, distance }
    }
}
