//! stub
#![cfg_attr(not(test), no_std)]
pub mod math;
pub mod render;
pub mod scene;
pub use math::{Real, Rgb, Vec3};
pub use scene::{
    Background, Camera, Effects, Interface, Lens, Light, Material, Object, Pattern, Scene, SceneBuf, Shape, Tone,
};
