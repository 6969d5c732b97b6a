//! Thin films: coatings that are about as thick as a wave of light is long.

use crate::math::{Real, Vec3};
use crate::optics::Band;

/// A thin film on a surface: soap, oil, an oxide. Light reflected by its two faces interferes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Film<T> {
    /// Index of refraction of the film.
    pub index: T,
    /// Thickness in nanometres, whatever the scene's unit.
    pub thickness: Thickness<T>,
    /// How a colour is made of the reflectance at every wavelength.
    pub spectrum: Spectrum,
}

/// The thickness of a film over its surface, in nanometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thickness<T> {
    /// The same everywhere.
    Uniform(T),
    /// From one thickness to another along an axis, t = (p − origin)·axis held between 0 and 1: a film that drains.
    Gradient {
        /// Where t ≤ 0.
        from: T,
        /// Where t ≥ 1.
        to: T,
        /// Where t = 0.
        origin: Vec3<T>,
        /// Direction of the change, with the length 1/(distance over which it happens).
        axis: Vec3<T>,
    },
    /// By the distance from a point, t = |p − center|/radius held between 0 and 1: a drop that spreads.
    Radial {
        /// At the centre.
        from: T,
        /// Where t ≥ 1.
        to: T,
        /// Where t = 0.
        center: Vec3<T>,
        /// Where t = 1, in scene units.
        radius: T,
    },
}

/// How the reflectance of a film, which is a function of the wavelength, becomes linear RGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spectrum {
    /// One wavelength for each channel. The least work for thin films; the fringes of thick ones never fade.
    Wavelengths,
    /// A sum over samples of the spectrum, as many as wanted: [`bands`](crate::optics::bands).
    Bands(&'static [Band]),
    /// A table of how waves of all lengths add up, by the difference of their paths: 1.5 kB of constants, for colours near
    /// those of many samples at the work of a few. It takes the index under the film as constant within each channel,
    /// while [`Bands`](Self::Bands) follow it from channel to channel, which can be seen on a metal.
    Table,
}

impl<T: Real> Film<T> {
    /// A film of the same thickness everywhere, in nanometres, coloured by the table.
    pub const fn new(index: T, thickness: T) -> Self {
        Self { index, thickness: Thickness::Uniform(thickness), spectrum: Spectrum::Table }
    }

    /// The same film with a thickness that varies.
    #[must_use]
    pub const fn with_thickness(self, thickness: Thickness<T>) -> Self {
        Self { thickness, ..self }
    }

    /// The same film, coloured in another way.
    #[must_use]
    pub const fn with_spectrum(self, spectrum: Spectrum) -> Self {
        Self { spectrum, ..self }
    }

    /// The same film in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Film<U> {
        let thickness = match self.thickness {
            Thickness::Uniform(thickness) => Thickness::Uniform(f(thickness)),
            Thickness::Gradient { from, to, origin, axis } => {
                Thickness::Gradient { from: f(from), to: f(to), origin: origin.map(&f), axis: axis.map(&f) }
            }
            Thickness::Radial { from, to, center, radius } => {
                Thickness::Radial { from: f(from), to: f(to), center: center.map(&f), radius: f(radius) }
            }
        };
        Film { index: f(self.index), thickness, spectrum: self.spectrum }
    }
}
