//! `Fast` as the number type of a scene.

use super::{Fast, exponential, power, turns};
use crate::math::operators::{as_f32, operators_of_f32};
use crate::math::{Accumulate, Real, Vec3};

operators_of_f32!(Fast);

impl Real for Fast {
    as_f32!();

    #[inline]
    fn exp(self) -> Self {
        Self(exponential::exponential(self.0))
    }
    #[inline]
    fn powf(self, y: Self) -> Self {
        Self(power::power(self.0, y.0))
    }
    #[inline]
    fn sin_cos_turns(self) -> (Self, Self) {
        let (sine, cosine) = turns::sin_cos_turns(self.0);
        (Self(sine), Self(cosine))
    }
}
