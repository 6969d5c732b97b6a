//! The scalar trait and the small vectors built on it.

mod accumulate;
mod complex;
mod exact_product;
#[cfg(feature = "fixed")]
mod fixed_point;
#[cfg(feature = "fixed")]
mod q;
mod range;
mod real;
mod rgb;
mod square_root;
mod trigonometry;
mod twofold;
mod vec3;

pub use accumulate::Accumulate;
pub use complex::Complex;
#[cfg(feature = "fixed")]
pub use q::{Q, Q16, Q20};
pub use range::Range;
pub use real::Real;
pub use rgb::Rgb;
pub(crate) use trigonometry::sin_cos_constant;
pub use trigonometry::{sin_cos_eighth, sin_cos_turns, tangent_of_degrees};
pub(crate) use twofold::Twofold;
pub use vec3::Vec3;
