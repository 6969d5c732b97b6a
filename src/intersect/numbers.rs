//! Numbers for tests that are the same in every run.

use crate::math::Vec3;
use crate::trace::Sequence;

/// The numbers of a round, each by its place.
pub(super) struct Numbers(pub(super) u32);

impl Numbers {
    /// A number from -1 to 1.
    pub(super) fn number(&self, place: u32) -> f32 {
        Sequence::new(self.0, place).point::<f32>(0, 0)[0] * 2.0 - 1.0
    }

    /// Three of them, of this place and the next two.
    pub(super) fn vector(&self, place: u32) -> Vec3<f32> {
        Vec3::new(self.number(place), self.number(place + 1), self.number(place + 2))
    }
}
