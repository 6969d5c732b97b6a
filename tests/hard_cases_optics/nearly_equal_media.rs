//! Indices of refraction that differ in their last digits: the less they differ, the less is reflected, but near grazing
//! incidence all is.

use whit::optics::fresnel_dielectric;

use crate::exact::{critical_cosine, fresnel};
use crate::naive::snell;
use crate::support::Random;

/// The largest error of a reflectance, at angles that are not critical to one part in a hundred.
fn worst(reflectance: impl Fn(f32, f32, f32) -> Option<f32>) -> (f64, [f32; 3]) {
    let mut random = Random::new(62);
    let mut worst = (0.0, [0.0; 3]);
    for _ in 0..300_000 {
        let n1 = 10_f64.powf(random.between(-1.0, 1.0)) as f32;
        let n2 = (f64::from(n1) * (1.0 + 10_f64.powf(random.between(-6.9, -2.0)))) as f32;
        let (n1, n2) = if random.unit() < 0.5 { (n1, n2) } else { (n2, n1) };
        let cosine = 10_f64.powf(random.between(-5.0, 0.0)) as f32;
        let critical = if n1 > n2 { critical_cosine(n1, n2) } else { 0.0 };
        if (f64::from(cosine) / critical - 1.0).abs() < 1e-2 {
            continue;
        }
        let exact = fresnel(n1, n2, cosine).map(|[s, p, _]| f64::midpoint(s, p));
        let found = reflectance(n1, n2, cosine).map(f64::from);
        let error = (found.unwrap_or(1.0) - exact.unwrap_or(1.0)).abs();
        if error > worst.0 {
            worst = (error, [n1, n2, cosine]);
        }
    }
    println!("{worst:?}");
    worst
}

/// The textbook's form takes reflection for transmission.
#[test]
fn the_textbook_form_is_far_off() {
    let (error, place) = worst(|n1, n2, c| Some(snell::reflectance(n1, n2, c)));
    assert!(error > 0.5, "{error} {place:?}");
}

#[test]
fn reflectance_is_exact() {
    let (error, place) = worst(|n1, n2, c| Some(fresnel_dielectric(n1, n2, c)?.0.mean()));
    assert!(error < 2e-6, "{error} {place:?}");
}
