//! Complex numbers, as far as wave optics needs them.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// re + i·im
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    pub re: f64,
    pub im: f64,
}

impl Complex {
    pub const ONE: Self = Self::new(1.0, 0.0);

    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    pub fn norm_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// The root with no negative part, of a number with an imaginary part that is not negative: of a negative number the
    /// one on the positive imaginary axis, so that waves that cannot propagate fade.
    pub fn sqrt(self) -> Self {
        let length = self.norm_squared().sqrt();
        Self::new((0.5 * (length + self.re)).max(0.0).sqrt(), (0.5 * (length - self.re)).max(0.0).sqrt())
    }

    pub fn exp(self) -> Self {
        let (sine, cosine) = self.im.sin_cos();
        Self::new(cosine, sine) * Self::new(self.re.exp(), 0.0)
    }
}

impl From<f64> for Complex {
    fn from(re: f64) -> Self {
        Self::new(re, 0.0)
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let scale = other.norm_squared();
        let Self { re, im } = self * Self::new(other.re, -other.im);
        Self::new(re / scale, im / scale)
    }
}
