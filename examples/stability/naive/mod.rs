//! The forms that break: what is found in textbooks and small ray tracers.

pub mod origin;
pub mod quadratic;
