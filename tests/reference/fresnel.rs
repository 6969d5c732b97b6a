//! Reflectance of surfaces without a film.
//!
//! M. Born and E. Wolf, Principles of Optics, sections 1.5 and 14.2. Each is the mean over both polarisations.

use whit::scene::Fresnel;

use super::complex::Complex;

/// From a medium of index n₁ into one of n₂, at an angle of incidence of cosine c₁; 1 on total internal reflection.
pub fn dielectric(model: Fresnel, n1: f64, n2: f64, c1: f64) -> f64 {
    if n1 == n2 {
        // The formulas are 0/0 here for rays along the surface.
        return 0.0;
    }
    // (n₂·c₂)² by Snell's law, without a difference of squares that are nearly equal.
    let square = (n2 - n1) * (n2 + n1) + (n1 * c1).powi(2);
    if square < 0.0 {
        return 1.0;
    }
    let c2 = square.sqrt() / n2;
    match model {
        Fresnel::Exact => {
            let s = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
            let p = (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2);
            0.5 * (s * s + p * p)
        }
        Fresnel::Schlick => {
            let r0 = ((n1 - n2) / (n1 + n2)).powi(2);
            schlick(r0, if n1 <= n2 { c1 } else { c2 })
        }
    }
}

/// R = R₀ + (1 − R₀)·(1 − cos θ)⁵: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994.
pub fn schlick(r0: f64, cosine: f64) -> f64 {
    r0 + (1.0 - r0) * (1.0 - cosine).powi(5)
}

/// Of a metal whose index η + ik, divided by that of the medium in front, is m: r_s = (c − q)/(c + q) and
/// r_p = (m²c − q)/(m²c + q) with q = √(m² − sin²θ).
pub fn conductor(m: Complex, cosine: f64) -> f64 {
    let square = m * m;
    let q = (square - (1.0 - cosine * cosine).into()).sqrt();
    let c = Complex::from(cosine);
    let s = (c - q) / (c + q);
    let p = (square * c - q) / (square * c + q);
    0.5 * (s.norm_squared() + p.norm_squared())
}
