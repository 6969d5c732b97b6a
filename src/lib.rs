//! stub
#![cfg_attr(not(test), no_std)]
pub mod intersect;
pub mod math;
pub mod optics;
mod path;
pub mod render;
pub mod scene;
pub mod trace;
pub use intersect::Ray;
pub use math::{Real, Rgb, Vec3};
pub use render::{Frame, Framebuffer, Settings};
pub use scene::scenes;
pub use scene::{
    Background, Camera, Effects, Interface, Lens, Light, Material, Object, Pattern, Scene, SceneBuf, Shape, Tone,
};
pub use trace::{Budget, Stats, Termination, Tracer};
