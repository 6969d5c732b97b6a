//! The forms that break: what is found in textbooks and small ray tracers.
// The page and the tests each use some of them; their vectors are arrays of three.
#![allow(dead_code, clippy::indexing_slicing)]

pub mod attenuation;
pub mod glass_ball;
pub mod highlight;
pub mod moller_trumbore;
pub mod origin;
pub mod quadratic;
pub mod reflect;
pub mod schlick_incident;
pub mod slab;
pub mod snell;
