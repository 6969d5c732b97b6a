//! Total reflection, judged on the very numbers that are given: at cosines up to 1000 steps of the number type from the
//! critical one, none that is not there and none that is missed.

use rayon::prelude::*;
use whit::optics::{fresnel_dielectric, transmitted_cosine};

use crate::exact::{critical_cosine, is_total};
use crate::naive::snell;
use crate::support::{Random, ulps_up};

/// Indices from 1.0000001 to 1000.
fn indices() -> Vec<f32> {
    let named = [1.000_000_1, 1.000_01, 1.000_293, 1.01, 1.31, 1.333, 1.5, 1.9, 2.417, 4.0, 10.0, 31.7, 1000.0];
    let mut random = Random::new(6);
    let random = (0..200).map(|_| 1.0 + 10_f64.powf(random.between(-5.0, 2.99)) as f32);
    named.into_iter().chain(random).collect()
}

/// From a vacuum into something thinner: the ratio of the indices is a number of its own.
fn into_thinner() -> Vec<(f32, f32)> {
    indices().into_iter().map(|n| (1.0, 1.0 / n)).collect()
}

/// From something into a vacuum, and between any two: the ratio of the indices has to be rounded.
fn between_any() -> Vec<(f32, f32)> {
    let n = indices();
    let into_vacuum = n.iter().map(|&n| (n, 1.0));
    let neighbours = n.windows(2).map(|n| (n[0].max(n[1]), n[0].min(n[1])));
    let extremes = [(1000.0, 1e-3), (31.7, 1e-3), (1.000_000_1, 1.0), (1e-3, 0.999e-3), (1.5, 1.333), (1.333, 1.31)];
    into_vacuum.chain(neighbours).chain(extremes).filter(|(n1, n2)| n1 > n2).collect()
}

/// How many total reflections are not there, how many are missed, out of how many.
fn misjudged(pairs: &[(f32, f32)], judge: impl Fn(f32, f32, f32) -> bool + Sync) -> [usize; 3] {
    let of_pair = |&(n1, n2): &(f32, f32)| {
        let critical = critical_cosine(n1, n2) as f32;
        (-1000..=1000).map(|ulps| ulps_up(critical, ulps)).filter(|&cosine| cosine <= 1.0).fold(
            [0; 3],
            |sum, cosine| {
                let (exact, found) = (is_total(n1, n2, cosine), judge(n1, n2, cosine));
                [sum[0] + usize::from(found && !exact), sum[1] + usize::from(exact && !found), sum[2] + 1]
            },
        )
    };
    let add = |a: [usize; 3], b: [usize; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let result = pairs.par_iter().map(of_pair).reduce(|| [0; 3], add);
    println!("{} not there, {} missed, of {}", result[0], result[1], result[2]);
    result
}

/// The textbook's radicand gets one in twenty wrong.
#[test]
fn the_textbook_form_misjudges() {
    for pairs in [into_thinner(), between_any()] {
        let [false_ones, missed, all] = misjudged(&pairs, |n1, n2, c| snell::transmitted_cosine(n1, n2, c).is_none());
        assert!(false_ones > 100 && missed > all / 100, "{false_ones} {missed} {all}");
    }
}

#[test]
fn it_is_exact_into_a_thinner_medium_from_a_vacuum() {
    let pairs = into_thinner();
    let [false_ones, missed, all] = misjudged(&pairs, |n1, n2, c| transmitted_cosine(n1, n2, c).is_none());
    assert_eq!([false_ones, missed], [0, 0], "of {all}");
}

#[test]
fn it_is_exact_between_any_two_media() {
    let pairs = between_any();
    let [false_ones, missed, all] = misjudged(&pairs, |n1, n2, c| transmitted_cosine(n1, n2, c).is_none());
    assert_eq!([false_ones, missed], [0, 0], "of {all}");
}

#[test]
fn reflectance_and_refraction_agree_on_it() {
    for (n1, n2) in [into_thinner(), between_any()].concat() {
        let critical = critical_cosine(n1, n2) as f32;
        for cosine in (-1000..=1000).map(|ulps| ulps_up(critical, ulps)).filter(|&cosine| cosine <= 1.0) {
            let reflectance = fresnel_dielectric(n1, n2, cosine).map(|(_, transmitted_cosine)| transmitted_cosine);
            assert_eq!(reflectance, transmitted_cosine(n1, n2, cosine), "{n1} {n2} {cosine}");
        }
    }
}
