//! The Fourier series of the Airy sum.
//!
//! With the Fresnel amplitudes r₁ (real) and r₂ of the film's two faces and the phase φ of a round trip in the film,
//! R = 1 − T·(1 + 2·Re Σ_{m≥1} (−r₁r₂)^m·e^{imφ}), T = (1 − r₁²)(1 − |r₂|²)/(1 − |r₁r₂|²). It is the Poisson kernel;
//! Belcour and Barla (2017) give the same in other terms.

use super::incidence::{Admittances, Incidence, Stack};
use crate::math::{Complex, Real, sin_cos_turns};

/// The coefficients of one polarisation.
#[derive(Clone, Copy)]
struct Coefficients<T> {
    /// T
    mean: T,
    /// −r₁·r₂
    ratio: Complex<T>,
}

/// The coefficients of both polarisations; they do not depend on the film's thickness.
#[derive(Clone, Copy)]
pub(super) struct Series<T> {
    s: Coefficients<T>,
    p: Coefficients<T>,
}

/// The series of one channel as it is summed.
pub(super) struct Harmonics<T> {
    series: Series<T>,
    s: Powers<T>,
    p: Powers<T>,
    envelope: Complex<T>,
    previous_envelope: Complex<T>,
}

/// Σ (ratio·e^{iφ})^m·C(mD)
struct Powers<T> {
    ratio: Complex<T>,
    power: Complex<T>,
    sum: Complex<T>,
}

impl<T: Real> Series<T> {
    /// In a film that is not evanescent.
    pub(super) fn new(incidence: &Incidence<T>, stack: &Stack<T>) -> Self {
        let b = incidence.film_normal;
        Self { s: Coefficients::new(b, &stack.s), p: Coefficients::new(b, &stack.p) }
    }

    /// The larger |r₁r₂|² of the two polarisations.
    #[inline]
    pub(super) fn largest_ratio_squared(&self) -> T {
        self.s.ratio.norm_squared().max(self.p.ratio.norm_squared())
    }
}

impl<T: Real> Coefficients<T> {
    fn new(b: T, admittances: &Admittances<T>) -> Self {
        let &Admittances { outer: a, base: g } = admittances;
        let four = T::TWO + T::TWO;
        let first_sum = a + b;
        let first = (a - b) / first_sum;
        let second_sum = Complex::real(b) + g;
        let second = (Complex::real(b) - g) / second_sum;
        // 1 − r₁² and 1 − |r₂|² without cancellation, and from them 1 − |r₁r₂|².
        let first_passes = T::ratio((four * a).product(b), first_sum.product(first_sum));
        let second_passes = T::ratio((four * b).product(g.re), second_sum.square());
        let whole = first_passes + first * first * second_passes;
        // Zero only at grazing incidence, where all is reflected.
        let mean = if whole > T::ZERO { first_passes * second_passes / whole } else { T::ZERO };
        Self { mean, ratio: second * -first }
    }
}

impl<T: Real> Harmonics<T> {
    /// `turns` is the path difference in wavelengths of the channel's carrier.
    pub(super) fn new(series: Series<T>, turns: T) -> Self {
        let (sine, cosine) = sin_cos_turns(turns);
        let carrier = Complex::new(cosine, sine);
        let powers = |ratio| Powers { ratio: ratio * carrier, power: Complex::ONE, sum: Complex::ZERO };
        Self {
            series,
            s: powers(series.s.ratio),
            p: powers(series.p.ratio),
            envelope: Complex::ONE,
            previous_envelope: Complex::ONE,
        }
    }

    /// The next term, with the envelope C(mD).
    pub(super) fn add(&mut self, envelope: Complex<T>) {
        self.s.add(envelope);
        self.p.add(envelope);
        self.previous_envelope = self.envelope;
        self.envelope = envelope;
    }

    /// The unpolarised reflectance.
    pub(super) fn reflectance(self) -> T {
        let last = self.envelope;
        // The envelope is continued as a geometric series, which never grows.
        let decay = if last.norm_squared() < self.previous_envelope.norm_squared() {
            last / self.previous_envelope
        } else {
            Complex::ONE
        };
        let of = |mean: T, powers: &Powers<T>| {
            T::ONE - mean * (T::ONE + T::TWO * (powers.sum + powers.rest(last, decay)).re)
        };
        T::HALF * (of(self.series.s.mean, &self.s) + of(self.series.p.mean, &self.p))
    }
}

impl<T: Real> Powers<T> {
    fn add(&mut self, envelope: Complex<T>) {
        self.power = self.power * self.ratio;
        self.sum = self.sum + self.power * envelope;
    }

    /// The terms that were not added, in closed form.
    fn rest(&self, envelope: Complex<T>, decay: Complex<T>) -> Complex<T> {
        let x = self.ratio * decay;
        let remaining = Complex::ONE - x;
        if remaining.norm_squared() > T::ZERO { self.power * envelope * (x / remaining) } else { Complex::ZERO }
    }
}
