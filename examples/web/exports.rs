//! What the page may call. Nothing is imported.
//!
//! Where a function gives a length, it is that of the text at `text`; 0 is success.
#![allow(unsafe_code)] // A name that is exported could stand in for another's.

use whit::render::Size;
use whit::{Fresnel, Rgb, scenes};

use crate::memory::{message, page, picture, records};
use crate::page::Wishes;
use crate::record::Record;

/// The length of the name of a built-in scene, 0 after the last.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn scene_name(index: usize) -> usize {
    let name = const { &scenes::ALL }.get(index).map_or("", |(name, _)| *name);
    message().set(name).as_bytes().len()
}

/// Opens a built-in scene.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn open_scene(index: usize) {
    page().open_scene(index);
}

/// Opens a scene file: so many bytes of records at `file`, as the reader's module made them.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn open_file(length: usize) {
    page().open_file(length);
}

/// Begins a picture, seen by the camera at `pose`. After an error all is as before.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn start(
    width: u32,
    height: u32,
    samples: u32,
    is_grid: bool,
    depth: u32,
    cutoff: f32,
    termination: u32,
    is_schlick: bool,
) -> usize {
    let size = Size::new(width, height);
    let fresnel = if is_schlick { Fresnel::Schlick } else { Fresnel::Exact };
    match page().start(&Wishes { size, samples, is_grid, depth, cutoff, termination, fresnel }) {
        Ok(()) => 0,
        Err(refusal) => {
            refusal.tell(message());
            message().as_bytes().len()
        }
    }
}

/// Traces about so many rays more and gives the number of pixels that are left.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn step(rays: u32) -> u32 {
    page().step(rays)
}

/// The rays of the picture so far, shadow rays included.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn rays() -> u32 {
    page().rays()
}

/// Red, green, blue and alpha of each pixel, a byte each.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn pixels() -> *const [u8; 4] {
    picture().bytes.as_ptr()
}

/// Linear red, green and blue of each pixel, an `f32` each.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn values() -> *const Rgb<f32> {
    picture().values.as_ptr()
}

/// Eye, target and up of the camera and the distance in focus: 10 `f32`, to be read after a scene was opened and to be
/// written before `start`.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn pose() -> *mut f32 {
    page().pose.as_mut_ptr()
}

/// Where the records of a scene file go.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn file() -> *mut Record {
    records().as_mut_ptr()
}

/// Where the text of the last message is.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn text() -> *const u8 {
    message().as_bytes().as_ptr()
}
