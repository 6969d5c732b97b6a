//! The number type `Fast`: the errors that its documentation states, and what follows for pictures.
//!
//! A share of all `f32` is tried; with `WHIT_HARD_CASES=full` in the environment, every one, and one of 61 for each exponent of
//! a power. That takes some minutes in the release profile.
#![cfg(feature = "micromath")]
#![allow(missing_docs, clippy::unwrap_used)]

use core::f64::consts::TAU;

use rayon::prelude::*;
use whit::render::{LinearRgb, Size};
use whit::{Effects, Fast, Frame, Real, Rgb, Scene, SceneBuf, Settings, Tracer, scenes};

/// The bit patterns that are tried: one of so many, which is the first number, or in full the second.
fn stride((share, full): (usize, usize)) -> usize {
    if std::env::var("WHIT_HARD_CASES").is_ok_and(|value| value == "full") { full } else { share }
}

/// The largest of some errors, and where it is. An error that is no number counts as the largest.
fn worst(bits: core::ops::RangeInclusive<u32>, share: (usize, usize), error: impl Fn(f32) -> f64 + Sync) -> (f64, f32) {
    let (from, to) = (*bits.start() as usize, *bits.end() as usize);
    let count = (to - from) / stride(share) + 1;
    (0..count)
        .into_par_iter()
        .map(|i| f32::from_bits((from + i * stride(share)) as u32))
        .map(|x| (error(x), x))
        .map(|(error, x)| (if error.is_nan() { f64::INFINITY } else { error }, x))
        .reduce(|| (0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a })
}

/// Both signs.
fn worst_of_both(to: f32, share: (usize, usize), error: impl Fn(f32) -> f64 + Sync) -> (f64, f32) {
    let (up, down) = (worst(0..=to.to_bits(), share, &error), worst(1 << 31..=(-to).to_bits(), share, &error));
    if up.0 > down.0 { up } else { down }
}

/// Asserts that an error is at most what is stated, and that less could not be stated.
fn assert_states(stated: f64, (found, x): (f64, f32)) {
    println!("{found:e} at {x:e}, stated {stated:e}");
    assert!(found <= stated, "{found:e} at {x:e}");
    assert!(found >= stated * 0.9, "{found:e} at {x:e}: {stated:e} is more than need be");
}

#[test]
fn roots_and_floors_are_those_of_f32() {
    let differs = |a: Fast, b: f32| f64::from(a.0.to_bits() != b.to_bits() && !(a.0.is_nan() && b.is_nan()));
    let (wrong, x) = worst(0..=u32::MAX, (499, 1), |x| differs(Fast(x).sqrt(), Real::sqrt(x)));
    assert!(wrong == 0.0, "√{x:e} = {:e}", Fast(x).sqrt().0);
    let (wrong, x) = worst(0..=u32::MAX, (499, 1), |x| f64::from(Fast(x).floor().0 != x.floor() && !x.is_nan()));
    assert!(wrong == 0.0, "⌊{x:e}⌋ = {:e}", Fast(x).floor().0);
}

#[test]
fn operators_are_those_of_f32() {
    let mut x = 1_u32;
    for _ in 0..100_000 {
        let [a, b] = [0, 1].map(|_| {
            x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f32::from_bits(0x3000_0000 + (x >> 3))
        });
        let (p, q) = (Fast(a), Fast::from(b));
        assert_eq!([p + q, p - q, p * q, p / q, p % q, -p].map(f32::from), [a + b, a - b, a * b, a / b, a % b, -a]);
        let mut r = [p; 5];
        let [sum, difference, product, quotient, rest] = &mut r;
        *sum += q;
        *difference -= q;
        *product *= q;
        *quotient /= q;
        *rest %= q;
        assert_eq!(r, [p + q, p - q, p * q, p / q, p % q]);
        assert_eq!(p.product_error(q, p * q).0, a.product_error(b, a * b));
        assert_eq!(p.partial_cmp(&q), a.partial_cmp(&b));
    }
    assert_eq!((Fast::default().0, format!("{:.2}", Fast(1.005))), (0.0, format!("{:.2}", 1.005_f32)));
}

#[test]
fn exponential_is_as_good_as_stated() {
    let error = |x: f32| (f64::from(Fast(x).exp().0) / f64::from(x).exp() - 1.0).abs();
    assert_states(3.4e-5, worst_of_both(10.0, (499, 1), error));
    assert_states(5.6e-5, worst_of_both(87.0, (499, 1), error));
    let cases =
        [(f32::INFINITY, f32::INFINITY), (f32::NEG_INFINITY, 0.0), (-1e9, 0.0), (1e9, f32::INFINITY), (0.0, 1.0)];
    for (x, expected) in cases {
        assert_eq!(Fast(x).exp().0, expected, "{x}");
    }
    assert!(Fast(f32::NAN).exp().0.is_nan());
    // Between the last number with all digits and zero, and up to infinity.
    let (wrong, x) = worst((-200.0_f32).to_bits().min((-87.0_f32).to_bits())..=(-200.0_f32).to_bits(), (99, 1), |x| {
        f64::from(Fast(x).exp().0 - x.exp()).abs()
    });
    assert!(wrong < 1.2e-38, "{x}");
    let (wrong, x) = worst(88.0_f32.to_bits()..=200.0_f32.to_bits(), (99, 1), |x| {
        let (found, expected) = (Fast(x).exp().0, f64::from(x).exp());
        if found.is_infinite() { f64::from(expected < 3.3e38) } else { (f64::from(found) / expected - 1.0).abs() }
    });
    assert!(wrong < 6e-5, "{x}");
}

#[test]
fn powers_are_as_good_as_stated() {
    let exponents = [0.1, 0.5, 1.0, 1.5, 2.4, 5.0, 7.7, 20.5, 50.0, 77.7, 128.0, 250.0, 1000.0, 2999.9, 1e4, 1e6];
    let mut all = (0.0, 0.0);
    for y in exponents {
        let error = |x: f32| (f64::from(Fast(x).powf(Fast(y)).0) - f64::from(x).powf(f64::from(y))).abs();
        let found = worst(0..=1.0_f32.to_bits(), (4999, 61), error);
        all = if found.0 > all.0 { found } else { all };
    }
    assert_states(2.2e-5, all);
}

/// All numbers x and exponents y for which the power is one: the relative error is at most 3e-5·(1 + |log₂ xʸ|).
#[test]
fn other_powers_have_a_relative_error() {
    let found = worst(0x0000_0001..=f32::MAX.to_bits(), (9973, 199), |x| {
        let steps = [-30.3, -2.0, -0.7, -0.01, 0.003, 0.3, 1.0, 2.5, 19.9];
        let errors = steps.map(|y: f32| {
            let exact = f64::from(x).powf(f64::from(y));
            let is_number = exact > 1.2e-38 && exact < 3.3e38;
            let error = (f64::from(Fast(x).powf(Fast(y)).0) / exact - 1.0).abs() / (1.0 + exact.log2().abs());
            if is_number { error } else { 0.0 }
        });
        errors.into_iter().fold(0.0, f64::max)
    });
    println!("{found:?}");
    assert!(found.0 < 3e-5, "{found:?}");
}

#[test]
fn special_powers() {
    let numbers = [0.0, 1e-40, 0.5, 1.0, 2.0, 1e30, f32::INFINITY];
    let exponents = [f32::NEG_INFINITY, -1e30, -2.0, 0.0, 1e-40, 0.5, 2.0, 1e30, f32::INFINITY];
    for x in numbers {
        for y in exponents {
            let (found, expected) = (Fast(x).powf(Fast(y)).0, x.powf(y));
            let is_near = (found - expected).abs() <= 2e-4 * expected || expected < 1.2e-38 && found < 1.2e-38;
            assert!(found == expected || is_near, "{x} {y}: {found}, expected {expected}");
        }
    }
    for (x, y) in [(f32::NAN, 2.0), (2.0, f32::NAN), (-1.0, 2.0)] {
        assert!(Fast(x).powf(Fast(y)).0.is_nan(), "{x} {y}");
    }
}

#[test]
fn sines_and_cosines_are_as_good_as_stated() {
    let found = worst_of_both(1e9, (499, 1), |x| {
        let angle = (f64::from(x) - f64::from(x).round()) * TAU;
        let (sine, cosine) = Fast(x).sin_cos_turns();
        (f64::from(sine.0) - angle.sin()).abs().max((f64::from(cosine.0) - angle.cos()).abs())
    });
    assert_states(2.6e-5, found);
    for whole in [0.0, 1.0, 9999.0] {
        let at = |turns| Fast(turns).sin_cos_turns();
        assert_eq!(at(whole), (Fast(0.0), Fast(1.0)));
        assert_eq!(at(whole + 0.25), (Fast(1.0), Fast(0.0)));
        assert_eq!(at(whole + 0.5), (Fast(0.0), Fast(-1.0)));
        assert_eq!(at(-whole - 0.25), (Fast(-1.0), Fast(0.0)));
        assert_eq!(at(-whole - 0.1), (-at(whole + 0.1).0, at(whole + 0.1).1));
    }
}

/// The same on every target; found by this test.
const CHECKSUM: u32 = 0x04ff_c2e1;

#[test]
fn bits_are_those_of_every_target() {
    let (mut x, mut sum) = (1_u32, 0_u32);
    for _ in 0..20_000 {
        x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let wide = Fast(f32::from_bits(x));
        let near = Fast(f32::from_bits(0x3c00_0000 + (x >> 6)));
        let (sine, cosine) = near.sin_cos_turns();
        let all = [wide.sqrt(), wide.floor(), near.exp(), (-near).exp(), near.powf(Fast(2.2)), sine, cosine];
        for number in all.into_iter().filter(|number| !number.0.is_nan()) {
            sum = sum.rotate_left(5).wrapping_mul(0x9e37_79b1) ^ number.0.to_bits();
        }
    }
    assert_eq!(sum, CHECKSUM, "{sum:#x}");
}

type Buffer<T> = SceneBuf<T, 600, 8, 8>;

fn render<T: Real>(scene: &Scene<'_, f32>) -> Vec<[f32; 3]> {
    let buffer = Buffer::<T>::from_scene(scene, T::from_f32).unwrap();
    let scene = buffer.as_scene();
    let tracer = Tracer::<T, { Effects::ALL.bits() }, 10, 8>::try_new(&scene).unwrap();
    let mut pixels = [Rgb::BLACK; 48 * 36];
    let mut target = LinearRgb::new(Size::new(48, 36), &mut pixels).unwrap();
    Frame::new(&tracer, Settings::new(48, 36)).unwrap().render(&mut target).unwrap();
    pixels.iter().map(|color| [color.r, color.g, color.b]).collect()
}

/// Every built-in scene: the geometry is that of `f32`, to the bit, and only what attenuation, films and highlights weigh
/// differs.
#[test]
fn pictures_are_those_of_f32() {
    for (name, scene) in scenes::ALL {
        let (expected, found) = (render::<f32>(&scene), render::<Fast>(&scene));
        let pairs = expected.as_flattened().iter().zip(found.as_flattened());
        let largest = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        println!("{name:10} {largest:.1e}");
        assert!(largest < 2e-4, "{name}: {largest:e}");
    }
}
