//! What happens to light at an interface: pure functions of angles and indices of refraction.
//!
//! Angles are taken from the unit normal N on the side of the incident ray. D is the incident unit direction and
//! c = −D·N the cosine of the angle of incidence.

mod reflection;
mod refraction;
mod schlick;

pub use reflection::reflect;
pub use refraction::{refract, transmitted_cosine_squared};
pub use schlick::{normal_reflectance, schlick, schlick_dielectric};
