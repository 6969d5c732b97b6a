//! `f32` with the functions of the crate `micromath`.

use micromath::F32;

use super::operators::{as_f32, operators_of_f32};
use super::{Accumulate, Real, Vec3};

/// An `f32` with the functions of the crate `micromath`, as they are: to see what they cost in accuracy.
///
/// The exponential, the power, sine and cosine are its; they weigh light and move no ray that goes straight. The square root
/// is that of `f32`: `micromath`'s is off by up to 6 %, which would put a ray's end so far beside the surface it meets.
/// [`Fast`](super::Fast) is nearer to the true values, and quicker where there is no FPU: docs/accuracy.md compares them.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Micromath(pub f32);

operators_of_f32!(Micromath);

impl Real for Micromath {
    as_f32!();

    #[inline]
    fn exp(self) -> Self {
        Self(F32(self.0).exp().0)
    }
    #[inline]
    fn powf(self, y: Self) -> Self {
        // Its power of 0 is no number.
        Self(if self.0 > 0.0 { F32(self.0).powf(F32(y.0)).0 } else { 0.0 })
    }
    #[inline]
    fn sin_cos_turns(self) -> (Self, Self) {
        // Its sine takes angles of some turns; what is whole of them is taken off exactly.
        let angle = F32((self.0 - Real::floor(self.0)) * core::f32::consts::TAU);
        let (sine, cosine) = angle.sin_cos();
        (Self(sine.0), Self(cosine.0))
    }
}
