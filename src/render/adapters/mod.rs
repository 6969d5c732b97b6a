//! Ready-made framebuffers over memory that the caller owns.

#[cfg(feature = "embedded-graphics")]
mod display_color;
mod dither;
#[cfg(feature = "embedded-graphics")]
mod draw_target_cells;
#[cfg(feature = "embedded-graphics")]
mod draw_target_lines;
mod for_each;
mod grey8;
mod linear_rgb;
mod mono;
mod packed;
#[cfg(feature = "embedded-graphics")]
mod placement;
mod preview;
mod rgb565;
mod rgb888;
mod rgba8888;
mod size_error;

#[cfg(feature = "embedded-graphics")]
pub use display_color::{DisplayColor, Dithered};
#[cfg(feature = "embedded-graphics")]
pub use draw_target_cells::DrawTargetCells;
#[cfg(feature = "embedded-graphics")]
pub use draw_target_lines::{DrawTargetLines, LineError};
pub use for_each::ForEach;
pub use grey8::Grey8;
pub use linear_rgb::LinearRgb;
pub use mono::Mono;
#[cfg(feature = "embedded-graphics")]
pub use placement::PlacementError;
pub use preview::Preview;
pub use rgb565::{ByteOrder, Rgb565};
pub use rgb888::Rgb888;
pub use rgba8888::Rgba8888;
pub use size_error::SizeError;
