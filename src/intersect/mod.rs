//! Rays against shapes: contacts, error-bounded surface points, and the search through all objects.

mod axis_box;
mod cone;
mod intersection;
mod plane;
mod ray;
mod search;
mod sphere;
mod spheres;
mod surface;
mod triangle;

pub use intersection::Intersection;
pub(crate) use ray::Contact;
pub use ray::Ray;
pub(crate) use search::{Hit, Wanted, encloses, meets, search};
pub(crate) use surface::{Located, Surface};
