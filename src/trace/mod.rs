//! The ray tree, its budget and its shading.

mod background;
mod bent_light;
mod budget;
mod film;
mod illumination;
mod media;
mod meeting;
mod observer;
mod sequence;
mod shade;
mod shadow;
mod split;
mod stars;
mod tracer;
mod tree;

pub use budget::{Budget, MOST_BOUNCES, MOST_PASSED, Termination};
pub(crate) use illumination::concentric;
pub use observer::{Cut, Dropped, Observer, RayKind, Stats};
pub use sequence::Sequence;
pub(crate) use shade::Samples;
pub use tracer::{Tracer, TracerError};
use tree::Branch;
pub(crate) use tree::{Context, RayTree};
