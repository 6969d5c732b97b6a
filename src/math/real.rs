//! The scalar that everything is computed in.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use super::accumulate::{Accumulate, accumulate_in_place};
use super::lanes::{self, LANES, Lanes};
use super::power::power;
use super::{HAS_FPU, Range, Vec3, exact_product, integer_floor, square_root, trigonometry};

/// A scalar number type.
///
/// `f32` is the default. It uses `libm` and the correctly rounded square root, so nothing is left to the
/// instruction set. `f64` runs the same code with more digits, to show what `f32` costs in accuracy.
pub trait Real:
    Accumulate
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + 'static
{
    /// Whether all numbers are equally far apart, as in fixed point.
    const IS_FIXED: bool = false;
    /// Whether a division takes no longer than a few branches.
    #[doc(hidden)]
    const DIVIDES_FAST: bool = false;
    /// How large the numbers of a scene may be, where that is less than all scenes may have.
    const RANGE: Option<Range> = None;
    /// 0
    const ZERO: Self;
    /// 1/2
    const HALF: Self;
    /// 1
    const ONE: Self;
    /// 2
    const TWO: Self;
    /// 1/255, the step of a display of 8 bits.
    const DISPLAY_STEP: Self;
    /// The largest finite value.
    const MAX: Self;
    /// The farthest that light is followed, 2⁶⁰ in floating point: beyond any scene, and squares of it do not overflow.
    const FARTHEST: Self;
    /// The largest coordinate of a point that light meets.
    const OUTERMOST: Self = Self::MAX;
    /// The smallest positive number with all digits.
    const SMALLEST: Self;
    /// The unit roundoff u: the largest relative error of one correctly rounded operation (2⁻²⁴ for `f32`).
    const ROUNDOFF: Self;

    /// The nearest value to `x`.
    fn from_f32(x: f32) -> Self;
    /// The nearest `f32`.
    fn to_f32(self) -> f32;
    /// The nearest value to `x`.
    fn from_u32(x: u32) -> Self;
    /// √x, correctly rounded for the floating-point types; `x ≥ 0`.
    fn sqrt(self) -> Self;
    /// eˣ
    fn exp(self) -> Self;
    /// xʸ for 0 < `x` ≤ 1 and `y` ≥ 0.
    fn powf(self, y: Self) -> Self;
    /// The largest integer that is not above x.
    fn floor(self) -> Self;

    /// Sine and cosine of 2π·self, as `(sin, cos)`: see [`sin_cos_turns`](super::sin_cos_turns).
    #[inline]
    fn sin_cos_turns(self) -> (Self, Self) {
        trigonometry::by_polynomials(self)
    }

    /// So many roundings of numbers that are as large as this one, and of factors of about 1 with which it is multiplied;
    /// `self ≥ 0`.
    #[inline(always)]
    fn roundings(self, count: f32) -> Self {
        self * (Self::from_f32(count) * Self::ROUNDOFF)
    }

    /// What is left of this number when so many roundings of it are taken off; `self ≥ 0`.
    #[inline(always)]
    fn lowered(self, count: f32) -> Self {
        self * (Self::ONE - Self::from_f32(count) * Self::ROUNDOFF)
    }

    /// This number with so many roundings of it added; `self ≥ 0`.
    #[inline(always)]
    fn raised(self, count: f32) -> Self {
        self * (Self::ONE + Self::from_f32(count) * Self::ROUNDOFF)
    }

    /// What rounding takes from a sum as large as this number, twice over; `self ≥ 0`.
    #[inline(always)]
    fn spacing(self) -> Self {
        self * (Self::ROUNDOFF + Self::ROUNDOFF)
    }

    /// a/divisor and b/divisor, for a divisor that is not 0.
    #[inline(always)]
    fn quotients(a: Self, b: Self, divisor: Self) -> (Self, Self) {
        let inverse = Self::ONE / divisor;
        (a * inverse, b * inverse)
    }

    /// The sum, or the largest number where it is beyond.
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }

    /// So many 2³²ths, of which 24 bits count.
    #[inline(always)]
    fn fraction(bits: u32) -> Self {
        Self::from_u32(bits >> 8) * Self::from_f32(1.0 / 16_777_216.0)
    }

    /// Whether a number without fraction is even.
    #[inline]
    fn is_even(self) -> bool {
        let half = self * Self::HALF;
        half == half.floor()
    }

    /// What rounding took from a product: self·other − product, exactly, for `product` = self·other as it is computed.
    fn product_error(self, other: Self, product: Self) -> Self;

    /// Eight numbers to be computed with side by side, in a type of which they are: of `f32` where the target has vector
    /// registers.
    #[doc(hidden)]
    #[inline(always)]
    fn lanes(_: &[Self; LANES]) -> Option<Lanes> {
        None
    }

    /// |x|
    #[inline]
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    /// The smaller of the two; `other` when they do not compare.
    #[inline]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    /// The larger of the two; `other` when they do not compare.
    #[inline]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    /// xⁿ by repeated squaring: at most 2·log₂ n multiplications.
    #[inline]
    fn powi(self, exponent: u32) -> Self {
        let mut result = Self::ONE;
        let mut square = self;
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                result *= square;
            }
            square *= square;
            rest >>= 1;
        }
        result
    }
}

accumulate_in_place!(f32);
accumulate_in_place!(f64);

impl Real for f32 {
    const ZERO: Self = 0.0;
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const TWO: Self = 2.0;
    const DISPLAY_STEP: Self = 1.0 / 255.0;
    const MAX: Self = f32::MAX;
    const FARTHEST: Self = 1_152_921_504_606_846_976.0;
    const SMALLEST: Self = f32::MIN_POSITIVE;
    const ROUNDOFF: Self = f32::EPSILON / 2.0;
    const DIVIDES_FAST: bool = HAS_FPU;

    #[inline]
    fn from_f32(x: f32) -> Self {
        x
    }
    #[inline]
    fn to_f32(self) -> f32 {
        self
    }
    #[inline]
    fn from_u32(x: u32) -> Self {
        x as f32
    }
    #[inline]
    fn abs(self) -> Self {
        // The sign bit alone, which is one instruction where there is an FPU and no call where there is none.
        f32::abs(self)
    }
    #[inline]
    fn sqrt(self) -> Self {
        square_root::f32(self)
    }
    #[inline]
    fn exp(self) -> Self {
        libm::expf(self)
    }
    #[inline]
    fn powf(self, y: Self) -> Self {
        power(self, y)
    }
    #[inline]
    fn product_error(self, other: Self, product: Self) -> Self {
        exact_product::error(self, other, product, 4097.0)
    }
    #[inline(always)]
    fn lanes(numbers: &[Self; LANES]) -> Option<Lanes> {
        lanes::of(numbers)
    }
    #[inline(never)]
    fn floor(self) -> Self {
        if !HAS_FPU {
            return integer_floor::floor(self);
        }
        // A few instructions in place of a call. From 2²³ on there are no fractions.
        let truncated = self as i32 as f32;
        let whole = if truncated > self { truncated - 1.0 } else { truncated };
        if Self::abs(self) < 8_388_608.0 { whole } else { self }
    }
    #[inline]
    fn is_even(self) -> bool {
        // From 2²⁴ on all are.
        Self::abs(self) >= 16_777_216.0 || self as i32 & 1 == 0
    }
}

impl Real for f64 {
    const ZERO: Self = 0.0;
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const TWO: Self = 2.0;
    const DISPLAY_STEP: Self = 1.0 / 255.0;
    const MAX: Self = f64::MAX;
    const FARTHEST: Self = 1_152_921_504_606_846_976.0;
    const SMALLEST: Self = f64::MIN_POSITIVE;
    const ROUNDOFF: Self = f64::EPSILON / 2.0;

    #[inline]
    fn from_f32(x: f32) -> Self {
        f64::from(x)
    }
    #[inline]
    fn to_f32(self) -> f32 {
        self as f32
    }
    #[inline]
    fn from_u32(x: u32) -> Self {
        f64::from(x)
    }
    #[inline]
    fn abs(self) -> Self {
        // The sign bit alone, which is one instruction where there is an FPU and no call where there is none.
        f64::abs(self)
    }
    #[inline]
    fn sqrt(self) -> Self {
        square_root::f64(self)
    }
    #[inline]
    fn exp(self) -> Self {
        libm::exp(self)
    }
    #[inline]
    fn powf(self, y: Self) -> Self {
        libm::pow(self, y)
    }
    #[inline]
    fn product_error(self, other: Self, product: Self) -> Self {
        exact_product::error(self, other, product, 134_217_729.0)
    }
    #[inline]
    fn floor(self) -> Self {
        libm::floor(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_even_as_their_remainders_say() {
        let near = |power: u32| (-3..=3).map(move |step: i32| 2_f32.powi(power as i32) + step as f32);
        for x in (0..40).flat_map(near).flat_map(|x| [x, -x]).filter(|x| x.fract() == 0.0).chain([1e30, f32::MAX]) {
            assert_eq!(x.is_even(), f64::from(x) % 2.0 == 0.0, "{x}");
            assert_eq!(f64::from(x).is_even(), f64::from(x) % 2.0 == 0.0, "{x}");
        }
    }
}
