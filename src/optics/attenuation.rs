//! Beer's law.

use crate::math::{Real, Rgb};

/// The share of light that is left after a distance in a homogeneous medium: e^(−c·x) per channel.
///
/// `constant` is c in 1/scene unit and `distance` x in scene units, both at least 0. It is the solution of
/// dI/dx = −c·I (Beer-Lambert). A channel with c = 0 passes whole over any distance.
#[inline]
#[must_use]
pub fn transmittance<T: Real>(constant: Rgb<T>, distance: T) -> Rgb<T> {
    constant.map(|c| (-T::held(c.product(distance))).exp())
}

/// The attenuation constant of a medium that leaves the share `color` of the light after `distance`: −ln(color)/x.
///
/// A user thinks of the colour of so much of a thing; this runs in constant evaluation. Shares are from 1e-30 to 1.
#[must_use]
pub const fn attenuation_for(color: Rgb<f32>, distance: f32) -> Rgb<f32> {
    let (r, g, b) = (logarithm(color.r as f64), logarithm(color.g as f64), logarithm(color.b as f64));
    let x = distance as f64;
    Rgb::new((-r / x) as f32, (-g / x) as f32, (-b / x) as f32)
}

/// ln x for x > 0, by ln x = k·ln 2 + 2·artanh((m − 1)/(m + 1)) with x = m·2ᵏ and m near 1.
const fn logarithm(x: f64) -> f64 {
    let (mut m, mut k) = (x, 0);
    while m > 1.5 {
        m /= 2.0;
        k += 1;
    }
    while m < 0.75 && k > -1100 {
        m *= 2.0;
        k -= 1;
    }
    let y = (m - 1.0) / (m + 1.0);
    let (mut term, mut sum, mut n) = (y, 0.0, 1);
    // |y| ≤ 1/5: the last term is below 1e-20.
    while n < 29 {
        sum += term / n as f64;
        term *= y * y;
        n += 2;
    }
    k as f64 * core::f64::consts::LN_2 + 2.0 * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_the_differential_equation() {
        let c = Rgb::new(0.5_f64, 2.0, 0.0);
        let (near, far, dx) = (transmittance(c, 0.7), transmittance(c, 0.7 + 1e-7), 1e-7);
        assert!(((far.r - near.r) / dx + c.r * near.r).abs() < 1e-7);
        assert!(((far.g - near.g) / dx + c.g * near.g).abs() < 1e-6);
        assert_eq!(far.b, 1.0);
    }

    #[test]
    fn ends_of_the_curve() {
        assert_eq!(transmittance(Rgb::new(3.0_f32, 0.0, 1e-30), 0.0), Rgb::WHITE);
        assert_eq!(transmittance(Rgb::new(1e12_f32, 0.0, 1e-30), f32::MAX), Rgb::new(0.0, 1.0, 0.0));
    }

    #[test]
    fn a_colour_at_a_distance_gives_the_constant() {
        const C: Rgb<f32> = attenuation_for(Rgb::new(0.9, 1e-3, 1.0), 2.5);
        let left = transmittance(C, 2.5);
        assert!((left.r - 0.9).abs() < 1e-6 && (left.g - 1e-3).abs() < 1e-8 && left.b == 1.0);
        for i in 1..=2000 {
            let x = f64::from(i) / 1000.0;
            assert!((logarithm(x) - x.ln()).abs() < 1e-14, "{x}");
        }
    }
}
