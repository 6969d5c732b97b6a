//! Complex numbers, for indices of refraction that absorb and for phases.

use core::ops::{Add, Div, Mul, Sub};

use super::Real;

/// The complex number re + i·im.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex<T> {
    /// The real part.
    pub re: T,
    /// The imaginary part.
    pub im: T,
}

impl<T> Complex<T> {
    /// re + i·im
    pub const fn new(re: T, im: T) -> Self {
        Self { re, im }
    }
}

impl<T: Real> Complex<T> {
    /// 0
    pub const ZERO: Self = Self { re: T::ZERO, im: T::ZERO };
    /// 1
    pub const ONE: Self = Self { re: T::ONE, im: T::ZERO };

    /// The real number `re`.
    #[inline]
    #[must_use]
    pub fn real(re: T) -> Self {
        Self { re, im: T::ZERO }
    }

    /// |z|²
    #[inline]
    #[must_use]
    pub fn norm_squared(self) -> T {
        T::narrow(self.square())
    }

    /// |z|², not yet rounded.
    #[inline]
    pub(crate) fn square(self) -> T::Wide {
        self.re.product(self.re) + self.im.product(self.im)
    }

    /// From `self` at `t` = 0 to `other` at `t` = 1.
    #[inline]
    #[must_use]
    pub fn mix(self, other: Self, t: T) -> Self {
        self * (T::ONE - t) + other * t
    }

    /// The square root with Im ≥ 0; that of a real number is real and not negative, or i times such a number.
    ///
    /// It is the branch of a wave e^{i(qz − ωt)} that dies away, and not grows, in the direction that it travels.
    ///
    /// Both parts come from one sum of numbers that are not negative, so nothing cancels, and |z| from the ratio of the
    /// parts, so nothing overflows (Press et al., *Numerical Recipes*, 3rd edition, §5.5).
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        let (x, y) = (self.re.abs(), self.im.abs());
        let large = x.max(y);
        if y == T::ZERO {
            let root = x.sqrt();
            return if self.re < T::ZERO { Self::new(T::ZERO, root) } else { Self::new(root, T::ZERO) };
        }
        let ratio = x.min(y) / large;
        let norm = (T::ONE + ratio * ratio).sqrt();
        // √((|z| + |Re z|)/2), with the scale taken out of the sum.
        let one = large.sqrt() * (T::HALF * (norm + x / large)).sqrt();
        let other = T::HALF * (y / one);
        let (re, im) = if self.re < T::ZERO { (other, one) } else { (one, other) };
        Self::new(if self.im < T::ZERO { -re } else { re }, im)
    }
}

impl<T: Real> Add for Complex<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl<T: Real> Sub for Complex<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl<T: Real> Mul for Complex<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

impl<T: Real> Mul<T> for Complex<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }
}

/// By the conjugate: |divisor|² must be a number that `T` can hold, and not zero.
impl<T: Real> Div for Complex<T> {
    type Output = Self;
    #[inline]
    fn div(self, divisor: Self) -> Self {
        if T::IS_FIXED {
            // Not through a reciprocal, which would have few digits.
            let square = divisor.square();
            let re = self.re.product(divisor.re) + self.im.product(divisor.im);
            let im = self.im.product(divisor.re) - self.re.product(divisor.im);
            return Self::new(T::ratio(re, square), T::ratio(im, square));
        }
        let scale = T::ONE / divisor.norm_squared();
        self * Self::new(divisor.re, -divisor.im) * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(a: Complex<f64>, b: Complex<f64>) -> f64 {
        (a - b).norm_squared().sqrt()
    }

    #[test]
    fn field_operations() {
        let (a, b) = (Complex::new(1.5_f64, -2.0), Complex::new(-0.25, 3.0));
        assert_eq!(a * b, Complex::new(5.625, 5.0));
        assert!(distance(a / b * b, a) < 1e-15);
        assert_eq!(a + b - a, b);
        assert_eq!(Complex::new(0.0_f32, 2.0) / Complex::real(4.0), Complex::new(0.0, 0.5));
        assert_eq!(a.mix(b, 0.0), a);
        assert_eq!(a.mix(b, 1.0), b);
        assert_eq!(Complex::<f32>::ONE * Complex::ONE + Complex::ZERO, Complex::real(1.0));
    }

    #[test]
    fn roots_square_back_and_lie_in_the_upper_half() {
        let parts = [0.0, 1e-30, 3e-20, 1e-4, 0.7, 1.0, 42.0, 1e18, 1e30_f32];
        for x in parts.into_iter().flat_map(|x| [x, -x]) {
            for y in parts.into_iter().flat_map(|y| [y, -y]) {
                let root = Complex::new(x, y).sqrt();
                assert!(root.im >= 0.0 && (y != 0.0 || root.re >= 0.0), "{x} {y}: {root:?}");
                // In f64 the square is not rounded as far as this test sees.
                let wide = Complex::new(f64::from(root.re), f64::from(root.im));
                let z = Complex::new(f64::from(x), f64::from(y));
                assert!(distance(wide * wide, z) <= 4e-7 * z.norm_squared().sqrt(), "{x} {y}: {root:?}");
            }
        }
    }

    /// Close to the real axis the small part keeps all its digits.
    #[test]
    fn small_parts_of_roots_are_accurate() {
        let root = Complex::new(-4.0_f32, 1e-6).sqrt();
        assert!((root.re - 2.5e-7).abs() < 1e-13 && root.im == 2.0, "{root:?}");
        let root = Complex::new(4.0_f32, -1e-6).sqrt();
        assert!((root.im - 2.5e-7).abs() < 1e-13 && root.re == -2.0, "{root:?}");
    }
}
