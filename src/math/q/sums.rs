//! Sums of products, in 64 bits.

use fixed::types::extra::LeEqU32;

use super::{Q, raw};
use crate::math::fixed_point::LARGEST;
use crate::math::{Accumulate, Vec3};

/// The bits of fraction of a [factor](Accumulate::factor), so that one of up to 16 times any column of a picture has room.
const FACTOR: u32 = 30;

impl<Frac: LeEqU32 + 'static> Accumulate for Q<Frac> {
    /// With twice the bits of fraction, but for factors.
    type Wide = i64;
    const NOTHING: i64 = 0;

    #[inline(always)]
    fn product(self, other: Self) -> i64 {
        raw::product(self.to_bits(), other.to_bits())
    }
    #[inline]
    fn times(self, sum: i64) -> i64 {
        let (factor, upper, lower) = (i64::from(self.to_bits()), sum >> Self::F, sum & ((1 << Self::F) - 1));
        factor * upper + ((factor * lower) >> Self::F)
    }
    #[inline(always)]
    fn widened(self) -> i64 {
        i64::from(self.to_bits()) << Self::F
    }
    #[inline(always)]
    fn narrow(sum: i64) -> Self {
        let rounded = (sum + (1 << (Self::F - 1))) >> Self::F;
        debug_assert!(rounded.abs() <= i64::from(i32::MAX), "{sum} is out of range");
        Self::from_bits(rounded as i32)
    }
    #[inline(always)]
    fn held(sum: i64) -> Self {
        Self::from_bits(raw::narrow(sum, Self::F))
    }
    #[inline(always)]
    fn root(sum: i64) -> Self {
        Self::from_bits(raw::square_root(sum as u64) as i32)
    }
    fn root_of_discriminant(a: i64, b: i64, c: i64) -> Option<i64> {
        let square = i128::from(b) * i128::from(b) - i128::from(a) * i128::from(c);
        let square = u128::try_from(square).ok()?;
        // By an even number of bits, so that 62 are left.
        let excess = 67_u32.saturating_sub(square.leading_zeros()) & !1;
        Some(i64::from(raw::square_root((square >> excess) as u64)) << (excess / 2))
    }
    #[inline(always)]
    fn ratio(dividend: i64, divisor: i64) -> Self {
        Self::from_bits(raw::ratio(dividend, divisor, Self::F))
    }
    /// Without more bits of fraction: there may be 2³² of them.
    #[inline(always)]
    fn summand(self) -> i64 {
        self.to_bits().into()
    }
    fn mean(sum: i64, count: u32) -> Self {
        let count = i64::from(count.max(1));
        Self::from_bits(((sum + count / 2) / count) as i32)
    }
    fn factor(dividend: Self, divisor: u32) -> i64 {
        (i64::from(dividend.to_bits()) << (FACTOR - Self::F)) / i64::from(divisor.max(1))
    }
    #[inline(always)]
    fn share(dividend: i64, divisor: i64) -> i64 {
        raw::ratio(dividend, divisor, FACTOR).into()
    }
    fn scaled(self, factor: i64) -> Self {
        let scaled = (i64::from(self.to_bits()) * factor + (1 << (FACTOR - 1))) >> FACTOR;
        Self::from_bits(scaled.clamp(-i64::from(LARGEST), i64::from(LARGEST)) as i32)
    }
    /// Products are exact, but a factor of about 1 is not: a unit vector's length is off by two roundings.
    #[inline(always)]
    fn less(square: i64, count: f32) -> i64 {
        let roundings = count as i64;
        square - (square >> Self::F) * roundings - (roundings << Self::F)
    }
    #[inline(always)]
    fn unit(vector: Vec3<Self>) -> Option<Vec3<Self>> {
        let Vec3 { x, y, z } = vector.map(Self::to_bits);
        raw::unit_narrow([x, y, z], Self::F).map(Self::vector)
    }
    #[inline(always)]
    fn unit_of_sums(Vec3 { x, y, z }: Vec3<i64>) -> Option<Vec3<Self>> {
        raw::unit([x, y, z], Self::F).map(Self::vector)
    }
    #[inline]
    fn of_length(vector: Vec3<Self>, length: Self) -> Option<(Vec3<Self>, Vec3<Self>)> {
        const FINE: u32 = 26;
        let Vec3 { x, y, z } = vector.map(Self::to_bits);
        let fine = raw::unit_narrow([x, y, z], FINE)?;
        let shift = FINE - Self::F;
        let unit = fine.map(|x| (x + (1 << (shift - 1))) >> shift);
        let local = fine.map(|x| raw::narrow(raw::product(x, length.to_bits()), FINE));
        Some((Self::vector(unit), Self::vector(local)))
    }
    #[inline]
    fn direction_and_length(vector: Vec3<Self>) -> Option<(Vec3<Self>, Self)> {
        Self::unit(vector).map(|direction| (direction, vector.length()))
    }
}
