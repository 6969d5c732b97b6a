//! The number types.

use whit::{Real, Vec3};

use super::Vector;

/// A number type of the library and its way from and to `f64`.
pub trait Number: Real {
    fn of(x: f64) -> Self;
    fn get(self) -> f64;

    fn vector([x, y, z]: Vector) -> Vec3<Self> {
        Vec3::new(Self::of(x), Self::of(y), Self::of(z))
    }
}

impl Number for f32 {
    fn of(x: f64) -> Self {
        x as f32
    }
    fn get(self) -> f64 {
        f64::from(self)
    }
}

impl Number for f64 {
    fn of(x: f64) -> Self {
        x
    }
    fn get(self) -> f64 {
        self
    }
}
