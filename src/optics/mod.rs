//! What happens to light at an interface: pure functions of angles and indices of refraction.
//!
//! Angles are taken from the unit normal N on the side of the incident ray. D is the incident unit direction and
//! c = −D·N the cosine of the angle of incidence.

mod attenuation;
mod dispersion;
mod fresnel;
pub mod materials;
mod reflection;
mod refraction;
mod schlick;
mod spectrum;
mod thin_film;

pub use attenuation::{attenuation_for, transmittance};
pub use dispersion::{Cauchy, Sellmeier};
pub use fresnel::{Polarized, fresnel_conductor, fresnel_dielectric};
pub use reflection::reflect;
pub use refraction::{critical_sine, refract, transmitted_cosine};
pub use schlick::{normal_reflectance, schlick, schlick_dielectric};
pub use spectrum::{Band, COHERENCE_LENGTH, WAVELENGTHS, bands, coherence};
pub use thin_film::{Coating, thin_film};
