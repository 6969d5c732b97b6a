//! The renderer of the web page, in `f64`: to compare with, and to see what `f32` costs in accuracy.
#![cfg_attr(target_arch = "wasm32", no_std)]

mod alone;
mod conversion;
mod decode;
pub mod exports;
mod memory;
mod message;
mod page;
mod picture;
mod record;
mod refusal;
mod trap;

use conversion::converted;

/// What is computed in.
type Number = f64;
