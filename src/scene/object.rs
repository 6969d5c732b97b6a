//! A shape made of a material.

use super::{Material, Shape};
use crate::math::Real;

/// A shape, its material and how rays see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<'a, T> {
    /// Geometry.
    pub shape: Shape<'a, T>,
    /// Looks.
    pub material: Material<T>,
    /// From which sides rays meet it.
    pub sides: Sides,
    /// Whether it hides lights from other points.
    pub shadow: Shadow,
}

/// From which sides a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// From outside and from inside.
    Both,
    /// From outside only; from inside a ray passes as if nothing were there.
    Outside,
}

/// Whether an object hides lights from other points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadow {
    /// It does, glass too: shadow rays are not bent.
    Full,
    /// It does not: light from a light passes as if nothing were there.
    None,
    /// Light from a light goes straight through a dielectric, not bent, and its medium attenuates it.
    Tinted,
}

impl<'a, T: Real> Object<'a, T> {
    /// An object that is seen from both sides and casts a shadow.
    pub const fn new(shape: Shape<'a, T>, material: Material<T>) -> Self {
        Self { shape, material, sides: Sides::Both, shadow: Shadow::Full }
    }

    /// The same object, casting no shadow.
    #[must_use]
    pub const fn without_shadow(self) -> Self {
        Self { shadow: Shadow::None, ..self }
    }

    /// The same object, casting a shadow in the colour of its medium.
    #[must_use]
    pub const fn with_tinted_shadow(self) -> Self {
        Self { shadow: Shadow::Tinted, ..self }
    }

    /// The same object, seen from outside only.
    #[must_use]
    pub const fn one_sided(self) -> Self {
        Self { sides: Sides::Outside, ..self }
    }

    /// Primitive `index` of the shape as an object of its own, in another number type; `None` past the end.
    pub(crate) fn part<U: Real>(&self, index: usize, convert: impl Fn(T) -> U) -> Option<Object<'static, U>> {
        let shape = self.shape.part(index, &convert)?;
        Some(Object { shape, material: self.material.map(convert), sides: self.sides, shadow: self.shadow })
    }
}
