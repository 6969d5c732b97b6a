//! Sums of products, with the digits that they need.

use core::fmt::Debug;
use core::ops::{Add, Neg, Sub};

use super::Vec3;

/// A number type whose products are summed before they are rounded.
///
/// A fixed-point number has no digits to spare: the square of a distance leaves its range long before the distance does. So
/// scalar products, discriminants and the like are sums of exact products in a type of twice the width, and rounded once.
/// For floating-point numbers that type is the number type itself.
pub trait Accumulate: Copy {
    /// The type of such sums.
    type Wide: Copy
        + Debug
        + PartialEq
        + PartialOrd
        + Neg<Output = Self::Wide>
        + Add<Output = Self::Wide>
        + Sub<Output = Self::Wide>;

    /// 0
    const NOTHING: Self::Wide;

    /// self·other
    fn product(self, other: Self) -> Self::Wide;
    /// self·sum
    fn times(self, sum: Self::Wide) -> Self::Wide;
    /// The same number.
    fn widened(self) -> Self::Wide;
    /// The nearest number, of a sum that is known to be in range.
    fn narrow(sum: Self::Wide) -> Self;
    /// The nearest number, the largest one for whatever is beyond it.
    fn held(sum: Self::Wide) -> Self;
    /// The square root of a sum that is not negative.
    fn root(sum: Self::Wide) -> Self;
    /// √(b² − a·c), and `None` where it is not real.
    fn root_of_discriminant(a: Self::Wide, b: Self::Wide, c: Self::Wide) -> Option<Self::Wide>;
    /// dividend/divisor
    fn ratio(dividend: Self::Wide, divisor: Self::Wide) -> Self;
    /// The same number, as one of many whose mean is asked for.
    fn summand(self) -> Self::Wide;
    /// A sum of so many of them, 1 or more, divided by how many they are.
    fn mean(sum: Self::Wide, count: u32) -> Self;
    /// dividend/divisor as a factor for large numbers, with digits enough for them; both are above 0.
    fn factor(dividend: Self, divisor: u32) -> Self::Wide;
    /// dividend/divisor as such a factor; it is from 0 to 1.
    fn share(dividend: Self::Wide, divisor: Self::Wide) -> Self::Wide;
    /// self·factor, the largest number where it is beyond.
    fn scaled(self, factor: Self::Wide) -> Self;
    /// What is left of a square that is 0 or more when `count` roundings of it are taken off.
    fn less(square: Self::Wide, count: f32) -> Self::Wide;
    /// The vector of length 1 in the direction of another one; `None` where that is zero or has lost digits to underflow.
    fn unit(vector: Vec3<Self>) -> Option<Vec3<Self>>;
    /// The same for a vector of sums.
    fn unit_of_sums(vector: Vec3<Self::Wide>) -> Option<Vec3<Self>>;
    /// The same, and the vector of this length in that direction, which is good to a rounding.
    fn of_length(vector: Vec3<Self>, length: Self) -> Option<(Vec3<Self>, Vec3<Self>)>;
    /// A vector's direction and length; `None` for the zero vector.
    fn direction_and_length(vector: Vec3<Self>) -> Option<(Vec3<Self>, Self)>;
}

/// What sums of products are for floating-point numbers.
macro_rules! accumulate_in_place {
    ($number:ty) => {
        impl Accumulate for $number {
            type Wide = Self;
            const NOTHING: Self = Self::ZERO;

            #[inline(always)]
            fn product(self, other: Self) -> Self {
                self * other
            }
            #[inline(always)]
            fn times(self, sum: Self) -> Self {
                self * sum
            }
            #[inline(always)]
            fn widened(self) -> Self {
                self
            }
            #[inline(always)]
            fn narrow(sum: Self) -> Self {
                sum
            }
            #[inline(always)]
            fn held(sum: Self) -> Self {
                sum
            }
            #[inline(always)]
            fn root(sum: Self) -> Self {
                Real::sqrt(sum)
            }
            #[inline(always)]
            fn root_of_discriminant(a: Self, b: Self, c: Self) -> Option<Self> {
                let discriminant = b * b - a * c;
                if discriminant < Self::ZERO { None } else { Some(Real::sqrt(discriminant)) }
            }
            #[inline(always)]
            fn ratio(dividend: Self, divisor: Self) -> Self {
                dividend / divisor
            }
            #[inline(always)]
            fn summand(self) -> Self {
                self
            }
            #[inline(always)]
            fn mean(sum: Self, count: u32) -> Self {
                sum * (Self::ONE / Self::from_u32(count))
            }
            #[inline(always)]
            fn factor(dividend: Self, divisor: u32) -> Self {
                dividend / Self::from_u32(divisor)
            }
            #[inline(always)]
            fn share(dividend: Self, divisor: Self) -> Self {
                dividend / divisor
            }
            #[inline(always)]
            fn scaled(self, factor: Self) -> Self {
                self * factor
            }
            #[inline(always)]
            fn less(square: Self, count: f32) -> Self {
                square * (Self::ONE - Self::from_f32(count) * Self::ROUNDOFF)
            }
            #[inline]
            fn unit(vector: Vec3<Self>) -> Option<Vec3<Self>> {
                let square = vector.length_squared();
                if square >= Self::SMALLEST { Some(vector * (Self::ONE / Real::sqrt(square))) } else { None }
            }
            #[inline]
            fn unit_of_sums(vector: Vec3<Self>) -> Option<Vec3<Self>> {
                Self::unit(vector)
            }
            #[inline]
            fn of_length(vector: Vec3<Self>, length: Self) -> Option<(Vec3<Self>, Vec3<Self>)> {
                Self::unit(vector).map(|unit| (unit, unit * length))
            }
            #[inline]
            fn direction_and_length(vector: Vec3<Self>) -> Option<(Vec3<Self>, Self)> {
                let length = vector.length();
                if length == Self::ZERO { None } else { Some((vector * (Self::ONE / length), length)) }
            }
        }
    };
}
pub(super) use accumulate_in_place;
