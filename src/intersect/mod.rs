//! Rays against shapes: contacts, error-bounded surface points, and the search through all objects.

mod axis_box;
mod bits;
mod bounds;
mod candidates;
mod cone;
mod fixed_point;
mod hit;
mod intersection;
#[cfg(test)]
mod numbers;
mod plane;
mod ray;
mod search;
mod sphere;
mod spheres;
mod surface;
mod triangle;
mod walk;

use bits::Bits;
pub(crate) use bounds::{Bounds, clearance, may_meet};
pub(crate) use candidates::Candidates;
pub(crate) use hit::Hit;
pub use intersection::{Destination, Intersection};
pub(crate) use ray::Contact;
pub use ray::Ray;
pub(crate) use search::{Wanted, encloses, meets, search, search_scene};
pub(crate) use surface::{Located, Surface};
