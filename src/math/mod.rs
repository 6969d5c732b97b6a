//! The scalar trait and the small vectors built on it.

mod complex;
mod exact_product;
mod real;
mod rgb;
mod square_root;
mod trigonometry;
mod twofold;
mod vec3;

pub use complex::Complex;
pub use real::Real;
pub use rgb::Rgb;
pub(crate) use trigonometry::sin_cos_constant;
pub use trigonometry::{sin_cos_eighth, sin_cos_turns, tangent_of_degrees};
pub(crate) use twofold::Twofold;
pub use vec3::Vec3;
