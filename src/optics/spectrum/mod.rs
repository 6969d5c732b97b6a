//! From spectra to linear colour: a few wavelengths, a quadrature, a table.
//!
//! Everywhere light of equal energy at all wavelengths is white, (1, 1, 1): a reflectance that is the same at all
//! wavelengths is a grey.

mod bands;
mod coherence;
mod observer;

pub use bands::{Band, bands};
pub(super) use coherence::coherence_of;
pub use coherence::{COHERENCE_LENGTH, coherence};

use crate::math::Rgb;

/// One wavelength for each channel, in nanometres: the dominant wavelengths of the Rec. 709 primaries.
///
/// They are where the lines from D65 through the chromaticities of ITU-R BT.709-6 meet the spectrum locus of the CIE
/// 1931 observer, to within 0.2 nm.
pub const WAVELENGTHS: Rgb<f32> = Rgb::new(611.4, 549.1, 464.2);

/// The mean wavelength of each channel, over wavenumbers, in nanometres.
///
/// Here, and not at the dominant wavelength, one sample gives the channel of a spectrum that is linear in the
/// wavenumber: the negative part of a channel's weights pushes its mean away from the other channels.
pub(super) const MEAN_WAVELENGTHS: Rgb<f32> =
    Rgb::new(mean_wavelength(0) as f32, mean_wavelength(1) as f32, mean_wavelength(2) as f32);

#[allow(clippy::indexing_slicing)] // In constant evaluation only.
const fn mean_wavelength(channel: usize) -> f64 {
    let (mut white, mut wavenumber) = (0.0, 0.0);
    let mut row = 0;
    while row < observer::ROWS {
        let weight = observer::response(row)[channel];
        white += weight;
        wavenumber += weight / (observer::FIRST + observer::STEP * row as f64);
        row += 1;
    }
    white / wavenumber
}
