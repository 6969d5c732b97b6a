//! The colour of a coating, in three ways.

use super::incidence::{Incidence, Stack};
use super::series::{Harmonics, Series};
use crate::math::{Complex, Real, Rgb};
use crate::optics::spectrum::{Band, MEAN_WAVELENGTHS, WAVELENGTHS, coherence_of};

/// A film of one index of refraction on a base.
///
/// Its reflectance is linear Rec. 709 of unpolarised light, with equal energy as white, and comes unclipped:
/// a saturated colour lies outside of the primaries and has a channel a little below 0 or above 1. What only depends on the angle is computed once, also for the base when it is the same in all channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coating<T> {
    /// Index of refraction of the medium that the light comes from.
    pub outer: T,
    /// Index of refraction of the film.
    pub film: T,
    /// η + ik of what is under the film, for each channel; k ≥ 0, and zero in a dielectric.
    pub base: Rgb<Complex<T>>,
}

/// The terms of the series in [`Coating::by_table`]; what comes after is continued in closed form.
const TERMS: u32 = 12;

impl<T: Real> Coating<T> {
    /// The reflectance at one wavelength per channel, [`WAVELENGTHS`], over that channel's base.
    ///
    /// `cosine` is that of the angle of incidence and `thickness` in nanometres. The cheapest way, and far from
    /// what is seen: white light's fringes fade as a film gets thicker, and these do not.
    #[must_use]
    pub fn by_wavelengths(&self, cosine: T, thickness: T) -> Rgb<T> {
        self.at_wavelengths(&Incidence::new(self.outer, self.film, cosine), thickness, WAVELENGTHS)
    }

    /// The reflectance summed over `bands`, see [`bands`](crate::optics::bands).
    ///
    /// `cosine` and `thickness` as in [`by_wavelengths`](Self::by_wavelengths). The base's index is linear in the
    /// wavelength between [`WAVELENGTHS`] and constant outside of them.
    #[must_use]
    pub fn by_bands(&self, cosine: T, thickness: T, bands: &[Band]) -> Rgb<T> {
        let incidence = Incidence::new(self.outer, self.film, cosine);
        let same =
            (self.base.r == self.base.g && self.base.g == self.base.b).then(|| Stack::new(&incidence, self.base.g));
        let mut sum = Rgb::BLACK;
        for band in bands {
            let wavelength = T::from_f32(band.wavelength);
            let stack = match same {
                Some(stack) => stack,
                None => Stack::new(&incidence, self.base_at(wavelength)),
            };
            sum += band.weight.map(T::from_f32) * stack.unpolarised(&incidence.wave(thickness, wavelength));
        }
        sum
    }

    /// The reflectance by its Fourier series in the film's path difference D = 2·n₁·d·cos θ₁, R = a₀ + 2·Re Σ aₘ·C(mD),
    /// where C is the eye's [`coherence`](crate::optics::coherence).
    ///
    /// `cosine` and `thickness` as in [`by_wavelengths`](Self::by_wavelengths). For indices that are the same at all
    /// wavelengths of a channel it is exact up to the table and the last terms. A film in which the wave is evanescent
    /// has no fringes, and is computed at the mean wavelength of each channel.
    #[must_use]
    pub fn by_table(&self, cosine: T, thickness: T) -> Rgb<T> {
        let incidence = Incidence::new(self.outer, self.film, cosine);
        if incidence.evanescent {
            return self.at_wavelengths(&incidence, thickness, MEAN_WAVELENGTHS);
        }
        // Of wide products, so that a film of a thousand nanometres has room in fixed point too.
        let half = incidence.film_normal.product(thickness);
        let path = half + half;
        let turns = |wavelength: f32| T::ratio(path, T::from_f32(wavelength).widened());
        let series = self.per_channel(|base| Series::new(&incidence, &Stack::new(&incidence, base)));
        let mut r = Harmonics::new(series.r, turns(WAVELENGTHS.r));
        let mut g = Harmonics::new(series.g, turns(WAVELENGTHS.g));
        let mut b = Harmonics::new(series.b, turns(WAVELENGTHS.b));
        // The square of the next term, which the closed form continues well enough when it is below 1e-2.
        let ratio = series
            .r
            .largest_ratio_squared()
            .max(series.g.largest_ratio_squared())
            .max(series.b.largest_ratio_squared());
        let mut rest = T::ONE;
        let mut distance = T::NOTHING;
        for _ in 0..TERMS {
            distance = distance + path;
            rest *= ratio;
            let Some(envelope) = coherence_of(distance) else { break };
            r.add(envelope.r);
            g.add(envelope.g);
            b.add(envelope.b);
            if rest < T::from_f32(1e-4) {
                break;
            }
        }
        Rgb::new(r.reflectance(), g.reflectance(), b.reflectance())
    }

    fn at_wavelengths(&self, incidence: &Incidence<T>, thickness: T, wavelengths: Rgb<f32>) -> Rgb<T> {
        let stacks = self.per_channel(|base| Stack::new(incidence, base));
        let at = |stack: Stack<T>, wavelength| stack.unpolarised(&incidence.wave(thickness, T::from_f32(wavelength)));
        Rgb::new(at(stacks.r, wavelengths.r), at(stacks.g, wavelengths.g), at(stacks.b, wavelengths.b))
    }

    /// `f` of each channel's base, computed once for channels that are the same.
    fn per_channel<U: Copy>(&self, f: impl Fn(Complex<T>) -> U) -> Rgb<U> {
        let Rgb { r: red, g: green, b: blue } = self.base;
        let r = f(red);
        let g = if green == red { r } else { f(green) };
        let b = if blue == green { g } else { f(blue) };
        Rgb::new(r, g, b)
    }

    fn base_at(&self, wavelength: T) -> Complex<T> {
        let Rgb { r: red, g: green, b: blue } = WAVELENGTHS.map(T::from_f32);
        let clamp = |t: T| t.max(T::ZERO).min(T::ONE);
        if wavelength < green {
            self.base.b.mix(self.base.g, clamp((wavelength - blue) / (green - blue)))
        } else {
            self.base.g.mix(self.base.r, clamp((wavelength - green) / (red - green)))
        }
    }
}
