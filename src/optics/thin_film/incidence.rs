//! The closed form of the Airy sum, in parts that change with the angle, the base and the wavelength.
//!
//! With the normal wavenumbers q = n·cos θ of the three media, as admittances a, b, g of one polarisation (q for s,
//! q/n² for p), and the phase δ of one passage through the film, the Airy sum |(r₁ + r₂e^{2iδ})/(1 + r₁r₂e^{2iδ})|² is
//!
//! R = |(a − g)·cos δ − i(a·g·sin δ/b − b·sin δ)|² / |(a + g)·cos δ − i(a·g·sin δ/b + b·sin δ)|²
//!
//! (Born and Wolf, *Principles of Optics*, 7th edition, §1.6: the characteristic matrix). In this form, b = 0 is no
//! exception and an evanescent film needs no complex numbers: b² < 0 leaves cos δ, sin δ/b and b·sin δ real.

use crate::math::{Complex, Real, sin_cos_turns};

/// What depends on the angle and on no wavelength.
pub(super) struct Incidence<T> {
    /// Index of refraction of the outer medium and of the film.
    pub(super) outer: T,
    pub(super) film: T,
    /// n₀·cos θ₀
    pub(super) outer_normal: T,
    /// |n₁·cos θ₁|, which is imaginary when the wave is evanescent in the film.
    pub(super) film_normal: T,
    pub(super) evanescent: bool,
}

/// The film at one wavelength, up to a common factor of the three.
pub(super) struct Wave<T> {
    /// cos δ
    cosine: T,
    /// sin δ/b
    quotient: T,
    /// b·sin δ
    product: T,
}

/// The admittances of outer medium and base for one polarisation, in units that make the film's n₁·cos θ₁.
#[derive(Clone, Copy)]
pub(super) struct Admittances<T> {
    pub(super) outer: T,
    pub(super) base: Complex<T>,
}

/// Both polarisations over one base.
#[derive(Clone, Copy)]
pub(super) struct Stack<T> {
    pub(super) s: Admittances<T>,
    pub(super) p: Admittances<T>,
}

impl<T: Real> Incidence<T> {
    pub(super) fn new(outer: T, film: T, cosine: T) -> Self {
        let outer_normal = outer * cosine.max(T::ZERO);
        let square = normal_squared(outer, film, outer_normal);
        let evanescent = square <= T::ZERO;
        Self { outer, film, outer_normal, film_normal: square.abs().sqrt(), evanescent }
    }

    /// `thickness` and `wavelength` in the same unit.
    pub(super) fn wave(&self, thickness: T, wavelength: T) -> Wave<T> {
        let b = self.film_normal;
        if !self.evanescent {
            let (sine, cosine) = sin_cos_turns(T::ratio(b.product(thickness), wavelength.widened()));
            return Wave { cosine, quotient: sine / b, product: sine * b };
        }
        let tau = T::from_f32(core::f32::consts::TAU);
        let per_normal = T::ratio(tau.product(thickness), wavelength.widened());
        let depth = T::held(b.product(per_normal));
        if depth < T::ONE {
            // Taylor polynomials of cosh and sinh, to 2.8e-7 at depth 1.
            let c = |n: f32| T::from_f32(1.0 / n);
            let x = depth * depth;
            let cosine = T::ONE + x * (T::HALF + x * (c(24.0) + x * (c(720.0) + x * c(40_320.0))));
            let ratio = T::ONE + x * (c(6.0) + x * (c(120.0) + x * (c(5040.0) + x * c(362_880.0))));
            return Wave { cosine, quotient: per_normal * ratio, product: -(b * depth * ratio) };
        }
        // Divided by e^depth/2, so that it ends at the film alone and not beyond the largest number.
        let echo = (-(depth + depth)).exp();
        let sine = T::ONE - echo;
        Wave { cosine: T::ONE + echo, quotient: sine / b, product: -(sine * b) }
    }
}

impl<T: Real> Stack<T> {
    pub(super) fn new(incidence: &Incidence<T>, base: Complex<T>) -> Self {
        let &Incidence { outer, film, outer_normal, .. } = incidence;
        let re = normal_squared(outer, base.re, outer_normal) - base.im * base.im;
        let im = T::TWO * (base.re * base.im);
        // Of equal media it needs no square, which would take digits along the film.
        let is_same = T::IS_FIXED && base == Complex::real(outer);
        let base_normal = if is_same { Complex::real(outer_normal) } else { Complex::new(re, im).sqrt() };
        let ratio = film / outer;
        let film_squared = film * film;
        Self {
            s: Admittances { outer: outer_normal, base: base_normal },
            p: Admittances {
                outer: ratio * ratio * outer_normal,
                base: base_normal * film_squared / Complex::new((base.re - base.im) * (base.re + base.im), im),
            },
        }
    }

    /// The mean of the two polarisations.
    pub(super) fn unpolarised(&self, wave: &Wave<T>) -> T {
        T::HALF * (self.s.reflectance(wave) + self.p.reflectance(wave))
    }
}

impl<T: Real> Admittances<T> {
    pub(super) fn reflectance(&self, wave: &Wave<T>) -> T {
        let &Wave { cosine, quotient, product } = wave;
        let Complex { re, im } = self.base;
        // In fixed point a thick film along which light goes may leave the range.
        let times = |a: T, b: T| T::held(a.product(b));
        let outer = times(self.outer, cosine.plus(times(im, quotient)));
        let base = re * cosine;
        let inside = im * cosine - product;
        let through = times(times(self.outer, re), quotient);
        let square = |x: T| x.product(x);
        let reflected = square(outer - base) + square(inside + through);
        let whole = square(outer + base) + square(inside - through);
        // The whole is zero only at grazing incidence, where all is reflected.
        if whole > T::NOTHING { T::ratio(reflected, whole).min(T::ONE) } else { T::ONE }
    }
}

/// (n·cos θ)² = n² − n₀²·sin² θ₀ for a real n, without cancellation where the indices are near.
#[inline]
fn normal_squared<T: Real>(outer: T, index: T, outer_normal: T) -> T {
    (index - outer) * (index + outer) + outer_normal * outer_normal
}
