//! What a scene calls for, so that a tracer holds no more.

use core::fmt;

use super::{Background, Emitter, Exponent, Interface, Light, Lobe, Material, Object, Pattern, Scene, Shadow, Shape};
use super::{Sides, Tone};

/// A set of effects: one bit for each optical effect and each kind of shape, pattern, light and background.
///
/// [`Scene::effects`] reads it off a scene in constant evaluation; a [`Tracer`](crate::Tracer) has it as a constant
/// parameter, and what is not in it is not in the binary.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Effects(u64);

macro_rules! effects {
    ($($(#[$doc:meta])* $name:ident = $bit:literal, $label:literal;)*) => {
        impl Effects {
            $($(#[$doc])* pub const $name: Self = Self(1 << $bit);)*
            /// Every effect there is: for scenes that are known only at run time.
            pub const ALL: Self = Self($(1 << $bit)|*);
            const LABELS: &'static [(Self, &'static str)] = &[$((Self::$name, $label)),*];
        }
    };
}

effects! {
    /// [`Shape::Sphere`]
    SPHERE = 0, "sphere";
    /// [`Shape::Spheres`]
    SPHERES = 1, "spheres";
    /// [`Shape::Plane`]
    PLANE = 2, "plane";
    /// [`Shape::Disc`]
    DISC = 3, "disc";
    /// [`Shape::Box`]
    BOX = 4, "box";
    /// [`Shape::Triangle`]
    TRIANGLE = 5, "triangle";
    /// [`Shape::Triangles`]
    TRIANGLES = 6, "triangles";
    /// [`Shape::SmoothTriangle`]
    SMOOTH_TRIANGLE = 7, "smooth-triangle";
    /// [`Shape::Cone`]
    CONE = 8, "cone";
    /// [`Sides::Outside`]
    ONE_SIDED = 9, "one-sided";
    /// [`Shadow::None`]
    SHADOWLESS = 10, "shadowless";
    /// A diffuse body.
    BODY = 11, "body";
    /// [`Pattern::Checker`]
    CHECKER = 12, "checker";
    /// [`Pattern::Gradient`]
    GRADIENT = 13, "gradient";
    /// [`Lobe::Blinn`]
    BLINN = 14, "blinn-highlight";
    /// [`Lobe::Phong`]
    PHONG = 15, "phong-highlight";
    /// [`Exponent::Integer`]
    INTEGER_EXPONENT = 16, "integer-exponent";
    /// [`Exponent::Real`]
    REAL_EXPONENT = 17, "real-exponent";
    /// [`Interface::Mirror`]
    MIRROR = 18, "mirror";
    /// [`Interface::Metal`]
    METAL = 19, "metal";
    /// [`Interface::Constant`]
    CONSTANT = 20, "constant-transmission";
    /// [`Interface::Dielectric`]
    DIELECTRIC = 21, "dielectric";
    /// [`Emitter::Point`]
    POINT_LIGHT = 22, "point-light";
    /// [`Emitter::Directional`]
    DIRECTIONAL_LIGHT = 23, "directional-light";
    /// [`Emitter::Sphere`]
    SPHERE_LIGHT = 24, "sphere-light";
    /// [`Emitter::Parallelogram`]
    PARALLELOGRAM_LIGHT = 25, "parallelogram-light";
    /// [`Falloff`](super::Falloff)
    FALLOFF = 26, "falloff";
    /// [`Background::Gradient`]
    BACKGROUND_GRADIENT = 27, "background-gradient";
    /// [`Background::Sky`]
    SKY = 28, "sky";
    /// [`Lens`](super::Lens)
    LENS = 29, "lens";
    /// [`Tone::Display`]
    DISPLAY_TONE = 30, "display-tone";
}

impl Effects {
    /// No effect at all.
    pub const NONE: Self = Self(0);

    /// The bits, for use as a constant parameter.
    #[must_use]
    pub const fn bits(self) -> u64 {
        self.0
    }

    /// The set with these bits; unknown bits are dropped.
    #[must_use]
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits & Self::ALL.0)
    }

    /// Whether any effect of `other` is in the set.
    #[must_use]
    pub const fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// The effects of both sets.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The effects of this set that are not in `other`.
    #[must_use]
    pub const fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Whether the set is empty.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The names of the effects, as [`Display`](fmt::Display) prints them.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        Self::LABELS.iter().filter(move |(effect, _)| self.has(*effect)).map(|(_, label)| *label)
    }
}

impl fmt::Display for Effects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in self.names().enumerate() {
            if i > 0 {
                f.write_str(", ")?;
            }
            f.write_str(name)?;
        }
        Ok(())
    }
}

impl fmt::Debug for Effects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Effects({self})")
    }
}

impl<T> Scene<'_, T> {
    /// The effects that the scene calls for. It reads structure only (which variants, `Some` or `None`), never a
    /// number, so it works in constant evaluation for every number type.
    #[must_use]
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    pub const fn effects(&self) -> Effects {
        let mut effects = match self.background {
            Background::Solid(_) => Effects::NONE,
            Background::Gradient { .. } => Effects::BACKGROUND_GRADIENT,
            Background::Sky { .. } => Effects::SKY,
        };
        if self.camera.lens.is_some() {
            effects = effects.with(Effects::LENS);
        }
        if matches!(self.tone, Tone::Display { .. }) {
            effects = effects.with(Effects::DISPLAY_TONE);
        }
        let mut i = 0;
        while i < self.objects.len() {
            effects = effects.with(self.objects[i].effects());
            i += 1;
        }
        let mut i = 0;
        while i < self.lights.len() {
            effects = effects.with(self.lights[i].effects());
            i += 1;
        }
        effects
    }
}

impl<T> Object<'_, T> {
    const fn effects(&self) -> Effects {
        let mut effects = self.material.effects().with(match self.shape {
            Shape::Sphere(_) => Effects::SPHERE,
            Shape::Spheres(_) => Effects::SPHERES,
            Shape::Plane(_) => Effects::PLANE,
            Shape::Disc(_) => Effects::DISC,
            Shape::Box(_) => Effects::BOX,
            Shape::Triangle(_) => Effects::TRIANGLE,
            Shape::Triangles(_) => Effects::TRIANGLES,
            Shape::SmoothTriangle(_) => Effects::SMOOTH_TRIANGLE,
            Shape::Cone(_) => Effects::CONE,
        });
        if matches!(self.sides, Sides::Outside) {
            effects = effects.with(Effects::ONE_SIDED);
        }
        if matches!(self.shadow, Shadow::None) {
            effects = effects.with(Effects::SHADOWLESS);
        }
        effects
    }
}

impl<T> Material<T> {
    const fn effects(&self) -> Effects {
        let mut effects = match self.interface {
            Interface::Opaque => Effects::NONE,
            Interface::Mirror { .. } => Effects::MIRROR,
            Interface::Metal { .. } => Effects::METAL,
            Interface::Constant { .. } => Effects::CONSTANT,
            Interface::Dielectric { .. } => Effects::DIELECTRIC,
        };
        if let Some(body) = &self.body {
            effects = effects.with(Effects::BODY).with(match body.color {
                Pattern::Solid(_) => Effects::NONE,
                Pattern::Checker { .. } => Effects::CHECKER,
                Pattern::Gradient { .. } => Effects::GRADIENT,
            });
        }
        if let Some(highlight) = &self.highlight {
            effects = effects.with(match highlight.lobe {
                Lobe::Blinn => Effects::BLINN,
                Lobe::Phong => Effects::PHONG,
            });
            effects = effects.with(match highlight.exponent {
                Exponent::Integer(_) => Effects::INTEGER_EXPONENT,
                Exponent::Real(_) => Effects::REAL_EXPONENT,
            });
        }
        effects
    }
}

impl<T> Light<T> {
    const fn effects(&self) -> Effects {
        let effects = match self.emitter {
            Emitter::Point { .. } => Effects::POINT_LIGHT,
            Emitter::Directional { .. } => Effects::DIRECTIONAL_LIGHT,
            Emitter::Sphere { .. } => Effects::SPHERE_LIGHT,
            Emitter::Parallelogram { .. } => Effects::PARALLELOGRAM_LIGHT,
        };
        if self.falloff.is_some() { effects.with(Effects::FALLOFF) } else { effects }
    }
}
