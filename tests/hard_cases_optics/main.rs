//! Hard cases of optics: interfaces, long chains, coincident surfaces, numbers at the edge, total reflection that is not
//! there.
//!
//! Where there is a textbook form that fails, it is shown to fail first. What is expected comes from exact arithmetic or
//! from `f64`, worked out here and not by the library.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../../examples/stability/naive/mod.rs"]
mod naive;

mod chains;
mod coincidence;
mod coincident_media;
mod conductor_without_contrast;
mod coplanar_surfaces;
mod critical_angle;
mod equal_media_at_grazing;
mod exact;
mod eye_on_water;
mod eyes_and_lights;
mod false_total_reflection;
mod interfaces;
mod lights_on_surfaces;
mod nearly_equal_media;
mod numbers;
mod overflow;
mod overlapping_media;
mod reflectance_range;
mod regions;
mod support;
mod very_different_media;
