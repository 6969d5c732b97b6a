//! No interface reflects more light than it gets, not by a rounding error either.

use whit::optics::fresnel_dielectric;

use crate::support::Random;

#[test]
fn reflectance_is_a_share() {
    let mut random = Random::new(63);
    let (mut above, mut count) = (0, 0);
    for _ in 0..300_000 {
        let [n1, n2] = [1.0; 2].map(|_: f64| 10_f64.powf(random.between(-3.0, 3.0)) as f32);
        let cosine = if count % 2 == 0 { random.unit() } else { 10_f64.powf(random.between(-20.0, 0.0)) } as f32;
        if let Some((polarized, _)) = fresnel_dielectric(n1, n2, cosine) {
            assert!(polarized.s >= 0.0 && polarized.p >= 0.0);
            above += usize::from(polarized.s > 1.0 || polarized.p > 1.0);
        }
        count += 1;
    }
    assert_eq!(above, 0, "above 1, of {count}");
}
