//! The Fresnel equations: how much light an interface reflects, by angle and polarisation.

use super::refraction::{normal_part, ratio};
use crate::math::Real;

/// A share of light for each polarisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polarized<T> {
    /// Electric field perpendicular to the plane of incidence.
    pub s: T,
    /// Electric field in the plane of incidence.
    pub p: T,
}

impl<T: Real> Polarized<T> {
    /// The share of unpolarised light: the mean.
    #[inline]
    #[must_use]
    pub fn mean(self) -> T {
        (self.s + self.p) * T::HALF
    }
}

/// Reflectance between two dielectrics and cos θ₂; `None` on total internal reflection, where the reflectance is 1.
///
/// `n1` and `n2` are the indices of refraction on the side of the incident ray and behind, `cosine` is cos θ₁ from 0
/// to 1.
///
/// With n = n₂/n₁, m = n² − 1 and g = √(m + c²), the Fresnel equations (Hecht, "Optics", 4.6.2) become
/// r_s = −m/(c + g)² and r_p = (n²c − g)/(n²c + g), n²c − g = m(c(c + g) − 1)/(c + g), and cos θ₂ = g/n. No two nearly
/// equal numbers are subtracted but in the radicand near the critical angle, which takes twice the digits there. In `f32`
/// the reflectance is within 1e-6, and within 2e-3 for cosines up to 1e-3 from the critical one, where the last bit of
/// the cosine counts as much.
#[must_use]
pub fn fresnel_dielectric<T: Real>(n1: T, n2: T, cosine: T) -> Option<(Polarized<T>, T)> {
    let (n, m) = ratio(n1, n2);
    if m == T::ZERO {
        // Between equal media nothing is reflected and nothing bent, not even along the interface.
        return Some((Polarized { s: T::ZERO, p: T::ZERO }, cosine));
    }
    let g = normal_part(n1, n2, (n, m), cosine)?;
    let sum = cosine + g;
    let (s, dense) = (m / (sum * sum), n * n * cosine);
    // Of nearly equal indices the difference n²c − g would lose its digits.
    let difference = if m.abs() < T::HALF { m * (cosine * sum - T::ONE) / sum } else { dense - g };
    let p = difference / (dense + g);
    // Along the interface both are 1, and rounding must not take them past it.
    let square = |amplitude: T| {
        let held = amplitude.abs().min(T::ONE);
        held * held
    };
    Some((Polarized { s: square(s), p: square(p) }, g / n))
}

/// Reflectance of a conductor of complex index of refraction η + ik, relative to the medium the light comes from.
///
/// `cosine` is cos θ from 0 to 1. In `f32` the error is below 1e-6 for metals.
///
/// The closed form for complex indices (Born and Wolf, "Principles of Optics", 14.2; Hecht, 4.8.1): with
/// a + ib = √((η + ik)² − sin²θ), R_s = ((a − c)² + b²)/((a + c)² + b²) and
/// R_p = R_s·((a − t)² + b²)/((a + t)² + b²), t = sin θ·tan θ.
#[must_use]
pub fn fresnel_conductor<T: Real>(index: T, extinction: T, cosine: T) -> Polarized<T> {
    let sine_squared = (T::ONE - cosine) * (T::ONE + cosine);
    let real = (index - extinction) * (index + extinction) - sine_squared;
    let half_imaginary = index * extinction;
    let imaginary = half_imaginary + half_imaginary;
    let length = T::root(real.product(real) + imaginary.product(imaginary));
    // Of a and b the larger has no subtraction in it, and a·b = ηk gives the other one.
    let larger = ((length + real.abs()) * T::HALF).sqrt();
    let smaller = if larger > T::ZERO { half_imaginary / larger } else { T::ZERO };
    let (a, b) = if real > T::ZERO { (larger, smaller) } else { (smaller, larger) };
    let (less, more) = (a - cosine, a + cosine);
    let whole = more * more + b * b;
    if whole == T::ZERO {
        // Along an interface between equal media.
        return Polarized { s: T::ZERO, p: T::ZERO };
    }
    let s = (less * less + b * b) / whole;
    // Multiplied by cos θ, so that nothing is divided by it.
    let (ac, bc) = (a * cosine, b * cosine);
    let (less, more) = (ac - sine_squared, ac + sine_squared);
    let p = s * (less * less + bc * bc) / (more * more + bc * bc);
    Polarized { s, p }
}
