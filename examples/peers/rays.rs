//! How many rays there are.

use whit::trace::{Observer, RayKind};

/// A count of all rays, which costs nothing where it is not wanted.
pub struct Rays<const IS_COUNTED: bool>(u32);

impl<const IS_COUNTED: bool> Rays<IS_COUNTED> {
    /// None so far.
    pub const NONE: Self = Self(0);

    /// Rays, shadow rays included.
    pub fn count(&self) -> u32 {
        self.0
    }
}

impl<const IS_COUNTED: bool> Observer for Rays<IS_COUNTED> {
    #[inline]
    fn ray(&mut self, _: RayKind) {
        if IS_COUNTED {
            self.0 += 1;
        }
    }
}
