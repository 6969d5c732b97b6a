//! Linear colour.

use core::ops::{Add, AddAssign, Mul};

use super::Real;

/// Linear light in the primaries of Rec. 709 (the linear form of sRGB); also a factor per channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb<T> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

impl<T> Rgb<T> {
    /// The colour (r, g, b).
    pub const fn new(r: T, g: T, b: T) -> Self {
        Self { r, g, b }
    }
}

impl<T: Copy> Rgb<T> {
    /// The same value in each channel.
    pub const fn grey(value: T) -> Self {
        Self { r: value, g: value, b: value }
    }

    /// The colour with `f` applied to each channel.
    #[inline]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Rgb<U> {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }

    /// Each channel of two colours, put together by `f`.
    #[inline]
    pub fn zip<U, V>(self, other: Rgb<U>, f: impl Fn(T, U) -> V) -> Rgb<V> {
        Rgb { r: f(self.r, other.r), g: f(self.g, other.g), b: f(self.b, other.b) }
    }
}

impl<T: Real> Rgb<T> {
    /// No light.
    pub const BLACK: Self = Self { r: T::ZERO, g: T::ZERO, b: T::ZERO };
    /// One in each channel.
    pub const WHITE: Self = Self { r: T::ONE, g: T::ONE, b: T::ONE };

    /// The largest channel.
    #[inline]
    #[must_use]
    pub fn max_channel(self) -> T {
        self.r.max(self.g).max(self.b)
    }

    /// The channel-wise smaller value.
    #[inline]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self { r: self.r.min(other.r), g: self.g.min(other.g), b: self.b.min(other.b) }
    }

    /// The channel-wise larger value.
    #[inline]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self { r: self.r.max(other.r), g: self.g.max(other.g), b: self.b.max(other.b) }
    }

    /// Adds light with a factor per channel. A call: its arguments are in memory, and some of its callers are large, where
    /// registers are scarce.
    #[inline(never)]
    pub(crate) fn gather(&mut self, light: Self, share: Self) {
        *self += light * share;
    }

    /// From `self` at `t` = 0 to `other` at `t` = 1.
    #[inline]
    #[must_use]
    pub fn mix(self, other: Self, t: T) -> Self {
        self * (T::ONE - t) + other * t
    }

    /// The product, or the largest number where it is beyond.
    #[inline]
    pub(crate) fn held_product(self, other: Self) -> Self {
        self.zip(other, |a, b| T::held(a.product(b)))
    }
}

impl Rgb<f32> {
    /// Relative luminance by the weights of Rec. 709.
    #[inline]
    #[must_use]
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }
}

impl<T: Real> Add for Rgb<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { r: self.r.plus(other.r), g: self.g.plus(other.g), b: self.b.plus(other.b) }
    }
}

impl<T: Real> AddAssign for Rgb<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real> Mul for Rgb<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self { r: self.r * other.r, g: self.g * other.g, b: self.b * other.b }
    }
}

impl<T: Real> Mul<T> for Rgb<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self.map(|channel| channel * factor)
    }
}
