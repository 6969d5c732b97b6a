//! The operators. Sums and products that are out of range wrap, or panic where overflow is checked.

use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use fixed::types::extra::Unsigned;

use super::{Q, raw};

impl<Frac: Unsigned> Neg for Q<Frac> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::from_bits(-self.to_bits())
    }
}

impl<Frac: Unsigned> Add for Q<Frac> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::from_bits(self.to_bits() + other.to_bits())
    }
}

impl<Frac: Unsigned> Sub for Q<Frac> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::from_bits(self.to_bits() - other.to_bits())
    }
}

impl<Frac: Unsigned> Mul for Q<Frac> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::from_bits(raw::multiply(self.to_bits(), other.to_bits(), Self::F))
    }
}

/// A quotient that is too large, as by 0, is the largest number of its sign.
impl<Frac: Unsigned> Div for Q<Frac> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self::from_bits(raw::quotient(self.to_bits(), other.to_bits(), Self::F))
    }
}

impl<Frac: Unsigned> AddAssign for Q<Frac> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<Frac: Unsigned> SubAssign for Q<Frac> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<Frac: Unsigned> MulAssign for Q<Frac> {
    #[inline(always)]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}
