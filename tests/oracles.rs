//! The Fresnel equations against tables in high precision. `fresnel.csv` was made in 50-digit arithmetic from the
//! `f32` inputs, `conductor.csv` from decimal ones.
#![allow(missing_docs, clippy::unwrap_used)]

use whit::optics::{fresnel_conductor, fresnel_dielectric};

/// The rows of a table, as text fields.
fn rows(table: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().skip(1).map(|line| line.split(',').collect())
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

fn single(hexadecimal: &str) -> f32 {
    f32::from_bits(u32::from_str_radix(hexadecimal, 16).unwrap())
}

/// Within 1e-3 of the critical angle, an error of the last bit of the cosine is an error of about 1e-3 in the reflectance.
#[test]
fn dielectrics_have_the_exact_reflectance() {
    let (mut count, mut worst, mut worst_critical) = (0, 0.0_f64, 0.0_f64);
    for row in rows(include_str!("data/oracles/fresnel.csv")) {
        let (n, cosine) = (single(row[0]), single(row[2]));
        let exact = [4, 5, 6].map(|column| number(row[column]));
        let Some((polarized, _)) = fresnel_dielectric(1.0, n, cosine) else {
            assert_eq!(exact, [1.0; 3], "{row:?}");
            continue;
        };
        let found = [polarized.s, polarized.p, polarized.mean()].map(f64::from);
        let critical = (1.0 - f64::from(n).powi(2)).max(0.0).sqrt();
        let is_critical = n < 1.0 && (f64::from(cosine) - critical).abs() < 1e-3;
        for (found, exact) in found.into_iter().zip(exact) {
            assert!((0.0..=1.0 + 1e-6).contains(&found), "{row:?}: {found}");
            let error = (found - exact).abs();
            let worst = if is_critical { &mut worst_critical } else { &mut worst };
            *worst = worst.max(error);
        }
        count += 1;
    }
    println!("{count} rows: {worst:e}, near the critical angle {worst_critical:e}");
    assert!(count > 200 && worst < 1e-6 && worst_critical < 2e-3, "{count} {worst:e} {worst_critical:e}");
}

/// Both are exactly 1 beyond the critical angle, and nothing is wrong in the places where a formula could divide by 0.
#[test]
fn total_reflection_is_total() {
    for (n1, n2) in [(1.5_f32, 1.0_f32), (1.333, 1.0), (2.417, 1.333), (1.0, 0.999_999)] {
        let sine = f64::from(n2) / f64::from(n1);
        let critical = (1.0 - sine * sine).sqrt();
        assert!(fresnel_dielectric(n1, n2, (critical * 0.99) as f32).is_none());
        assert!(fresnel_dielectric(n1, n2, 0.0).is_none());
        assert!(fresnel_dielectric(n1, n2, (critical * 1.01) as f32).is_some());
    }
    assert_eq!(fresnel_dielectric(1.5_f32, 1.5, 0.0).unwrap().0.mean(), 0.0);
    assert_eq!(fresnel_dielectric(1.0_f32, 1.5, 0.0).unwrap().0.mean(), 1.0);
}

#[test]
fn conductors_have_the_exact_reflectance() {
    let (mut count, mut worst) = (0, 0.0_f64);
    for row in rows(include_str!("data/oracles/conductor.csv")) {
        let [n, k, degrees] = [2, 3, 4].map(|column| number(row[column]));
        let found = fresnel_conductor(n as f32, k as f32, degrees.to_radians().cos() as f32);
        for (found, column) in [(found.s, 5), (found.p, 6), (found.mean(), 7)] {
            worst = worst.max((f64::from(found) - number(row[column])).abs());
        }
        count += 1;
    }
    println!("{count} rows: {worst:e}");
    assert!(count == 83 && worst < 1e-6, "{count} {worst:e}");
}

/// A conductor without extinction is a dielectric.
#[test]
fn conductors_and_dielectrics_meet() {
    for n in [0.3_f64, 1.1, 1.5, 2.4] {
        for i in 0..=100 {
            let cosine = f64::from(i) / 100.0;
            let conductor = fresnel_conductor(n, 0.0, cosine);
            let Some((dielectric, _)) = fresnel_dielectric(1.0, n, cosine) else {
                assert!((conductor.s - 1.0).abs() + (conductor.p - 1.0).abs() < 1e-12);
                continue;
            };
            assert!((conductor.s - dielectric.s).abs() + (conductor.p - dielectric.p).abs() < 1e-12, "{n} {cosine}");
        }
    }
}
