//! Bent light against exact values: graded media, a mirage, a black hole, in `f32` and in `f64`.
//!
//! The values are those of `tests/data/oracles` (closed forms, quadrature, elliptic integrals) and of formulas that are worked
//! out here and not by the library, and are compared with those tables first.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../../examples/bending/exact/mod.rs"]
mod exact;
#[allow(dead_code)] // The page uses more of it.
#[path = "../../examples/bending/world/mod.rs"]
mod world;

mod behind_a_hole;
mod capture;
mod close_to_a_hole;
mod deflection;
mod glass;
mod layered_air;
mod lenses;
mod mirage;
mod orbit;
mod out_of_steps;
mod reversal;
mod support;
mod tables;
mod tabulated;
