//! What light does at a surface.

use super::{Film, Interface, Medium, Pattern};
use crate::math::{Real, Rgb};

/// How a surface looks: a diffuse body, a highlight and an interface, each of which may be missing.
///
/// ```
/// use whit::{Material, Rgb};
/// const RED_PLASTIC: Material<f32> = Material::matte(Rgb::new(0.8, 0.1, 0.1)).with_highlight(Rgb::grey(0.4), 50);
/// const GLASS: Material<f32> = Material::dielectric(1.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<T> {
    /// Diffuse body.
    pub body: Option<Body<T>>,
    /// Mirror image of the lights.
    pub highlight: Option<Highlight<T>>,
    /// Whether branches of light are reflected and transmitted, and how much.
    pub interface: Interface<T>,
    /// How much the body and highlight count against the branches; `None` adds them up as they are.
    pub balance: Option<Balance<T>>,
}

/// The part of a material that has a colour of its own.
///
/// It shows colour · (emission + Σ L·(ambient + diffuse·max(0, N·ω))), the sum taken over the lights that are visible
/// from the point. Ambient light comes from a light and vanishes in its shadow; emission does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<T> {
    /// Colour.
    pub color: Pattern<T>,
    /// Share of the colour that is seen without any light.
    pub emission: T,
    /// k_a
    pub ambient: T,
    /// k_d
    pub diffuse: T,
}

/// A highlight: L · colour · cosˢ, summed over the visible lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Highlight<T> {
    /// k_s
    pub color: Rgb<T>,
    /// Which cosine.
    pub lobe: Lobe,
    /// s
    pub exponent: Exponent<T>,
}

/// The cosine that a highlight raises to a power.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lobe {
    /// N·H, with H halfway between the light and the eye.
    Blinn,
    /// R·ω, with R the mirrored direction of view.
    Phong,
}

/// The power of a highlight. The power 0 is 1 wherever the cosine is above 0, and 0 elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exponent<T> {
    /// An integer, by repeated squaring.
    Integer(u32),
    /// Any number, by its logarithm.
    Real(T),
}

/// How much a surface's own light counts against what it reflects and transmits, and both together.
///
/// A surface that shines and is coloured as well adds up to more light than either alone. Choose the `ratio` for the
/// look first, then the `brightness`; the one leaves the other as it is.
///
/// own light · brightness·(1 − ratio) + branches · brightness·ratio
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance<T> {
    /// From 0 for the surface's own light alone (body and highlight) to 1 for reflected and transmitted light alone.
    pub ratio: T,
    /// Factor on all of it; ratio·brightness is at most 1.
    pub brightness: T,
}

impl<T: Real> Material<T> {
    /// A diffuse body of one colour: k_d = 1, no ambient light.
    pub const fn matte(color: Rgb<T>) -> Self {
        Self::patterned(Pattern::Solid(color))
    }

    /// A diffuse body with a pattern: k_d = 1, no ambient light.
    pub const fn patterned(color: Pattern<T>) -> Self {
        let body = Body { color, emission: T::ZERO, ambient: T::ZERO, diffuse: T::ONE };
        Self { body: Some(body), ..Self::bare(Interface::Opaque) }
    }

    /// A mirror of constant k_r without a body.
    pub const fn mirror(reflected: Rgb<T>) -> Self {
        Self::bare(Interface::Mirror { reflected })
    }

    /// A metal of reflectance R₀ at normal incidence.
    pub const fn metal(r0: Rgb<T>) -> Self {
        Self::bare(Interface::Metal { r0 })
    }

    /// A metal of complex index of refraction η + ik.
    pub const fn conductor(index: Rgb<T>, extinction: Rgb<T>) -> Self {
        Self::bare(Interface::Conductor { index, extinction, film: None })
    }

    /// Clear glass, water and the like, of the given index of refraction.
    pub const fn dielectric(index: T) -> Self {
        Self::transparent(Medium::new(index))
    }

    /// A dielectric surface with a medium inside.
    pub const fn transparent(medium: Medium<T>) -> Self {
        Self::bare(Interface::Dielectric { medium, film: None })
    }

    /// An interface alone.
    const fn bare(interface: Interface<T>) -> Self {
        Self { body: None, highlight: None, interface, balance: None }
    }

    /// The same material with other shares of emission, ambient and diffuse light, if it has a body.
    #[must_use]
    pub const fn with_shares(self, emission: T, ambient: T, diffuse: T) -> Self {
        match self.body {
            Some(body) => Self { body: Some(Body { emission, ambient, diffuse, ..body }), ..self },
            None => self,
        }
    }

    /// The same material with a Blinn-Phong highlight of an integer exponent.
    #[must_use]
    pub const fn with_highlight(self, color: Rgb<T>, exponent: u32) -> Self {
        let highlight = Highlight { color, lobe: Lobe::Blinn, exponent: Exponent::Integer(exponent) };
        Self { highlight: Some(highlight), ..self }
    }

    /// The same material with another interface.
    #[must_use]
    pub const fn with_interface(self, interface: Interface<T>) -> Self {
        Self { interface, ..self }
    }

    /// The same material under a clear coat of the given index of refraction.
    #[must_use]
    pub const fn with_coat(self, index: T) -> Self {
        self.with_interface(Interface::Coat { index })
    }

    /// The same dielectric or conductor with a thin film on it. Other materials stay as they are.
    #[must_use]
    pub const fn with_film(self, film: Film<T>) -> Self {
        let film = Some(film);
        match self.interface {
            Interface::Conductor { index, extinction, .. } => {
                self.with_interface(Interface::Conductor { index, extinction, film })
            }
            Interface::Dielectric { medium, .. } => self.with_interface(Interface::Dielectric { medium, film }),
            _ => self,
        }
    }

    /// The same transparent material with a [`priority`](Medium::priority) where it overlaps others. Opaque ones stay as
    /// they are.
    #[must_use]
    pub const fn with_priority(self, priority: u8) -> Self {
        match self.interface {
            Interface::Dielectric { medium, film } => {
                let medium = medium.with_priority(priority);
                self.with_interface(Interface::Dielectric { medium, film })
            }
            Interface::Constant { reflected, transmitted, medium } => {
                let medium = medium.with_priority(priority);
                self.with_interface(Interface::Constant { reflected, transmitted, medium })
            }
            _ => self,
        }
    }

    /// The same material with its own light set against its branches: see [`Balance`].
    #[must_use]
    pub const fn with_balance(self, ratio: T, brightness: T) -> Self {
        Self { balance: Some(Balance { ratio, brightness }), ..self }
    }

    /// The same material in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Material<U> {
        Material {
            body: self.body.map(|body| Body {
                color: body.color.map(&f),
                emission: f(body.emission),
                ambient: f(body.ambient),
                diffuse: f(body.diffuse),
            }),
            highlight: self.highlight.map(|highlight| Highlight {
                color: highlight.color.map(&f),
                lobe: highlight.lobe,
                exponent: match highlight.exponent {
                    Exponent::Integer(n) => Exponent::Integer(n),
                    Exponent::Real(s) => Exponent::Real(f(s)),
                },
            }),
            interface: self.interface.map(&f),
            balance: self.balance.map(|balance| Balance { ratio: f(balance.ratio), brightness: f(balance.brightness) }),
        }
    }
}
