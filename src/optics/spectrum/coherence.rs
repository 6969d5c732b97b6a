//! How far white light interferes with itself: the Fourier transform of the eye.

use super::{WAVELENGTHS, observer};
use crate::math::{Complex, Real, Rgb, sin_cos_constant};

/// The path difference in nanometres from which on [`coherence`] is zero.
pub const COHERENCE_LENGTH: f32 = STEP * (ENTRIES - 1) as f32;

const ENTRIES: usize = 64;
/// Between entries, in nanometres.
const STEP: f32 = 128.0;

/// 1536 bytes, which are only there in programs that call [`coherence`].
static ENVELOPE: [Rgb<Complex<f32>>; ENTRIES] = envelope();

/// The coherence of each channel at a path difference of `path` ≥ 0 nanometres, without its carrier; `None` where there
/// is none left.
///
/// It is the envelope C in C(D)·e^{2πi·D/λ₀} = ∫ w(λ)·e^{2πi·D/λ} dλ, where w is the channel's weight of wavelengths,
/// with ∫ w dλ = 1, and λ₀ its entry in [`WAVELENGTHS`]. So a film's cosine fringe cos(2πD/λ), seen by the eye, is
/// Re C(D)·e^{2πi·D/λ₀} (after Belcour and Barla 2017, *A Practical Extension to Microfacet Theory for the Modeling of
/// Varying Iridescence*, with a table in the place of fitted Gaussians).
///
/// The envelope changes slowly, so a coarse table with linear interpolation is within 5e-3 of it, up to the last step,
/// along which it is led to zero.
#[inline]
#[must_use]
pub fn coherence<T: Real>(path: T) -> Option<Rgb<Complex<T>>> {
    coherence_of(path.widened())
}

/// The same, of a path difference that may be a sum of products.
#[inline]
pub(in crate::optics) fn coherence_of<T: Real>(path: T::Wide) -> Option<Rgb<Complex<T>>> {
    let position = T::ratio(path, T::from_f32(STEP).widened());
    let entry = position.floor();
    // Out of range, not a number and below zero all end at no entry or at a harmless one.
    let index = entry.to_f32() as usize;
    let (low, high) = (ENVELOPE.get(index)?, ENVELOPE.get(index + 1)?);
    let t = position - entry;
    let between = |low: Complex<f32>, high: Complex<f32>| wide(low).mix(wide(high), t);
    Some(Rgb::new(between(low.r, high.r), between(low.g, high.g), between(low.b, high.b)))
}

#[inline]
fn wide<T: Real>(z: Complex<f32>) -> Complex<T> {
    Complex::new(T::from_f32(z.re), T::from_f32(z.im))
}

#[allow(clippy::indexing_slicing)] // In constant evaluation only, as in the next.
const fn envelope() -> [Rgb<Complex<f32>>; ENTRIES] {
    let r = channel(0, WAVELENGTHS.r as f64);
    let g = channel(1, WAVELENGTHS.g as f64);
    let b = channel(2, WAVELENGTHS.b as f64);
    let zero = Complex::new(0.0, 0.0);
    let mut envelope = [Rgb::new(zero, zero, zero); ENTRIES];
    let mut i = 0;
    while i < ENTRIES - 1 {
        envelope[i] = Rgb::new(r[i], g[i], b[i]);
        i += 1;
    }
    envelope
}

/// Σ w·e^{2πi·D·(1/λ − 1/λ₀)} at all path differences D of the table.
#[allow(clippy::indexing_slicing)]
const fn channel(channel: usize, carrier: f64) -> [Complex<f32>; ENTRIES] {
    let mut sums = [(0.0, 0.0); ENTRIES];
    let mut row = 0;
    while row < observer::ROWS {
        let weight = observer::response(row)[channel];
        let wavelength = observer::FIRST + observer::STEP * row as f64;
        let turns = STEP as f64 * (1.0 / wavelength - 1.0 / carrier);
        // At most a seventh of a turn. From one entry to the next the phasor turns by the same angle.
        let (sine, cosine) = sin_cos_constant(turns * core::f64::consts::TAU);
        let (mut re, mut im) = (weight, 0.0);
        let mut i = 0;
        while i < ENTRIES {
            sums[i] = (sums[i].0 + re, sums[i].1 + im);
            (re, im) = (re * cosine - im * sine, re * sine + im * cosine);
            i += 1;
        }
        row += 1;
    }
    let white = sums[0].0;
    let mut rounded = [Complex::new(0.0, 0.0); ENTRIES];
    let mut i = 0;
    while i < ENTRIES {
        rounded[i] = Complex::new((sums[i].0 / white) as f32, (sums[i].1 / white) as f32);
        i += 1;
    }
    rounded
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral, by sums of its own in steps of 0.5 nm.
    fn exact(channel: usize, carrier: f64, path: f64) -> Complex<f64> {
        let (mut sum, mut white) = (Complex::ZERO, 0.0);
        for i in 0..=800 {
            let wavelength = 380.0 + f64::from(i) * 0.5;
            let weight = observer::response_at(wavelength)[channel];
            let phase = core::f64::consts::TAU * path * (1.0 / wavelength - 1.0 / carrier);
            sum = sum + Complex::new(phase.cos(), phase.sin()) * weight;
            white += weight;
        }
        sum * (1.0 / white)
    }

    #[test]
    fn the_table_is_near_the_integral() {
        let mut worst = 0.0_f64;
        for i in 0..793 {
            let path = f64::from(i) * 10.0;
            let envelope = coherence(path).unwrap();
            for (channel, (value, carrier)) in
                [(envelope.r, WAVELENGTHS.r), (envelope.g, WAVELENGTHS.g), (envelope.b, WAVELENGTHS.b)]
                    .into_iter()
                    .enumerate()
            {
                worst = worst.max((value - exact(channel, f64::from(carrier), path)).norm_squared().sqrt());
            }
        }
        assert!(worst < 5e-3, "{worst}");
    }

    #[test]
    fn coherence_begins_at_one_and_ends() {
        assert_eq!(coherence(0.0_f32), Some(Rgb::grey(Complex::ONE)));
        assert_eq!(coherence(COHERENCE_LENGTH), None);
        assert_eq!(coherence(f32::INFINITY), None);
        let end = coherence(COHERENCE_LENGTH.next_down()).unwrap();
        assert!([end.r, end.g, end.b].into_iter().all(|z| z.norm_squared() < 1e-6));
    }

    #[test]
    fn size_of_the_table() {
        assert_eq!(size_of_val(&ENVELOPE), 1536);
    }
}
