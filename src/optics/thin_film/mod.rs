//! Interference in one thin coating: a soap film, oil on water, an oxide on a metal.
//!
//! The geometric series of all reflections inside of the film (Airy 1833) in its closed form, with complex Fresnel
//! amplitudes.

mod coating;
mod incidence;
mod series;

pub use coating::Coating;

use crate::math::{Complex, Real};
use incidence::{Incidence, Stack};

/// The reflectances `(R_s, R_p)` of a base under a film of even thickness, for the two polarisations.
///
/// `outer` and `film` are the indices of refraction of the medium that the light comes from and of the film, `base` is
/// η + ik of what is under it, with k ≥ 0, zero in a dielectric. `cosine` is that of the angle of incidence, in the
/// outer medium. `thickness_nm` and `wavelength_nm` are in nanometres, the wavelength in vacuum and above zero.
///
/// It is right beyond the critical angles too: of the base (all is reflected), of the film (some is, when the base is
/// near: frustrated total reflection) and of both. At grazing incidence it is 1 and at thickness 0 it is the Fresnel
/// reflectance of the base alone. It is within \[0, 1\] always. In `f32` the error is below 1e-5 for films of up to 13
/// wavelengths of path difference and grows in proportion to that.
#[must_use]
pub fn thin_film<T: Real>(outer: T, film: T, base: Complex<T>, cosine: T, thickness_nm: T, wavelength_nm: T) -> (T, T) {
    let incidence = Incidence::new(outer, film, cosine);
    let wave = incidence.wave(thickness_nm, wavelength_nm);
    let stack = Stack::new(&incidence, base);
    (stack.s.reflectance(&wave), stack.p.reflectance(&wave))
}
