//! The renderer of the web page, in `f64`: to compare with, and to see what `f32` costs in accuracy.
#![cfg_attr(target_arch = "wasm32", no_std)]

mod decode;
mod exports;
mod memory;
mod message;
mod page;
mod picture;
mod record;
mod refusal;
mod trap;

use whit::{Real, Scene, SceneBuf};

/// What is computed in.
type Number = f64;

/// A scene in that number type. The page must hold no frame of the scene before.
fn converted(scene: Scene<'static, f32>) -> Option<Scene<'static, Number>> {
    SceneBuf::from_scene(&scene, Number::from_f32).ok().map(memory::keep_all)
}
