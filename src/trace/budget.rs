//! How much work a pixel may cost, and what stands for the work that is not done.

use crate::math::{Real, Rgb};

/// The limits of a ray tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget<T> {
    /// The number of bounces, at most the tracer's `DEPTH` and [`MOST_BOUNCES`]; 0 is eye rays alone.
    pub depth: u8,
    /// A branch is cut when the largest channel of its throughput is below this; 0 cuts nothing.
    pub cutoff: T,
    /// The number of rays, shadow rays included, that a pixel may take, shared evenly by its samples. A branch starts
    /// only if the rest pays for it and for a shadow ray to each light. Each surface that a ray goes straight through
    /// counts as one more; a shadow ray that cannot pay for one ends there, in the dark.
    pub rays_per_pixel: u32,
    /// The number of steps that a bent ray may take to its next surface; straight rays take none.
    pub steps_per_ray: u16,
    /// What a branch that is cut contributes.
    pub termination: Termination<T>,
}

/// The largest number of bounces: the next one is counted in a byte as well.
pub const MOST_BOUNCES: u8 = 254;

/// The steps of a bent ray, unless a budget says otherwise.
pub(crate) const USUAL_STEPS: u16 = 10_000;

/// How many surfaces in a row a ray may go straight through: branches inside a medium of higher priority, and shadow rays
/// in tinted media. It takes no depth, and this bounds it.
pub const MOST_PASSED: u8 = 255;

/// What stands for the light of a branch that is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Termination<T> {
    /// The background in the direction of the branch.
    Background,
    /// Nothing: the light is lost.
    Black,
    /// This colour.
    Color(Rgb<T>),
}

impl<T: Real> Budget<T> {
    /// A number of bounces, 10,000 steps for a bent ray and no other limit; what is cut takes the background.
    #[must_use]
    pub const fn with_depth(depth: u8) -> Self {
        Self {
            depth,
            cutoff: T::ZERO,
            rays_per_pixel: u32::MAX,
            steps_per_ray: USUAL_STEPS,
            termination: Termination::Background,
        }
    }
}
