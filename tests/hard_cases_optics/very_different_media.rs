//! From a dense medium into a very thin one, only light that comes nearly straight gets through.

use whit::optics::{fresnel_dielectric, normal_reflectance};

use crate::exact::fresnel;
use crate::support::Random;

/// Pairs of indices as far apart as scenes may have them.
fn pairs() -> impl Iterator<Item = (f32, f32)> {
    let mut random = Random::new(61);
    let any = (0..20_000).map(move |_| [1.0; 2].map(|_: f64| 10_f64.powf(random.between(-3.0, 3.0)) as f32));
    any.map(|[a, b]| (a.max(b), a.min(b))).chain([(1000.0, 1e-3), (1.0, 1e-3), (1000.0, 1.0)])
}

/// How well the cosine behind can be known: with twice the digits of the number type there is (n₁/n₂)² of its error.
fn tolerance(n1: f32, n2: f32) -> f32 {
    4e-6 + 1e-14 * (n1 / n2).powi(2)
}

#[test]
fn light_that_comes_straight_gets_through() {
    for (n1, n2) in pairs() {
        let (polarized, cosine) = fresnel_dielectric(n1, n2, 1.0).expect("a way through");
        assert!((cosine - 1.0).abs() < tolerance(n1, n2), "{n1} into {n2}: {cosine}");
        let exact = normal_reflectance(f64::from(n1), f64::from(n2));
        assert!((f64::from(polarized.mean()) - exact).abs() < 1e-6, "{n1} into {n2}: {polarized:?} {exact}");
    }
}

#[test]
fn no_cosine_is_above_one() {
    for (n1, n2) in pairs() {
        for cosine in [1.0, 1.0 - f32::EPSILON / 2.0, 1.0 - f32::EPSILON, 0.999_9, 0.99] {
            let (found, exact) = (fresnel_dielectric(n1, n2, cosine), fresnel(n1, n2, cosine));
            assert_eq!(found.is_some(), exact.is_some(), "{n1} into {n2} at {cosine}");
            let Some((_, behind)) = found else { continue };
            assert!(behind <= 1.0 + tolerance(n1, n2), "{n1} into {n2} at {cosine}: {behind}");
        }
    }
}
