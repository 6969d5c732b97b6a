//! Fixed point: what is accepted renders within the range of the numbers, and as near to `f64` as is said here.
//!
//! The profile of these tests checks for overflow. With `WHIT_HARD_CASES=full` in the environment, there are ten times as many
//! cases.
#![cfg(feature = "fixed")]
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic)]

mod accuracy;
mod anything;
#[path = "../hard_cases_shapes/exact.rs"]
#[allow(dead_code)]
mod exact;
mod frames;
mod furnace;
mod generator;
mod leaving;
#[path = "../hard_cases_shapes/meshes.rs"]
#[allow(dead_code)]
mod meshes;
mod optics;
#[path = "../hard_cases_shapes/random.rs"]
#[allow(dead_code)]
mod random;
mod refusals;
#[path = "../hard_cases_shapes/solids.rs"]
#[allow(dead_code)]
mod solids;
mod watertight;

use whit::{Effects, Real, Scene, SceneBuf};

const ALL: u64 = Effects::ALL.bits();

/// So many cases, or ten times as many where that is asked for.
fn cases(count: u64) -> u64 {
    let full = std::env::var("WHIT_HARD_CASES").is_ok_and(|value| value == "full");
    if full { 10 * count } else { count }
}

/// A scene in another number type.
type Buffer<T> = SceneBuf<T, 128, 8, 4>;

fn converted<T: Real>(scene: &Scene<'_, f32>) -> Box<Buffer<T>> {
    Box::new(SceneBuf::from_scene(scene, T::from_f32).unwrap())
}

fn to_f32<T: Real>(scene: &Scene<'_, T>) -> Box<Buffer<f32>> {
    Box::new(SceneBuf::from_scene(scene, T::to_f32).unwrap())
}
