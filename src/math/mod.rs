//! The scalar trait and the small vectors built on it.

mod accumulate;
mod complex;
mod constant_root;
mod exact_product;
#[cfg(feature = "micromath")]
mod fast;
#[cfg(feature = "fixed")]
mod fixed_point;
mod integer_floor;
mod integer_root;
mod lanes;
#[cfg(feature = "micromath")]
mod micromath;
#[cfg(feature = "micromath")]
mod operators;
mod power;
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
pub(crate) use constant_root::square_root_constant;
#[cfg(feature = "micromath")]
pub use fast::Fast;
pub(crate) use lanes::{HAS_VECTORS, LANES, Lanes};
#[cfg(feature = "micromath")]
pub use micromath::Micromath;
#[cfg(feature = "fixed")]
pub use q::{Q, Q16, Q20};
pub use range::Range;
pub use real::Real;
pub use rgb::Rgb;
pub(crate) use trigonometry::sin_cos_constant;
pub use trigonometry::{sin_cos_eighth, sin_cos_turns, tangent_of_degrees};
pub(crate) use twofold::Twofold;
pub use vec3::Vec3;

/// Whether the target surely has an FPU for `f32`.
const HAS_FPU: bool = cfg!(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_arch = "wasm32",
    target_abi = "eabihf",
    all(target_arch = "riscv32", target_feature = "f"),
    all(target_arch = "riscv64", target_feature = "f")
));
