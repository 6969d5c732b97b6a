//! The renderer of the web page, in `Q20`: fixed point, as on a processor without an FPU. It takes small scenes without bent
//! light, and refuses the others.
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
type Number = whit::Q20;
