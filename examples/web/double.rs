//! The renderer of the web page, in `f64`: to compare with, and to see what `f32` costs in accuracy.
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

use core::mem::MaybeUninit;

use alone::Alone;
use whit::{Real, Scene, SceneBuf};

/// What is computed in.
type Number = f64;

/// A built-in scene in that number type. The page must hold no frame of the one before.
#[allow(unsafe_code)] // Static memory with one user: see `memory`.
fn converted(scene: Scene<'static, f32>) -> Option<Scene<'static, Number>> {
    static BUFFER: Alone<MaybeUninit<SceneBuf<Number, 128, 8, 4>>> = Alone::new(MaybeUninit::uninit());
    let copy = SceneBuf::from_scene(&scene, Number::from_f32).ok()?;
    let buffer: &'static _ = unsafe { BUFFER.get() }.write(copy);
    Some(buffer.as_scene())
}
