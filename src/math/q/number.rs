//! `Q` as the number type of a scene.

use fixed::types::extra::LeEqU32;

use super::{Q, raw};
use crate::math::fixed_point::LARGEST;
use crate::math::{Range, Real};

impl<Frac: LeEqU32 + 'static> Real for Q<Frac> {
    const IS_FIXED: bool = true;
    const RANGE: Option<Range> = Some(Range::of_fraction(Self::F));
    const ZERO: Self = Self::from_bits(0);
    const HALF: Self = Self::from_bits(1 << (Self::F - 1));
    const ONE: Self = Self::from_bits(1 << Self::F);
    const TWO: Self = Self::from_bits(2 << Self::F);
    const DISPLAY_STEP: Self = Self::new(1.0 / 255.0);
    const MAX: Self = Self::from_bits(LARGEST);
    const FARTHEST: Self = Self::from_bits(LARGEST);
    const OUTERMOST: Self = Self::from_bits(1 << 29);
    const SMALLEST: Self = Self::from_bits(1);
    const ROUNDOFF: Self = Self::from_bits(1);

    #[inline(always)]
    fn from_f32(x: f32) -> Self {
        Self::new(x)
    }
    #[inline(always)]
    fn to_f32(self) -> f32 {
        raw::to_f32(self.to_bits(), Self::F)
    }
    #[inline(always)]
    fn from_u32(x: u32) -> Self {
        const MOST: u32 = LARGEST as u32;
        Self::from_bits(if x > MOST >> Self::F { LARGEST } else { (x << Self::F) as i32 })
    }
    #[inline(always)]
    fn fraction(bits: u32) -> Self {
        Self::from_bits((bits >> (32 - Self::F)) as i32)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::from_bits(raw::sqrt(self.to_bits(), Self::F))
    }
    #[inline(always)]
    fn exp(self) -> Self {
        Self::from_bits(raw::exponential(self.to_bits(), Self::F))
    }
    #[inline(always)]
    fn powf(self, y: Self) -> Self {
        Self::from_bits(raw::power(self.to_bits(), y.to_bits(), Self::F))
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Self::from_bits(raw::floor(self.to_bits(), Self::F))
    }
    /// A product of fixed-point numbers is summed before it is rounded; nothing asks for what is lost.
    #[inline(always)]
    fn product_error(self, _: Self, _: Self) -> Self {
        Self::ZERO
    }
    /// Half a unit of the last place each, and as much again for each 1 that the number has.
    #[inline(always)]
    fn roundings(self, count: f32) -> Self {
        let halves = count as i32;
        Self::from_bits(((self.to_bits().abs() >> Self::F) * halves + 2 * halves) / 2)
    }
    #[inline(always)]
    fn lowered(self, count: f32) -> Self {
        self - Self::from_bits(count as i32 / 2)
    }
    #[inline(always)]
    fn raised(self, count: f32) -> Self {
        self.plus(Self::from_bits(count as i32 / 2 + 1))
    }
    #[inline(always)]
    fn spacing(self) -> Self {
        Self::from_bits(2)
    }
    #[inline(always)]
    fn quotients(a: Self, b: Self, divisor: Self) -> (Self, Self) {
        (a / divisor, b / divisor)
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().saturating_add(other.to_bits()).clamp(-LARGEST, LARGEST))
    }
}
