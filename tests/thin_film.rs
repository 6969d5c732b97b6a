//! Thin films against tables of the exact reflectances and colours, and against the laws that they obey.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use whit::Rgb;
use whit::math::Complex;
use whit::optics::{Band, Coating, bands, thin_film};

const BANDS: [Band; 38] = bands();

/// A row of a table by the names of its columns, in `f64`; the first column names the case.
fn rows(table: &'static str) -> impl Iterator<Item = (&'static str, Vec<f64>)> {
    table.lines().skip(1).map(|line| {
        let (case, rest) = line.split_once(',').unwrap();
        (case, rest.split(',').map(|field| field.parse().unwrap()).collect())
    })
}

fn cosine(degrees: f64) -> f64 {
    degrees.to_radians().cos()
}

/// The transfer-matrix method for one coating, on every row, each input rounded to `f32`.
#[test]
fn reflectances_agree_with_the_transfer_matrix_method() {
    let (mut count, mut worst, mut worst_wide) = (0, 0.0_f64, 0.0_f64);
    for (_, row) in rows(include_str!("data/oracles/thinfilm_tmm.csv")) {
        let &[outer, film, eta, k, angle, thickness, wavelength, s, p, r] = row.as_slice() else { panic!("{row:?}") };
        let base = Complex::new(eta as f32, k as f32);
        let (rs, rp) =
            thin_film(outer as f32, film as f32, base, cosine(angle) as f32, thickness as f32, wavelength as f32);
        let (rs, rp) = (f64::from(rs), f64::from(rp));
        let mean = f64::midpoint(rs, rp) - r;
        worst = worst.max((rs - s).abs()).max((rp - p).abs()).max(mean.abs());
        let (rs, rp) = thin_film(outer, film, Complex::new(eta, k), cosine(angle), thickness, wavelength);
        worst_wide = worst_wide.max((rs - s).abs()).max((rp - p).abs());
        count += 1;
    }
    assert_eq!(count, 1008);
    assert!(worst < 1e-5, "{worst:e}");
    // The polynomials of the phase are good for 2.5e-8.
    assert!(worst_wide < 2e-7, "{worst_wide:e}");
}

/// How far a way to compute colours is from the integral over the spectrum.
#[derive(Debug, Default)]
struct Deviation {
    /// In CIELAB, by the formula of 1976 and by CIEDE2000.
    mean_1976: f64,
    max_1976: f64,
    max_2000: f64,
    /// Of a channel of linear Rec. 709.
    max_linear: f64,
}

/// Measures `way` of colour on the rows of the table up to an angle of incidence.
fn deviation(up_to_degrees: f64, way: impl Fn(&Coating<f32>, f32, f32) -> Rgb<f32>) -> Deviation {
    let mut sums = Deviation::default();
    let mut count = 0.0;
    for (case, row) in rows(include_str!("data/oracles/thinfilm_rgb.csv")) {
        let &[angle, thickness, r, g, b] = row.as_slice() else { panic!("{row:?}") };
        if angle > up_to_degrees {
            continue;
        }
        let colour = way(&coating(case), cosine(angle) as f32, thickness as f32).map(f64::from);
        let (a, b) = ([colour.r, colour.g, colour.b], [r, g, b]);
        let (difference_1976, difference_2000) = differences(lab(a), lab(b));
        sums.mean_1976 += difference_1976;
        sums.max_1976 = sums.max_1976.max(difference_1976);
        sums.max_2000 = sums.max_2000.max(difference_2000);
        for (a, b) in a.into_iter().zip(b) {
            sums.max_linear = sums.max_linear.max((a - b).abs());
        }
        count += 1.0;
    }
    sums.mean_1976 /= count;
    sums
}

fn coating(case: &str) -> Coating<f32> {
    let (film, eta, k) = match case {
        "soap air/1.33/air" => (1.33, 1.0, 0.0),
        "oil air/1.5/water" => (1.5, 1.33, 0.0),
        "coating air/1.38/glass" => (1.38, 1.52, 0.0),
        "air/1.5/metal(0.27+2.95i)" => (1.5, 0.27, 2.95),
        other => panic!("{other}"),
    };
    Coating { outer: 1.0, film, base: Rgb::grey(Complex::new(eta, k)) }
}

/// CIELAB of linear Rec. 709 with its own white. Nothing is clipped: below zero the cube root is its tangent, as for
/// dark colours.
fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
    let x = 0.4124564 * r + 0.3575761 * g + 0.1804375 * b;
    let y = 0.2126729 * r + 0.7151522 * g + 0.0721750 * b;
    let z = 0.0193339 * r + 0.1191920 * g + 0.9503041 * b;
    let f = |t: f64| if t > (6.0_f64 / 29.0).powi(3) { t.cbrt() } else { t * (841.0 / 108.0) + 4.0 / 29.0 };
    let (x, y, z) = (f(x / 0.95047), f(y), f(z / 1.08883));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// ΔE*ab of 1976, and ΔE00 after Sharma, Wu and Dalal (2005).
fn differences(p: [f64; 3], q: [f64; 3]) -> (f64, f64) {
    let euclidean = p.iter().zip(q).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    let mean_chroma = f64::midpoint(p[1].hypot(p[2]), q[1].hypot(q[2]));
    let seventh = |c: f64| (c.powi(7) / (c.powi(7) + 25_f64.powi(7))).sqrt();
    let stretch = 1.0 + 0.5 * (1.0 - seventh(mean_chroma));
    let polar = |c: [f64; 3]| {
        let a = c[1] * stretch;
        (a.hypot(c[2]), c[2].atan2(a).to_degrees().rem_euclid(360.0))
    };
    let ((c1, h1), (c2, h2)) = (polar(p), polar(q));
    let turn = if c1 * c2 == 0.0 { 0.0 } else { (h2 - h1 + 180.0).rem_euclid(360.0) - 180.0 };
    let hue = 2.0 * (c1 * c2).sqrt() * (turn / 2.0).to_radians().sin();
    let mean_hue = if c1 * c2 == 0.0 { h1 + h2 } else { h1 + turn / 2.0 };
    let (l, c) = (f64::midpoint(p[0], q[0]), f64::midpoint(c1, c2));
    let wave = |factor: f64, shift: f64| (factor * mean_hue + shift).to_radians().cos();
    let t = 1.0 - 0.17 * wave(1.0, -30.0) + 0.24 * wave(2.0, 0.0) + 0.32 * wave(3.0, 6.0) - 0.2 * wave(4.0, -63.0);
    let from_275 = (mean_hue.rem_euclid(360.0) - 275.0) / 25.0;
    let rotation = -2.0 * seventh(c) * (60.0 * (-from_275 * from_275).exp()).to_radians().sin();
    let light = (l - 50.0) * (l - 50.0);
    let dl = (q[0] - p[0]) / (1.0 + 0.015 * light / (20.0 + light).sqrt());
    let dc = (c2 - c1) / (1.0 + 0.045 * c);
    let dh = hue / (1.0 + 0.015 * c * t);
    (euclidean, (dl * dl + dc * dc + dh * dh + rotation * dc * dh).sqrt())
}

/// Pairs 1, 7, 16, 17 and 25 of the test data of Sharma, Wu and Dalal (2005, table 1).
#[test]
fn colour_differences_agree_with_published_values() {
    for (p, q, expected) in [
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
        ([50.0, 2.5, 0.0], [50.0, 0.0, -2.5], 4.3065),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
        ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
    ] {
        let (_, difference) = differences(p, q);
        assert!((difference - expected).abs() < 1e-4, "{difference} {expected}");
    }
}

fn assert_near(measured: f64, expected: f64) {
    assert!((measured / expected - 1.0).abs() < 0.02, "{measured}, not {expected}");
}

/// Below 1, where no eye sees a difference, in every row and by both formulas.
#[test]
fn bands_give_the_integrated_colour() {
    let all = deviation(90.0, |coating, c, d| coating.by_bands(c, d, &BANDS));
    assert!(all.max_1976 < 1.0 && all.max_2000 < 1.0, "{all:?}");
    assert_near(all.mean_1976, 0.0553);
    assert_near(all.max_1976, 0.670);
    assert_near(all.max_2000, 0.732);
    assert_near(all.max_linear, 0.0113);
}

/// It is the sharp fringes of the metal at grazing incidence that need so many.
#[test]
fn half_the_bands_do_up_to_75_degrees() {
    const FEWER: [Band; 18] = bands();
    let steep = deviation(75.0, |coating, c, d| coating.by_bands(c, d, &FEWER));
    assert!(steep.max_1976 < 1.0 && steep.max_2000 < 1.0, "{steep:?}");
}

#[test]
fn the_table_gives_the_integrated_colour() {
    let all = deviation(90.0, |coating, c, d| coating.by_table(c, d));
    assert_near(all.mean_1976, 0.0174);
    assert_near(all.max_1976, 0.210);
    assert_near(all.max_2000, 0.221);
    assert_near(all.max_linear, 0.00228);
}

#[test]
fn three_wavelengths_are_far_off() {
    let all = deviation(90.0, |coating, c, d| coating.by_wavelengths(c, d));
    assert_near(all.mean_1976, 7.57);
    assert_near(all.max_1976, 64.6);
    assert_near(all.max_2000, 26.4);
    assert_near(all.max_linear, 0.567);
}

/// Numbers in [0, 1), the same in each run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f64 / (1_u64 << 24) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Outer and film index, base, cosine, thickness. Half of the bases are dielectrics, so that all kinds of total
    /// reflection come up.
    fn stack(&mut self) -> (f64, f64, Complex<f64>, f64, f64) {
        let (outer, film, eta) = (self.between(1.0, 2.5), self.between(1.0, 2.5), self.between(0.1, 2.5));
        let k = if self.next() < 0.5 { 0.0 } else { self.between(0.0, 5.0) };
        let eta = if k == 0.0 { eta.max(1.0) } else { eta };
        (outer, film, Complex::new(eta, k), self.next(), self.between(0.0, 2000.0))
    }
}

fn narrow(z: Complex<f64>) -> Complex<f32> {
    Complex::new(z.re as f32, z.im as f32)
}

#[test]
fn reflectances_are_fractions_everywhere() {
    let mut numbers = Numbers(1);
    let extremes = [0.0, 1e-30, 1e-12, 1e-4, 0.5, 1.0_f32];
    for i in 0..100_000 {
        let (outer, film, base, cosine, thickness) = numbers.stack();
        let (mut cosine, mut thickness) = (cosine as f32, thickness as f32);
        let (mut outer, film, base) = (outer as f32, film as f32, narrow(base));
        if i % 4 == 0 {
            cosine = extremes[i / 4 % 6];
            thickness = [0.0, 1e-20, 500.0, 1e9][i / 24 % 4];
        }
        if i % 5 == 0 {
            outer = [film, base.re][i / 5 % 2];
        }
        let (s, p) = thin_film(outer, film, base, cosine, thickness, 550.0);
        let place = (outer, film, base, cosine, thickness);
        assert!((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&p), "{place:?}: {s} {p}");
        let coating = Coating { outer, film, base: Rgb::grey(base) };
        for colour in [
            coating.by_wavelengths(cosine, thickness),
            coating.by_table(cosine, thickness),
            coating.by_bands(cosine, thickness, &BANDS),
        ] {
            for channel in [colour.r, colour.g, colour.b] {
                assert!((-0.1..=1.15).contains(&channel), "{place:?}: {colour:?}");
            }
        }
        assert!(cosine > 0.0 || (s, p) == (1.0, 1.0), "{place:?}");
    }
}

/// The Fresnel equations in their textbook form.
#[test]
fn a_film_of_no_thickness_is_not_there() {
    let mut numbers = Numbers(2);
    for _ in 0..10_000 {
        let (outer, film, base, cosine, _) = numbers.stack();
        let (s, p) = thin_film(outer, film, base, cosine, 0.0, 550.0);
        let tangential = outer * outer * (1.0 - cosine * cosine);
        let root = (base * base - Complex::real(tangential)).sqrt();
        let square = base * base * (cosine / outer);
        let incident = Complex::real(outer * cosine);
        let rs = ((incident - root) / (incident + root)).norm_squared();
        let rp = ((square - root) / (square + root)).norm_squared();
        assert!((s - rs).abs() < 1e-12 && (p - rp).abs() < 1e-12, "{s} {rs} {p} {rp}");
    }
}

#[test]
fn polarisations_are_equal_at_normal_incidence() {
    let mut numbers = Numbers(3);
    for _ in 0..10_000 {
        let (outer, film, base, _, thickness) = numbers.stack();
        let (s, p) = thin_film(outer, film, base, 1.0, thickness, 550.0);
        assert!((s - p).abs() < 1e-13, "{s} {p}");
    }
}

/// Away from critical angles, where the rounding of the angle alone is worth more.
#[test]
fn f32_agrees_with_f64() {
    let mut numbers = Numbers(4);
    let mut worst = 0.0_f64;
    for _ in 0..100_000 {
        let (outer, film, base, cosine, thickness) = numbers.stack();
        let (outer, film, cosine, thickness) = (outer as f32, film as f32, cosine as f32, thickness as f32);
        let base = narrow(base);
        let tangential = outer * outer * (1.0 - cosine * cosine);
        let near = |n: f32| (n * n - tangential).abs() < 0.05;
        if near(film) || (base.im < 0.1 && near(base.re)) {
            continue;
        }
        let (s, p) = thin_film(outer, film, base, cosine, thickness, 550.0);
        let wide = Complex::new(f64::from(base.re), f64::from(base.im));
        let (exact_s, exact_p) =
            thin_film(f64::from(outer), f64::from(film), wide, f64::from(cosine), f64::from(thickness), 550.0);
        worst = worst.max((f64::from(s) - exact_s).abs()).max((f64::from(p) - exact_p).abs());
    }
    assert!(worst < 1e-4, "{worst:e}");
}

/// Light that goes the other way through a lossless film, along the same rays, is reflected as much.
#[test]
fn reflection_is_the_same_from_both_sides() {
    let mut numbers = Numbers(5);
    let mut count = 0;
    for _ in 0..20_000 {
        let (outer, film, base, cosine, thickness) = numbers.stack();
        let below = 1.0 - (outer / base.re).powi(2) * (1.0 - cosine * cosine);
        if base.im > 0.0 || below <= 1e-6 {
            continue;
        }
        count += 1;
        let forth = thin_film(outer, film, base, cosine, thickness, 550.0);
        let back = thin_film(base.re, film, Complex::real(outer), below.sqrt(), thickness, 550.0);
        assert!((forth.0 - back.0).abs() < 1e-9 && (forth.1 - back.1).abs() < 1e-9, "{forth:?} {back:?}");
    }
    assert!(count > 5000, "{count}");
}

/// At normal incidence, a film of a quarter wavelength turns the base's index n₂ into n₁²/n₂.
#[test]
fn quarter_waves_have_their_closed_form() {
    for (outer, film, base) in [(1.0_f64, 1.38, 1.52), (1.0, 2.4, 1.5), (1.33, 1.6, 1.33), (1.0, 1.2247, 1.5)] {
        let (s, p) = thin_film(outer, film, Complex::real(base), 1.0, 550.0 / (4.0 * film), 550.0);
        let root = (outer * base - film * film) / (outer * base + film * film);
        assert!((s - root * root).abs() < 1e-13 && (p - root * root).abs() < 1e-13, "{s} {p}");
    }
}

/// Beyond the base's critical angle nothing gets through, whatever the film.
#[test]
fn total_reflection_at_the_base_is_total() {
    for film in [1.2_f32, 1.5, 2.0] {
        for i in 1..700 {
            let cosine = i as f32 / 1000.0;
            for thickness in [0.0, 30.0, 400.0, 1900.0] {
                let (s, p) = thin_film(1.5, film, Complex::real(1.0), cosine, thickness, 550.0);
                assert!(s > 1.0 - 1e-6 && p > 1.0 - 1e-6, "{film} {cosine} {thickness}: {s} {p}");
            }
        }
    }
}

/// Frustrated total reflection by a gap of air in glass: 1/T = 1 + ((a² + β²)/(2aβ))²·sinh² κ, with the admittances
/// a of the glass and iβ of the gap (after Zhu, Yu, Hawley and Roy 1986, *Frustrated total internal reflection*).
#[test]
fn gaps_frustrate_total_reflection() {
    let glass = 1.5_f64;
    for i in 1..740 {
        let cosine = f64::from(i) / 1000.0;
        let beta = (glass * glass * (1.0 - cosine * cosine) - 1.0).sqrt();
        for gap in [1.0, 20.0, 87.0, 88.0, 250.0, 1000.0] {
            let (s, p) = thin_film(glass, 1.0, Complex::real(glass), cosine, gap, 550.0);
            let sinh = (std::f64::consts::TAU * beta * gap / 550.0).sinh();
            for (reflectance, a) in [(s, glass * cosine), (p, cosine / glass)] {
                let excess = ((a * a + beta * beta) / (2.0 * a * beta) * sinh).powi(2);
                assert!((reflectance - excess / (1.0 + excess)).abs() < 1e-6, "{cosine} {gap}: {reflectance}");
            }
        }
    }
}

/// The table's way agrees with many bands through both critical angles, where the series converges slowly and ends.
#[test]
fn the_table_agrees_with_bands_through_critical_angles() {
    const MANY: [Band; 128] = bands();
    let mut worst = 0.0_f32;
    for (outer, film, base) in [(1.5, 1.0, 1.5), (1.5, 1.0, 1.33), (1.5, 1.33, 1.0), (1.0, 2.4, 1.0)] {
        let coating = Coating { outer, film, base: Rgb::grey(Complex::real(base)) };
        for i in 1..1000 {
            for thickness in [10.0, 60.0, 200.0, 700.0] {
                let cosine = i as f32 / 1000.0;
                let (a, b) = (coating.by_table(cosine, thickness), coating.by_bands(cosine, thickness, &MANY));
                let difference = (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs());
                worst = worst.max(difference);
            }
        }
    }
    assert!(worst < 0.008, "{worst}");
}

/// A base that is the same in all channels takes a shorter way to the same colour; one that is not is interpolated.
#[test]
fn bases_may_differ_between_channels() {
    let (a, b) = (Complex::new(0.2_f32, 3.1), Complex::new(1.4, 1.8));
    let alike = Coating { outer: 1.0, film: 1.5, base: Rgb::grey(a) };
    let unlike = Coating { base: Rgb::new(a, b, a), ..alike };
    let green = Coating { base: Rgb::grey(b), ..alike };
    assert_eq!(unlike.by_wavelengths(0.7, 300.0).r, alike.by_wavelengths(0.7, 300.0).r);
    assert_eq!(unlike.by_wavelengths(0.7, 300.0).g, green.by_wavelengths(0.7, 300.0).g);
    // The number of terms is that of the channel that needs most.
    assert!((unlike.by_table(0.7, 300.0).b - alike.by_table(0.7, 300.0).b).abs() < 1e-4);
    assert!((unlike.by_table(0.7, 300.0).g - green.by_table(0.7, 300.0).g).abs() < 1e-4);

    let band = |wavelength| [Band { wavelength, weight: Rgb::WHITE }];
    for (wavelength, expected) in [(400.0, alike), (464.2, alike), (549.1, green), (611.4, alike), (700.0, alike)] {
        let difference =
            unlike.by_bands(0.7, 300.0, &band(wavelength)).r - expected.by_bands(0.7, 300.0, &band(wavelength)).r;
        assert!(difference.abs() < 1e-6, "{wavelength}");
    }
    let red = Coating { base: Rgb::new(b, a, a), ..alike };
    assert_eq!(red.by_bands(0.7, 300.0, &band(700.0)), green.by_bands(0.7, 300.0, &band(700.0)));

    let half = Coating { base: Rgb::grey(Complex::new(0.8, 2.45)), ..alike };
    let middle = f32::midpoint(549.1, 611.4);
    let difference = unlike.by_bands(0.7, 300.0, &band(middle)).r - half.by_bands(0.7, 300.0, &band(middle)).r;
    assert!(difference.abs() < 1e-6);
}
