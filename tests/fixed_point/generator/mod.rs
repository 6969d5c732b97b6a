//! Scenes inside of the range of a fixed-point number type and at its limits.

mod materials;
mod scenes;
mod settings;
mod shapes;
mod source;

pub use scenes::Buffer;
pub use source::Source;
