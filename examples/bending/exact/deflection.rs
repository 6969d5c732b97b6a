//! By which angle a black hole bends light that comes from far away and goes there again.

use std::f64::consts::PI;

/// The impact parameter below which light is captured, 3√3·M, in units of the mass.
pub const CRITICAL: f64 = 5.196_152_422_706_632;

/// The angle for an impact parameter above [`CRITICAL`], in units of the mass.
///
/// With the closest approach r₀ and Q² = (r₀ − 2)(r₀ + 6) it is 4√(r₀/Q)·(K(k) − F(φ, k)) − π with
/// k² = (Q − r₀ + 6)/2Q and sin²φ = (Q − r₀ + 2)/(Q − r₀ + 6) (Chandrasekhar, "The Mathematical Theory of Black Holes", §20).
pub fn deflection(b: f64) -> f64 {
    let r0 = closest_approach(b);
    let q = ((r0 - 2.0) * (r0 + 6.0)).sqrt();
    let square = (q - r0 + 6.0) / (2.0 * q);
    let sine = ((q - r0 + 2.0) / (q - r0 + 6.0)).sqrt();
    4.0 * (r0 / q).sqrt() * (elliptic(1.0, square) - elliptic(sine, square)) - PI
}

/// The largest root of r³ − b²r + 2b² = 0.
pub fn closest_approach(b: f64) -> f64 {
    2.0 * b / 3.0_f64.sqrt() * ((-CRITICAL / b).acos() / 3.0).cos()
}

/// Legendre's integral of the first kind F(φ, k), of sin φ and k².
fn elliptic(sine: f64, square: f64) -> f64 {
    sine * carlson((1.0 - sine) * (1.0 + sine), 1.0 - square * sine * sine, 1.0)
}

/// Carlson's R_F by his duplication (Carlson, "Computing elliptic integrals by duplication", 1979).
fn carlson(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    for _ in 0..40 {
        let step = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        (x, y, z) = ((x + step) / 4.0, (y + step) / 4.0, (z + step) / 4.0);
    }
    1.0 / ((x + y + z) / 3.0).sqrt()
}
