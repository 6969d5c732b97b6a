//! Numbers of twice the digits: the sum of two numbers.
//!
//! Each operation keeps what rounding took from it and is good to a few u², where u is the unit roundoff of the number
//! type (Dekker, "A Floating-Point Technique for Extending the Available Precision", 1971). For places where nearly equal
//! numbers are subtracted. Those are met rarely, so sums and products are calls, which keeps the code small.

use core::ops::{Add, Mul, Neg, Sub};

use super::{Real, Vec3};

/// high + low, where `low` is no larger than a rounding of `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Twofold<T> {
    high: T,
    low: T,
}

impl<T: Real> Twofold<T> {
    /// a − b, exactly.
    #[inline]
    pub(crate) fn difference(a: T, b: T) -> Self {
        let (high, low) = sum_and_error(a, -b);
        Self { high, low }
    }

    /// The square.
    pub(crate) fn squared(self) -> Self {
        self * self
    }

    /// The nearest number.
    #[inline]
    pub(crate) fn rounded(self) -> T {
        self.high + self.low
    }

    #[inline]
    fn new(high: T, low: T) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }
}

impl<T: Real> Vec3<T> {
    /// self − other, exactly.
    pub(crate) fn exact_difference(self, other: Self) -> Vec3<Twofold<T>> {
        Vec3 {
            x: Twofold::difference(self.x, other.x),
            y: Twofold::difference(self.y, other.y),
            z: Twofold::difference(self.z, other.z),
        }
    }
}

impl<T: Real> Vec3<Twofold<T>> {
    /// The scalar product.
    pub(crate) fn twofold_dot(self, other: Self) -> Twofold<T> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The nearest vector.
    pub(crate) fn rounded(self) -> Vec3<T> {
        self.map(Twofold::rounded)
    }

    /// The vector product.
    pub(crate) fn twofold_cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
}

/// a + b as it is computed, and what rounding took from it, exactly (Knuth, "The Art of Computer Programming", volume 2,
/// 4.2.2).
#[inline]
fn sum_and_error<T: Real>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_taken = sum - a;
    let a_taken = sum - b_taken;
    (sum, (a - a_taken) + (b - b_taken))
}

impl<T: Real> Add for Twofold<T> {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (sum, error) = sum_and_error(self.high, other.high);
        Self::new(sum, error + (self.low + other.low))
    }
}

impl<T: Real> Neg for Twofold<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl<T: Real> Sub for Twofold<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Real> Mul for Twofold<T> {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let error = self.high.product_error(other.high, product);
        Self::new(product, error + (self.high * other.low + self.low * other.high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers() -> impl Iterator<Item = [f32; 3]> {
        let mut x = 0x1234_5678_u32;
        let mut next = move || {
            x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (f32::from_bits((x >> 9) | 0x3f80_0000) - 1.5) * f32::from_bits(0x3f80_0000 + ((x & 31) << 23))
        };
        (0..100_000).map(move |_| [next(), next(), next()])
    }

    #[test]
    fn sums_are_exact() {
        for [a, b, _] in numbers() {
            let (sum, error) = sum_and_error(a, b);
            assert_eq!(sum, a + b);
            assert_eq!(f64::from(a) + f64::from(b), f64::from(sum) + f64::from(error), "{a} {b}");
        }
    }

    /// (a − b)·(a + b) + c² − a² + b² − c² is 0; here it is, to a few u² of the terms.
    #[test]
    fn what_cancels_is_kept() {
        for [a, b, c] in numbers() {
            let [x, y, z] = [a, b, c].map(|v| Twofold::difference(v, 0.0));
            let rest = (Twofold::difference(a, b) * (x + y) + z * z - x * x + y * y - z * z).rounded();
            let size = a * a + b * b + c * c;
            assert!(rest.abs() <= size * f32::ROUNDOFF * f32::ROUNDOFF * 16.0, "{a} {b} {c}: {rest:e}");
        }
    }
}
