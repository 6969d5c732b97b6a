//! From bytes to everything that a render can be asked for.
//!
//! Every sequence of bytes means something, so a property test and a fuzzer can both use it. Most of what comes out is
//! within the ranges that validation accepts; how, is told in [`source`].

mod bands;
mod bending;
mod camera;
mod lights;
mod materials;
mod media;
mod nff;
mod objects;
mod points;
mod profiles;
mod rays;
mod run;
mod settings;
mod shapes;
mod source;
mod span;

pub use nff::text;
pub use run::{Outcome, Run};
use source::Source;
