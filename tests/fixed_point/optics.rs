//! The functions of optics against the same in `f64`.
//!
//! The bounds are a little above what is seen, in units in the last place of the number type.

use whit::math::{Complex, Q16, Q20};
use whit::optics::{Coating, bands, fresnel_conductor, fresnel_dielectric, transmittance};
use whit::{Real, Rgb};

const COSINES: u32 = 500;

/// The largest error of a function of a cosine from 0.002 to 1, in units in the last place. The cosine is a number of the type.
fn worst<T: Real>(f: impl Fn(T) -> Vec<T>, exact: impl Fn(f64) -> Vec<f64>) -> f64 {
    let mut worst = 0.0_f64;
    for i in 1..=COSINES {
        let cosine = T::from_f32(i as f32 / COSINES as f32);
        for (found, exact) in f(cosine).into_iter().zip(exact(cosine.to_f32().into())) {
            worst = worst.max((f64::from(found.to_f32()) - exact).abs() / f64::from(T::SMALLEST.to_f32()));
        }
    }
    worst
}

fn wide<T: Real>(x: f32) -> f64 {
    T::from_f32(x).to_f32().into()
}

fn dielectric<T: Real>(n1: f32, n2: f32) -> f64 {
    let (a, b) = (wide::<T>(n1), wide::<T>(n2));
    let far_from_critical = |cosine: f64| (b * b / (a * a) - 1.0 + cosine * cosine).abs() > 1e-3;
    worst::<T>(
        |cosine| {
            if !far_from_critical(cosine.to_f32().into()) {
                return vec![];
            }
            match fresnel_dielectric(T::from_f32(n1), T::from_f32(n2), cosine) {
                Some((share, transmitted)) => vec![share.mean(), transmitted],
                None => vec![T::ONE, T::ZERO],
            }
        },
        |cosine| match fresnel_dielectric(a, b, cosine) {
            Some((share, transmitted)) => vec![share.mean(), transmitted],
            None => vec![1.0, 0.0],
        },
    )
}

fn conductor<T: Real>(n: f32, k: f32) -> f64 {
    let (index, extinction) = (wide::<T>(n), wide::<T>(k));
    worst::<T>(
        |cosine| vec![fresnel_conductor(T::from_f32(n), T::from_f32(k), cosine).mean()],
        |cosine| vec![fresnel_conductor(index, extinction, cosine).mean()],
    )
}

fn coating<T: Real>(outer: f32, film: f32, base: (f32, f32)) -> Coating<T> {
    let c = T::from_f32;
    Coating { outer: c(outer), film: c(film), base: Rgb::grey(Complex::new(c(base.0), c(base.1))) }
}

/// The same coating in `f64`, of the numbers that `T` has.
fn same<T: Real>(outer: f32, film: f32, base: (f32, f32)) -> Coating<f64> {
    let base = Complex::new(wide::<T>(base.0), wide::<T>(base.1));
    Coating { outer: wide::<T>(outer), film: wide::<T>(film), base: Rgb::grey(base) }
}

fn channels<T>(Rgb { r, g, b }: Rgb<T>) -> Vec<T> {
    vec![r, g, b]
}

/// How a coating's colour comes about.
#[derive(Clone, Copy, Debug)]
enum Way {
    Wavelengths,
    Bands,
    Table,
}

fn colour<T: Real>(way: Way, coating: &Coating<T>, cosine: T, thickness: T) -> Vec<T> {
    channels(match way {
        Way::Wavelengths => coating.by_wavelengths(cosine, thickness),
        Way::Bands => coating.by_bands(cosine, thickness, &bands::<12>()),
        Way::Table => coating.by_table(cosine, thickness),
    })
}

fn film<T: Real>(way: Way, (outer, film, base): (f32, f32, (f32, f32)), thickness: f32) -> f64 {
    let (found, exact) = (coating::<T>(outer, film, base), same::<T>(outer, film, base));
    worst::<T>(
        |cosine| colour(way, &found, cosine, T::from_f32(thickness)),
        |cosine| colour(way, &exact, cosine, wide::<T>(thickness)),
    )
}

const SOAP: (f32, f32, (f32, f32)) = (1.0, 1.33, (1.0, 0.0));
const OIL: (f32, f32, (f32, f32)) = (1.0, 1.47, (1.33, 0.0));
const OXIDE: (f32, f32, (f32, f32)) = (1.0, 2.4, (2.7, 3.8));

/// The reflectance and the cosine behind the surface, but where the radicand is within 1e-3 of the critical angle's 0.
#[test]
fn dielectrics() {
    for (n1, n2, most) in [
        (1.0, 1.5, 3.0),
        (1.33, 1.5, 9.0),
        (1.0, 2.4, 3.0),
        (1.0, 4.0, 3.0),
        (0.5, 4.0, 3.0),
        // At small cosines all of the reflectance is in the difference of the indices.
        (1.5, 1.51, 80.0),
        // Next to the critical angle.
        (1.5, 1.0, 48.0),
        (2.4, 1.0, 28.0),
        (4.0, 1.0, 12.0),
    ] {
        let seen = [dielectric::<Q16>(n1, n2), dielectric::<Q20>(n1, n2)];
        assert!(seen.into_iter().all(|error| error <= most), "{n1} {n2}: {seen:?}");
    }
}

#[test]
fn conductors() {
    for (n, k) in [(0.2, 3.4), (0.05, 4.0), (1.4, 7.0), (2.7, 3.8), (3.1, 3.3), (12.0, 12.0), (24.0, 24.0)] {
        let seen = [conductor::<Q16>(n, k), conductor::<Q20>(n, k)];
        assert!(seen.into_iter().all(|error| error <= 2.0), "{n} {k}: {seen:?}");
    }
}

/// Films of soap, of oil on water and of oxide on titanium. The table's series ends where the rest is below 1e-4, which is not
/// the same term for all number types.
#[test]
fn films() {
    for (way, most) in [(Way::Wavelengths, [16.0; 2]), (Way::Bands, [36.0; 2]), (Way::Table, [24.0, 128.0])] {
        for case in [SOAP, OIL, OXIDE] {
            for thickness in [20.0, 100.0, 380.0, 900.0] {
                let seen = [film::<Q16>(way, case, thickness), film::<Q20>(way, case, thickness)];
                let is_held = seen[0] <= most[0] && seen[1] <= most[1];
                assert!(is_held, "{way:?} {case:?} {thickness}: {seen:?}");
            }
        }
    }
}

/// The share of light behind a way in a medium.
#[test]
fn attenuation() {
    for constant in [0.0, 0.01, 0.3, 2.0, 40.0] {
        let of = |x: f32| 20.0 * x;
        let error = |seen: f64| assert!(seen <= 1.0, "{constant}: {seen}");
        error(attenuated::<Q16>(constant, of));
        error(attenuated::<Q20>(constant, of));
    }
}

fn attenuated<T: Real>(constant: f32, distance: impl Fn(f32) -> f32) -> f64 {
    let (c, exact) = (Rgb::grey(T::from_f32(constant)), Rgb::grey(wide::<T>(constant)));
    worst::<T>(
        |x| vec![transmittance(c, T::from_f32(distance(x.to_f32()))).r],
        |x| vec![transmittance(exact, wide::<T>(distance(x as f32))).r],
    )
}
