//! Dispersion: the index of refraction as a function of wavelength.
//!
//! The formulas are for constants: all is in `f64` and can be evaluated by the compiler.

use super::WAVELENGTHS;
use crate::math::{Rgb, square_root_constant};

/// Cauchy's formula n = A + B/λ² + C/λ⁴ with λ in micrometres (Cauchy 1836), for transparent media in visible light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cauchy {
    /// A.
    pub a: f64,
    /// B in µm².
    pub b: f64,
    /// C in µm⁴; zero in the formula of two terms.
    pub c: f64,
}

impl Cauchy {
    /// The index of refraction at a wavelength in nanometres.
    #[must_use]
    pub const fn index(self, wavelength_nm: f64) -> f64 {
        let square = square_of_micrometres(wavelength_nm);
        self.a + (self.b + self.c / square) / square
    }

    /// The indices of refraction at the wavelengths of the three channels: 611.4, 549.1 and 464.2 nm.
    #[must_use]
    pub const fn channels(self) -> Rgb<f32> {
        Rgb::new(
            self.index(WAVELENGTHS.r as f64) as f32,
            self.index(WAVELENGTHS.g as f64) as f32,
            self.index(WAVELENGTHS.b as f64) as f32,
        )
    }
}

/// Sellmeier's formula n² = 1 + Σ Bᵢλ²/(λ² − Cᵢ) with λ in micrometres (Sellmeier 1871), in which makers of glass
/// publish their measurements. A medium with fewer than three terms has zeros for the rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sellmeier {
    /// Bᵢ, the strengths of the resonances.
    pub b: [f64; 3],
    /// Cᵢ, the squared wavelengths of the resonances in µm².
    pub c: [f64; 3],
}

impl Sellmeier {
    /// The index of refraction at a wavelength in nanometres.
    ///
    /// Next to a resonance the formula has no meaning; where it gives no real index, this is zero.
    #[must_use]
    pub const fn index(self, wavelength_nm: f64) -> f64 {
        let square = square_of_micrometres(wavelength_nm);
        let [b1, b2, b3] = self.b;
        let [c1, c2, c3] = self.c;
        square_root_constant(1.0 + square * (b1 / (square - c1) + b2 / (square - c2) + b3 / (square - c3)))
    }

    /// The indices of refraction at the wavelengths of the three channels: 611.4, 549.1 and 464.2 nm.
    #[must_use]
    pub const fn channels(self) -> Rgb<f32> {
        Rgb::new(
            self.index(WAVELENGTHS.r as f64) as f32,
            self.index(WAVELENGTHS.g as f64) as f32,
            self.index(WAVELENGTHS.b as f64) as f32,
        )
    }
}

const fn square_of_micrometres(nanometres: f64) -> f64 {
    let micrometres = nanometres / 1000.0;
    micrometres * micrometres
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::materials::dispersive::{ACRYLIC, CROWN_GLASS, DIAMOND, FLINT_GLASS, FUSED_QUARTZ, ICE, WATER};

    /// Fraunhofer's lines in nanometres: helium's d, hydrogen's F and C.
    const D: f64 = 587.5618;
    const F: f64 = 486.1327;
    const C: f64 = 656.2725;

    /// n_d, n_F, n_C and the Abbe number from the data sheets of Schott (2017) for N-BK7 and SF10, and from Malitson
    /// (1965) for fused silica, which print five decimals of the indices.
    #[test]
    fn glasses_have_the_indices_of_their_data_sheets() {
        for (glass, [d, f, c], abbe) in [
            (CROWN_GLASS, [1.51680, 1.52238, 1.51432], 64.17),
            (FLINT_GLASS, [1.72825, 1.74648, 1.72085], 28.41),
            (FUSED_QUARTZ, [1.45846, 1.46313, 1.45637], 67.82),
        ] {
            for (wavelength, published) in [(D, d), (F, f), (C, c)] {
                let index = glass.index(wavelength);
                assert!((index - published).abs() < 6e-6, "{wavelength}: {index} {published}");
            }
            let number = (glass.index(D) - 1.0) / (glass.index(F) - glass.index(C));
            assert!((number - abbe).abs() < 0.006, "{number} {abbe}");
        }
    }

    /// Gemmology gives the dispersion of diamond as 0.044 between Fraunhofer's lines B and G.
    #[test]
    fn diamond_has_its_fire() {
        assert!((DIAMOND.index(430.8) - DIAMOND.index(686.7) - 0.044).abs() < 0.0005);
    }

    #[test]
    fn channels_are_in_order() {
        for Rgb { r, g, b } in [
            CROWN_GLASS.channels(),
            FLINT_GLASS.channels(),
            FUSED_QUARTZ.channels(),
            DIAMOND.channels(),
            WATER.channels(),
            ICE.channels(),
            ACRYLIC.channels(),
        ] {
            assert!(1.3 < r && r < g && g < b && b < 2.5, "{r} {g} {b}");
        }
        const CHANNELS: Rgb<f32> = CROWN_GLASS.channels();
        assert!((CHANNELS.r - 1.515_86).abs() < 1e-5);
        assert!((CHANNELS.g - 1.518_57).abs() < 1e-5);
        assert!((CHANNELS.b - 1.524_08).abs() < 1e-5);
    }

    #[test]
    fn there_is_no_index_inside_a_resonance() {
        let medium = Sellmeier { b: [1.0, 0.0, 0.0], c: [0.25, 0.0, 0.0] };
        assert_eq!(medium.index(490.0), 0.0);
        assert_eq!(medium.index(0.0), 0.0);
    }
}
