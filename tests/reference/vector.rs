//! Vectors and colours of `f64`.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A point or a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

impl Vector {
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    pub fn normalized(self) -> Self {
        self * (1.0 / self.length())
    }

    /// The coordinates in order, to loop over the axes.
    pub fn axes(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// The largest coordinate without its sign.
    pub fn largest(self) -> f64 {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }
}

impl From<whit::Vec3<f32>> for Vector {
    fn from(v: whit::Vec3<f32>) -> Self {
        Self::new(v.x.into(), v.y.into(), v.z.into())
    }
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Neg for Vector {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Mul<f64> for Vector {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

/// Linear red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Color(pub [f64; 3]);

impl Color {
    pub const BLACK: Self = Self::grey(0.0);
    pub const WHITE: Self = Self::grey(1.0);

    pub const fn grey(value: f64) -> Self {
        Self([value; 3])
    }

    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    pub fn max_channel(self) -> f64 {
        let Self([r, g, b]) = self;
        r.max(g).max(b)
    }
}

impl From<whit::Rgb<f32>> for Color {
    fn from(c: whit::Rgb<f32>) -> Self {
        Self([c.r.into(), c.g.into(), c.b.into()])
    }
}

impl Add for Color {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (Self([r, g, b]), Self([s, h, c])) = (self, other);
        Self([r + s, g + h, b + c])
    }
}

impl AddAssign for Color {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul for Color {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (Self([r, g, b]), Self([s, h, c])) = (self, other);
        Self([r * s, g * h, b * c])
    }
}

impl Mul<f64> for Color {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.map(|channel| channel * factor)
    }
}
