//! Rays that leave a surface.

use crate::leaving::{Failures, failures};
use crate::naive::origin::Origin;
use rayon::prelude::*;

/// From a grain of sand to a planet, with the metre as unit.
const SCALES: [f32; 6] = [1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9];

fn at_all_scales(origin: Origin, rays: u32) -> Vec<(f32, Failures)> {
    SCALES.par_iter().map(|&scale| (scale, failures(origin, scale, rays))).collect()
}

/// No fixed distance is right at all scales: where it is too small, rays meet the surface that they leave; where it is
/// too large, they start beyond the next one.
#[test]
fn fixed_distances_fail() {
    for origin in Origin::ALL {
        let failures = at_all_scales(origin, 20_000);
        for (scale, failures) in &failures {
            println!("{origin:?} {scale:e}: {failures:?}");
        }
        if origin != Origin::ErrorBound {
            let sum = |count: fn(&Failures) -> u32| failures.iter().map(|(_, failures)| count(failures)).sum::<u32>();
            assert!(sum(|f| f.self_hits) + sum(|f| f.leaks) + sum(|f| f.jumps) > 1000, "{origin:?}");
        }
    }
}

#[test]
fn error_bounds_hold() {
    for (scale, failures) in at_all_scales(Origin::ErrorBound, 1_000_000) {
        println!("{scale:e}: {failures:?}");
        let Failures { rays, self_hits, entered, leaks, towards_neighbor, jumps, contact_gap } = failures;
        assert!(rays > 950_000 && entered > 950_000 && towards_neighbor > 700_000, "{scale:e}");
        assert_eq!((self_hits, leaks, jumps), (0, 0, 0), "{scale:e}");
        // A millionth of the radius is far less than a pixel.
        assert!(contact_gap < 1e-6, "{scale:e}: {contact_gap}");
    }
}
