//! Scenes and rays that break ray tracers. Each case shows first that a naive form breaks, and then that the library does
//! not.
#![allow(missing_docs, clippy::unwrap_used, clippy::unreachable, clippy::indexing_slicing)]

#[path = "../../examples/stability/leaving.rs"]
mod leaving;
#[path = "../../examples/stability/naive/mod.rs"]
mod naive;

mod cancellation;
mod scale;
mod self_intersection;
