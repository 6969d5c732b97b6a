//! Pixels: camera samples, scanlines, the resumable frame and the targets it renders into.

mod framebuffer;

pub use framebuffer::{Framebuffer, Pixel, Size};
