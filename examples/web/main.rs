//! The renderer of the web page, in `f32`. [README.md](README.md) says how to build and open it.
#![cfg_attr(target_arch = "wasm32", no_std)]

mod alone;
mod decode;
pub mod exports;
mod memory;
mod message;
mod page;
mod picture;
mod record;
mod refusal;
mod trap;

use whit::Scene;

/// What is computed in.
type Number = f32;

/// A scene in that number type. The page must hold no frame of the scene before.
fn converted(scene: &Scene<'static, f32>) -> Option<Scene<'static, Number>> {
    Some(*scene)
}
