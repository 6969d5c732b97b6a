//! Points and directions.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use super::Real;

/// A point or a direction in right-handed space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3<T> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
    /// Third coordinate.
    pub z: T,
}

impl<T> Vec3<T> {
    /// The vector (x, y, z).
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
}

impl<T: Copy> Vec3<T> {
    /// The vector (value, value, value).
    pub const fn splat(value: T) -> Self {
        Self { x: value, y: value, z: value }
    }

    /// The vector with `f` applied to each coordinate.
    #[inline]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Vec3<U> {
        Vec3 { x: f(self.x), y: f(self.y), z: f(self.z) }
    }
}

impl<T: Real> Vec3<T> {
    /// The origin.
    pub const ZERO: Self = Self { x: T::ZERO, y: T::ZERO, z: T::ZERO };

    /// The scalar product.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        T::narrow(self.products(other))
    }

    /// The scalar product, not yet rounded.
    #[inline]
    pub(crate) fn products(self, other: Self) -> T::Wide {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// The vector product, by the right-hand rule.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        self.cross_products(other).map(T::narrow)
    }

    /// The vector product, not yet rounded.
    #[inline]
    pub(crate) fn cross_products(self, other: Self) -> Vec3<T::Wide> {
        Vec3 {
            x: self.y.product(other.z) - self.z.product(other.y),
            y: self.z.product(other.x) - self.x.product(other.z),
            z: self.x.product(other.y) - self.y.product(other.x),
        }
    }

    /// |v|²
    #[inline]
    #[must_use]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }

    /// |v|², not yet rounded.
    #[inline]
    pub(crate) fn square(self) -> T::Wide {
        self.products(self)
    }

    /// |v|
    #[inline]
    #[must_use]
    pub fn length(self) -> T {
        T::root(self.square())
    }

    /// v/|v|, or the zero vector where |v|² is zero or too small for the number type to hold it with all its digits.
    #[inline]
    #[must_use]
    pub fn normalized(self) -> Self {
        self.normalized_or(Self::ZERO)
    }

    /// v/|v|, or `other` where |v|² is zero or has lost digits to underflow.
    #[inline]
    pub(crate) fn normalized_or(self, other: Self) -> Self {
        T::unit(self).unwrap_or(other)
    }

    /// The larger of each pair of coordinates.
    #[inline]
    pub(crate) fn max(self, other: Self) -> Self {
        Self { x: self.x.max(other.x), y: self.y.max(other.y), z: self.z.max(other.z) }
    }

    /// The smaller of each pair of coordinates.
    #[inline]
    pub(crate) fn min(self, other: Self) -> Self {
        Self { x: self.x.min(other.x), y: self.y.min(other.y), z: self.z.min(other.z) }
    }

    /// The largest coordinate, without its sign.
    #[inline]
    pub(crate) fn largest(self) -> T {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// The vector of absolute values.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        self.map(T::abs)
    }

    /// Two unit vectors that make a right-handed frame with this unit vector.
    ///
    /// Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 2017).
    #[must_use]
    pub fn tangents(self) -> (Self, Self) {
        let sign = if self.z < T::ZERO { -T::ONE } else { T::ONE };
        let a = -T::ONE / (sign + self.z);
        let b = self.x * self.y * a;
        (
            Self { x: T::ONE + sign * self.x * self.x * a, y: sign * b, z: -(sign * self.x) },
            Self { x: b, y: sign + self.y * self.y * a, z: -self.y },
        )
    }
}

impl<T> From<[T; 3]> for Vec3<T> {
    fn from([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }
}

impl<T: Real> Add for Vec3<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<T: Real> Sub for Vec3<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<T: Real> Mul<T> for Vec3<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self.map(|x| x * factor)
    }
}

impl<T: Real> Neg for Vec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<T: Real> AddAssign for Vec3<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real> SubAssign for Vec3<T> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_complete_a_right_handed_frame() {
        for axis in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.6, -0.8, 0.0], [0.36, 0.48, -0.8]] {
            let n = Vec3::<f64>::from(axis);
            let (t, b) = n.tangents();
            assert!((t.cross(b) - n).length() < 1e-12 && (t.length() - 1.0).abs() < 1e-12);
        }
    }
}
