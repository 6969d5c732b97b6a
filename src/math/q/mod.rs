//! Fixed-point numbers, for processors without an FPU.

mod number;
mod operators;
mod sums;

use core::cmp::Ordering;
use core::fmt;

use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U16, U20, Unsigned};

use super::Vec3;
use super::fixed_point as raw;

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

    /// The vector of three such counts.
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
