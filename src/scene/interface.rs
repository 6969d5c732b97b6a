//! What becomes of light at a surface, besides what the body scatters.

use super::{Film, Medium};
use crate::math::{Real, Rgb};

/// What happens to the light that does not enter the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interface<T> {
    /// No branches.
    Opaque,
    /// A reflected branch of constant weight k_r.
    Mirror {
        /// k_r per channel.
        reflected: Rgb<T>,
    },
    /// A reflected branch weighted by Schlick's approximation; a metal.
    Metal {
        /// Reflectance at normal incidence, R₀, per channel.
        r0: Rgb<T>,
    },
    /// A reflected branch weighted by the Fresnel equations for the complex index η + ik; a metal.
    /// [`materials`](crate::optics::materials) has the numbers.
    Conductor {
        /// Index of refraction η per channel.
        index: Rgb<T>,
        /// Extinction coefficient k per channel.
        extinction: Rgb<T>,
        /// An oxide on it, say.
        film: Option<Film<T>>,
    },
    /// A clear coat over the body: varnish, a wet or polished surface. It reflects as a dielectric does; the body gets
    /// the rest.
    Coat {
        /// Index of refraction of the coat.
        index: T,
    },
    /// A reflected and a transmitted branch of constant weights k_r and k_t, whatever the angle. On total internal
    /// reflection the reflected branch takes both.
    Constant {
        /// k_r per channel.
        reflected: Rgb<T>,
        /// k_t per channel.
        transmitted: Rgb<T>,
        /// What is inside.
        medium: Medium<T>,
    },
    /// A reflected branch of weight R and a transmitted one of weight 1 − R: glass, water. [`Fresnel`] says how R is
    /// computed.
    Dielectric {
        /// What is inside.
        medium: Medium<T>,
        /// A soap film, say.
        film: Option<Film<T>>,
    },
}

/// How the reflectance of dielectrics and coats is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fresnel {
    /// By the Fresnel equations, the mean over both polarisations.
    Exact,
    /// By Schlick's approximation, at the angle on the less dense side.
    Schlick,
}

impl<T> Interface<T> {
    /// What is inside, by reference and in constant evaluation.
    pub(super) const fn inside(&self) -> Option<&Medium<T>> {
        match self {
            Self::Constant { medium, .. } | Self::Dielectric { medium, .. } => Some(medium),
            _ => None,
        }
    }
}

impl<T: Real> Interface<T> {
    /// What is inside, where light can go inside.
    pub fn medium(&self) -> Option<Medium<T>> {
        match *self {
            Self::Constant { medium, .. } | Self::Dielectric { medium, .. } => Some(medium),
            _ => None,
        }
    }

    /// The same interface in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Interface<U> {
        match *self {
            Self::Opaque => Interface::Opaque,
            Self::Mirror { reflected } => Interface::Mirror { reflected: reflected.map(f) },
            Self::Metal { r0 } => Interface::Metal { r0: r0.map(f) },
            Self::Conductor { index, extinction, film } => Interface::Conductor {
                index: index.map(&f),
                extinction: extinction.map(&f),
                film: film.map(|film| film.map(&f)),
            },
            Self::Coat { index } => Interface::Coat { index: f(index) },
            Self::Constant { reflected, transmitted, medium } => Interface::Constant {
                reflected: reflected.map(&f),
                transmitted: transmitted.map(&f),
                medium: medium.map(&f),
            },
            Self::Dielectric { medium, film } => {
                Interface::Dielectric { medium: medium.map(&f), film: film.map(|film| film.map(&f)) }
            }
        }
    }
}
