//! Cones and cylinders between two circles.

use whit::scene::Cone;

use super::shapes::{Meeting, Ray, disc};
use super::vector::Vector;

/// The side: part 0.
const SIDE: usize = 0;
/// The disc at the base.
const BASE: usize = 1;
/// The disc at the apex.
const APEX: usize = 2;

/// With the unit axis a from the base b, z = (p − b)·a and the radius ρ(z) = r₀ + k·z, the points of the side have
/// |p − b − z·a|² = ρ(z)² and 0 ≤ z ≤ h. On a line that is A·t² + 2·B·t + C = 0.
pub fn meet(cone: &Cone<f32>, ray: &Ray, own: Option<usize>, found: &mut impl FnMut(Meeting)) {
    let (base, apex) = (Vector::from(cone.base), Vector::from(cone.apex));
    let height = (apex - base).length();
    let axis = (apex - base).normalized();
    let (base_radius, apex_radius) = (f64::from(cone.base_radius), f64::from(cone.apex_radius));
    let outside = if base_radius < 0.0 || apex_radius < 0.0 { -1.0 } else { 1.0 };
    let (base_radius, apex_radius) = (base_radius.abs(), apex_radius.abs());
    let slope = (apex_radius - base_radius) / height;

    // Counted from where the line is nearest to the middle, the numbers stay as small as the cone.
    let start = if own == Some(SIDE) { 0.0 } else { ((base + apex) * 0.5 - ray.origin).dot(ray.direction) };
    let from_base = ray.at(start) - base;
    let (z, dz) = (from_base.dot(axis), ray.direction.dot(axis));
    let (across, d_across) = (from_base - axis * z, ray.direction - axis * dz);
    let (rho, d_rho) = (base_radius + slope * z, slope * dz);
    let a = d_across.dot(d_across) - d_rho * d_rho;
    let b = across.dot(d_across) - rho * d_rho;
    let c = across.dot(across) - rho * rho;

    for t in if own == Some(SIDE) { [-2.0 * b / a, f64::NAN] } else { roots(a, b, c) } {
        let z = z + dz * t;
        if t.is_finite() && z >= 0.0 && z <= height {
            let radial = across + d_across * t;
            // Half the gradient of |p − b − z·a|² − ρ². It vanishes at the tip, where any normal is as good.
            let gradient = radial - axis * ((base_radius + slope * z) * slope);
            let tip = axis * -slope.signum();
            let normal = if gradient.length() > 0.0 { gradient.normalized() } else { tip };
            found(Meeting::new(start + t, normal * outside, SIDE));
        }
    }
    if cone.capped {
        disc(base, axis * -outside, base_radius, BASE, ray, own, found);
        disc(apex, axis * outside, apex_radius, APEX, ray, own, found);
    }
}

/// The roots of A·t² + 2·B·t + C, without cancellation; infinite or not a number where there is none.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let q = -(b + (b * b - a * c).sqrt().copysign(b));
    [q / a, c / q]
}
