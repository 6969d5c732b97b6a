//! Quadrature of the visible spectrum.

use super::observer;
use crate::math::Rgb;

/// A sample of the visible spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// In nanometres.
    pub wavelength: f32,
    /// What one unit of light here adds to the linear colour. Some weights are negative: pure spectral colours lie
    /// outside of the primaries of Rec. 709.
    pub weight: Rgb<f32>,
}

/// Where the bands lie, in nanometres. The tails outside hold at most 0.6 % of a channel's white, and would
/// spread the bands over nearly half as much again.
const RANGE: (f64, f64) = (400.0, 710.0);

/// `N` bands, from short to long waves, whose weights add up to exactly 1 in each channel, in this order and in `f32`.
///
/// The bands are equally spaced in wavenumber, 1/λ, in which the phase of a film is linear: a sum over them is a
/// trapezoidal rule for a Fourier integral, which has nearly no error until the film's path difference D and its
/// harmonics mD near the inverse of the spacing.
///
/// This is for constants, `const BANDS: [Band; 38] = bands();`, and computes in `f64`.
#[must_use]
#[allow(clippy::indexing_slicing)] // All indices are below the lengths, which are constants.
pub const fn bands<const N: usize>() -> [Band; N] {
    let mut wavelengths = [0.0; N];
    let mut weights = [[0.0; N]; 3];
    let (shortest, longest) = RANGE;
    let mut i = 0;
    while i < N {
        let t = (i as f64 + 0.5) / N as f64;
        let wavelength = 1.0 / ((1.0 - t) / shortest + t / longest);
        wavelengths[i] = wavelength as f32;
        let response = observer::response_at(wavelength);
        let mut channel = 0;
        while channel < 3 {
            // Equal energy for each wavelength, while the bands are equal in wavenumber: dλ = −λ² d(1/λ).
            weights[channel][i] = response[channel] * wavelength * wavelength;
            channel += 1;
        }
        i += 1;
    }
    let (r, g, b) = (normalised(&weights[0]), normalised(&weights[1]), normalised(&weights[2]));
    let mut bands = [Band { wavelength: 0.0, weight: Rgb::new(0.0, 0.0, 0.0) }; N];
    i = 0;
    while i < N {
        bands[i] = Band { wavelength: wavelengths[i], weight: Rgb::new(r[i], g[i], b[i]) };
        i += 1;
    }
    bands
}

/// The weights divided by their sum, and rounded so that the `f32` add up to 1 in their order.
#[allow(clippy::indexing_slicing)] // As above.
const fn normalised<const N: usize>(weights: &[f64; N]) -> [f32; N] {
    let mut sum = 0.0;
    let mut i = 0;
    while i < N {
        sum += weights[i];
        i += 1;
    }
    let mut rounded = [0.0; N];
    let mut total = 0.0;
    i = 0;
    while i < N {
        // The last takes what rounding has left over. The difference is exact.
        rounded[i] = if i + 1 == N { 1.0 - total } else { (weights[i] / sum) as f32 };
        total += rounded[i];
        i += 1;
    }
    rounded
}

#[cfg(test)]
mod tests {
    use super::*;

    fn white(bands: &[Band]) -> Rgb<f32> {
        bands.iter().fold(Rgb::BLACK, |sum, band| sum + band.weight)
    }

    #[test]
    fn equal_energy_is_exactly_white() {
        const FEW: [Band; 3] = bands();
        assert_eq!(white(&FEW), Rgb::WHITE);
        assert_eq!(white(&bands::<8>()), Rgb::WHITE);
        assert_eq!(white(&bands::<12>()), Rgb::WHITE);
        assert_eq!(white(&bands::<16>()), Rgb::WHITE);
        assert_eq!(white(&bands::<24>()), Rgb::WHITE);
        assert_eq!(white(&bands::<38>()), Rgb::WHITE);
        assert_eq!(white(&bands::<64>()), Rgb::WHITE);
        assert!(bands::<0>().is_empty());
    }

    #[test]
    fn wavenumbers_are_equally_spaced() {
        let bands = bands::<24>();
        let step = 1.0 / 400.0 - 1.0 / 710.0;
        for pair in bands.windows(2) {
            let difference = 1.0 / f64::from(pair[0].wavelength) - 1.0 / f64::from(pair[1].wavelength);
            assert!((difference * 24.0 / step - 1.0).abs() < 1e-4);
        }
    }
}
