//! Hard cases of rays against shapes: boxes, planes and triangles, and rays that leave any shape.
//!
//! Each module has one case. Where the usual way to compute it goes wrong, that way is kept beside the library's, and
//! the test asserts that it does go wrong. What is expected comes from `f64`, whose error is 2²⁹ times smaller than
//! what is looked for.
//!
//! With `WHIT_HARD_CASES=full` in the environment, ten times as many rays are traced.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing)]

mod box_points;
mod boxes;
mod cone_surfaces;
mod degenerate_triangles;
mod exact;
mod long_triangles;
mod meshes;
mod plane_offsets;
mod planes;
mod random;
mod seams_without_area;
mod self_hits;
mod self_hits_of_cones;
mod self_hits_of_planes;
mod solids;
mod triangles;

#[path = "../../examples/stability/naive/mod.rs"]
mod naive;

use rayon::prelude::*;
use whit::{Background, Camera, Effects, Intersection, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

/// What a test says of a ray that went wrong.
type Fault = String;

/// Runs a case with each number below `count`, or ten times that, on all cores; gives the first faults, and how many
/// there are.
fn faults(count: u64, case: impl Fn(u64) -> Vec<Fault> + Sync) -> (Vec<Fault>, usize) {
    let full = std::env::var("WHIT_HARD_CASES").is_ok_and(|value| value == "full");
    let count = if full { 10 * count } else { count };
    let mut faults: Vec<_> = (0..count).into_par_iter().flat_map_iter(&case).collect();
    let total = faults.len();
    faults.truncate(5);
    (faults, total)
}

/// Asserts that a case has no fault, for each number below `count`, or ten times that.
fn assert_faultless(count: u64, case: impl Fn(u64) -> Vec<Fault> + Sync) {
    let (first, total) = faults(count, case);
    assert!(total == 0, "{total} faults:\n{}", first.join("\n"));
}

/// What rays meet of a few shapes.
struct Shapes<'a> {
    objects: Vec<Object<'a, f32>>,
}

impl<'a> Shapes<'a> {
    fn one(shape: Shape<'a, f32>) -> Self {
        Self { objects: vec![Object::new(shape, Material::matte(Rgb::WHITE))] }
    }

    /// Calls `f` with a function that gives what a ray meets first.
    fn with<R>(&self, f: impl FnOnce(&dyn Fn(&Ray<f32>) -> Option<Intersection<f32>>) -> R) -> R {
        let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
        let scene = Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(&self.objects);
        let tracer = Tracer::<f32, { Effects::ALL.bits() }, 0>::try_new(&scene).unwrap();
        f(&|ray| tracer.intersect(ray))
    }
}

/// What a ray meets of one shape.
fn meet(shape: Shape<'_, f32>, ray: &Ray<f32>) -> Option<Intersection<f32>> {
    Shapes::one(shape).with(|intersect| intersect(ray))
}
