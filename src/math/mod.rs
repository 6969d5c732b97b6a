//! The scalar trait and the small vectors built on it.

mod real;
mod rgb;
mod square_root;
mod trigonometry;
mod vec3;

pub use real::Real;
pub use rgb::Rgb;
pub use trigonometry::{sin_cos_eighth, tangent_of_degrees};
pub use vec3::Vec3;
