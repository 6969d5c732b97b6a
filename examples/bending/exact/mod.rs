//! Bent paths that are known exactly, worked out in `f64` and without the library.

pub mod deflection;
pub mod glass;
pub mod mirage;
