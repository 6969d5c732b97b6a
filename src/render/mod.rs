//! Pixels: camera samples, scanlines, the resumable frame and the targets it renders into.

mod adapters;
mod encode;
mod frame;
mod framebuffer;
mod order;
mod sampling;
mod settings;
mod view;

pub use adapters::{ByteOrder, ForEach, Grey8, LinearRgb, Mono, Preview, Rgb565, Rgb888, Rgba8888, SizeError};
#[cfg(feature = "embedded-graphics")]
pub use adapters::{DisplayColor, Dithered, DrawTargetCells, DrawTargetLines, LineError, PlacementError};
pub use encode::Encoding;
pub use frame::{Frame, Progress, RenderError};
pub use framebuffer::{Framebuffer, Pixel, Size};
pub use order::Order;
pub use sampling::Sampling;
pub use settings::{Settings, SettingsError};
