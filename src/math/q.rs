//! Fixed-point numbers, for processors without an FPU.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U16, U20, Unsigned};

use super::fixed_point::{self as raw, LARGEST};
use super::{Accumulate, Range, Real, Vec3};

/// A fixed-point number of 32 bits, of which `Frac` are its fraction.
///
/// For processors without an FPU, where its sums take one instruction and its products some twenty, against a hundred for
/// `f32`. All numbers are 2⁻ᶠ apart, for F bits of fraction, whatever their size; so a scene has to fit:
///
/// | type | F | coordinates and lengths | seen up to | numbers are apart by |
/// |---|--:|--:|--:|--:|
/// | [`Q16`] | 16 | 1024 | 8192 | 1.5e-5 |
/// | [`Q20`] | 20 | 64 | 512 | 9.5e-7 |
///
/// [`Scene::validate`](crate::Scene::validate) refuses a scene that does not, and names the number that is too large. Within
/// these limits nothing overflows: sums of products are held in 64 bits, and what may still grow too large (a distance to what
/// is nearly parallel, the sum of many lights) stops at the largest number. Light is not bent in fixed point: a mirage lives in
/// differences of the index of refraction of 1e-5.
///
/// A ray of one's own may start as far out as things are seen. A shape should be at least 32 times as large as numbers are
/// apart: rays need some of that to leave it.
///
/// The functions (square root, exponential, power, the direction of a vector) are good to the last bit or two.
pub struct Q<Frac>(FixedI32<Frac>);

/// Coordinates up to 1024, 1.5e-5 apart.
pub type Q16 = Q<U16>;
/// Coordinates up to 64, 9.5e-7 apart.
pub type Q20 = Q<U20>;

impl<Frac: Unsigned> Q<Frac> {
    const F: u32 = {
        assert!(Frac::U32 >= 12 && Frac::U32 <= 20, "a fraction of 12 to 20 bits");
        Frac::U32
    };

    /// The number of 2⁻ᶠ.
    #[inline(always)]
    pub const fn from_bits(bits: i32) -> Self {
        Self(FixedI32::from_bits(bits))
    }

    /// How many 2⁻ᶠ it is.
    #[inline(always)]
    pub const fn to_bits(self) -> i32 {
        self.0.to_bits()
    }

    /// The nearest number, also in constant evaluation; the largest for what is beyond it.
    #[inline(always)]
    pub const fn new(x: f32) -> Self {
        Self::from_bits(raw::from_f32(x, Self::F))
    }

    /// The nearest number of so many bits of fraction, from a number with twice as many.
    #[inline(always)]
    fn vector(bits: [i32; 3]) -> Vec3<Self> {
        Vec3::from(bits.map(Self::from_bits))
    }
}

impl<Frac: Unsigned> Clone for Q<Frac> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<Frac: Unsigned> Copy for Q<Frac> {}

impl<Frac: Unsigned> Default for Q<Frac> {
    fn default() -> Self {
        Self::from_bits(0)
    }
}

impl<Frac: Unsigned> PartialEq for Q<Frac> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl<Frac: Unsigned> Eq for Q<Frac> {}

impl<Frac: Unsigned> PartialOrd for Q<Frac> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<Frac: Unsigned> Ord for Q<Frac> {
    #[inline(always)]
    fn cmp(&self, other: &Self) -> Ordering {
        self.to_bits().cmp(&other.to_bits())
    }
}

impl<Frac: LeEqU32> fmt::Debug for Q<Frac> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<Frac: LeEqU32> fmt::Display for Q<Frac> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<Frac> From<FixedI32<Frac>> for Q<Frac> {
    fn from(number: FixedI32<Frac>) -> Self {
        Self(number)
    }
}

impl<Frac> From<Q<Frac>> for FixedI32<Frac> {
    fn from(number: Q<Frac>) -> Self {
        number.0
    }
}

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
