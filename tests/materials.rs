//! The optical constants against rows of published tables and against values that are conventional elsewhere.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use whit::Rgb;
use whit::optics::materials::{
    ACRYLIC, ALUMINIUM, CHROMIUM, COPPER, CROWN_GLASS, Conductor, DIAMOND, FLINT_GLASS, FUSED_QUARTZ, GOLD, ICE, IRON,
    MAGNESIUM_FLUORIDE, OLIVE_OIL, SEAWATER, SILVER, SOAP_FILM, TITANIUM, TITANIUM_DIOXIDE, WATER, WATER_EXTINCTION,
    dispersive,
};
use whit::optics::normal_reflectance;

const CHANNELS: [f64; 3] = [611.4, 549.1, 464.2];
const SODIUM: f64 = 589.3;

const METALS: [(&str, Conductor); 7] = [
    ("aluminium", ALUMINIUM),
    ("silver", SILVER),
    ("gold", GOLD),
    ("copper", COPPER),
    ("iron", IRON),
    ("chromium", CHROMIUM),
    ("titanium", TITANIUM),
];

/// The columns after the name in the rows of `material`, or of all where the first column is a number.
fn rows<const N: usize>(table: &str, material: &str) -> Vec<[f64; N]> {
    let of_material = table.lines().filter_map(|line| line.strip_prefix(material));
    of_material.filter_map(|line| numbers(line.trim_start_matches(','))).collect()
}

fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    let fields: Option<Vec<f64>> = line.split(',').map(|field| field.parse().ok()).collect();
    fields?.try_into().ok()
}

/// Linear between the two rows around `x`; the first column is in units of `unit`.
fn interpolate<const N: usize>(rows: &[[f64; N]], unit: f64, x: f64, column: usize) -> f64 {
    let pair = rows.windows(2).find(|pair| pair[0][0] * unit <= x && x <= pair[1][0] * unit).unwrap();
    let t = (x - pair[0][0] * unit) / ((pair[1][0] - pair[0][0]) * unit);
    pair[0][column] + t * (pair[1][column] - pair[0][column])
}

fn array(colour: Rgb<f32>) -> [f64; 3] {
    [colour.r, colour.g, colour.b].map(f64::from)
}

#[test]
fn metals_are_interpolated_from_their_tables() {
    for (name, metal) in METALS {
        let table: Vec<[f64; 3]> = rows(include_str!("data/materials/metals.csv"), name);
        for (i, wavelength) in CHANNELS.into_iter().enumerate() {
            let index = interpolate(&table, 1000.0, wavelength, 1);
            let extinction = interpolate(&table, 1000.0, wavelength, 2);
            assert!((array(metal.index)[i] - index).abs() < 6e-5, "{name} at {wavelength}: η = {index}");
            assert!((array(metal.extinction)[i] - extinction).abs() < 6e-5, "{name} at {wavelength}: k = {extinction}");
        }
    }
}

#[test]
fn reflectance_of_metals_is_that_of_exact_arithmetic() {
    let table = include_str!("data/materials/normal_reflectance.csv");
    let rows: Vec<[f64; 3]> = table.lines().filter_map(|line| numbers(line.splitn(3, ',').nth(2)?)).collect();
    assert_eq!(rows.len(), 8);
    for [n, k, reflectance] in rows {
        let metal = Conductor { index: Rgb::grey(n as f32), extinction: Rgb::grey(k as f32) };
        let Rgb { r, g, b } = metal.normal_reflectance();
        assert!((f64::from(r) - reflectance).abs() < 2e-7, "{n} + {k}i: {r} {reflectance}");
        assert!(r == g && g == b);
    }
}

/// The linear Rec. 709 colours of Lagarde, "Feeding a physically based shading model" (2011), which are integrals over
/// the spectrum, some of other measurements, clipped to 1.
#[test]
fn colours_of_metals_are_near_the_conventional_ones() {
    let conventional = [
        [0.913, 0.921, 0.925],
        [0.972, 0.960, 0.915],
        [1.000, 0.766, 0.336],
        [0.955, 0.637, 0.538],
        [0.560, 0.570, 0.580],
        [0.550, 0.556, 0.554],
        [0.542, 0.497, 0.449],
    ];
    for ((name, metal), expected) in METALS.into_iter().zip(conventional) {
        for (channel, expected) in array(metal.normal_reflectance()).into_iter().zip(expected) {
            assert!((channel - expected).abs() < 0.1, "{name}: {channel} {expected}");
        }
    }
}

/// The values of R₀ in the documentation.
#[test]
fn reflectances_are_as_documented() {
    for (name, metal, documented) in [
        ("aluminium", ALUMINIUM, [0.910, 0.915, 0.921]),
        ("silver", SILVER, [0.989, 0.985, 0.977]),
        ("gold", GOLD, [0.946, 0.839, 0.349]),
        ("copper", COPPER, [0.965, 0.651, 0.557]),
        ("iron", IRON, [0.526, 0.512, 0.500]),
        ("chromium", CHROMIUM, [0.552, 0.555, 0.558]),
        ("titanium", TITANIUM, [0.607, 0.582, 0.548]),
    ] {
        for (channel, documented) in array(metal.normal_reflectance()).into_iter().zip(documented) {
            assert!((channel - documented).abs() < 5.1e-4, "{name}: {channel} {documented}");
        }
    }
    for (index, documented) in [
        (WATER, 0.020),
        (SEAWATER, 0.021),
        (ICE, 0.018),
        (FUSED_QUARTZ, 0.035),
        (CROWN_GLASS, 0.042),
        (FLINT_GLASS, 0.071),
        (DIAMOND, 0.172),
        (ACRYLIC, 0.039),
        (SOAP_FILM, 0.020),
        (OLIVE_OIL, 0.036),
        (MAGNESIUM_FLUORIDE, 0.025),
        (TITANIUM_DIOXIDE, 0.171),
    ] {
        let reflectance = normal_reflectance(1.0, index);
        assert!((reflectance - documented).abs() < 5.1e-4, "{index}: {reflectance} {documented}");
    }
}

/// `tolerance` is the error of the fit that the documentation states, or the rounding of a formula that is not fitted.
#[test]
fn formulas_give_the_values_of_their_sources() {
    let table = include_str!("data/materials/dielectrics.csv");
    let check = |name: &str, index: &dyn Fn(f64) -> f64, tolerance: f64| {
        let rows: Vec<[f64; 2]> = rows(table, name);
        assert!(rows.len() >= 9, "{name}");
        for [micrometres, published] in rows {
            let index = index(micrometres * 1000.0);
            assert!((index - published).abs() < tolerance, "{name} at {micrometres} µm: {index} {published}");
        }
    };
    check("crown_glass", &|nm| dispersive::CROWN_GLASS.index(nm), 1e-7);
    check("flint_glass", &|nm| dispersive::FLINT_GLASS.index(nm), 1e-7);
    check("fused_quartz", &|nm| dispersive::FUSED_QUARTZ.index(nm), 1e-7);
    check("diamond", &|nm| dispersive::DIAMOND.index(nm), 1e-7);
    check("water", &|nm| dispersive::WATER.index(nm), 6e-6);
    check("ice", &|nm| dispersive::ICE.index(nm), 1.2e-4);
    check("acrylic", &|nm| dispersive::ACRYLIC.index(nm), 4e-5);
}

#[test]
fn single_indices_are_those_of_the_sodium_line() {
    let table = include_str!("data/materials/dielectrics.csv");
    for (name, index) in [
        ("water", WATER),
        ("ice", ICE),
        ("fused_quartz", FUSED_QUARTZ),
        ("crown_glass", CROWN_GLASS),
        ("flint_glass", FLINT_GLASS),
        ("diamond", DIAMOND),
        ("acrylic", ACRYLIC),
        ("titanium_dioxide", TITANIUM_DIOXIDE),
    ] {
        let published = interpolate(&rows::<2>(table, name), 1000.0, SODIUM, 1);
        assert!((f64::from(index) - published).abs() < 6e-5, "{name}: {index} {published}");
    }
    let [[_, fluoride]] = rows::<2>(table, "magnesium_fluoride")[..] else { panic!("one row") };
    assert!((f64::from(MAGNESIUM_FLUORIDE) - fluoride).abs() < 6e-5);
}

/// The formula of Quan and Fry (1995), for S in ‰, T in °C and λ in nanometres.
#[test]
fn seawater_has_the_index_of_its_formula() {
    let (s, t, l) = (35.0_f64, 20.0_f64, SODIUM);
    let index = 1.31405 + (1.779e-4 - 1.05e-6 * t + 1.6e-8 * t * t) * s - 2.02e-6 * t * t
        + (15.868 + 0.01155 * s - 0.00423 * t) / l
        - 4382.0 / (l * l)
        + 1.1455e6 / (l * l * l);
    assert!((f64::from(SEAWATER) - index).abs() < 6e-5, "{index}");
}

#[test]
fn absorption_of_water_is_interpolated_from_its_table() {
    let table: Vec<[f64; 2]> = rows(include_str!("data/materials/water_absorption.csv"), "");
    for (extinction, wavelength) in array(WATER_EXTINCTION).into_iter().zip(CHANNELS) {
        let published = interpolate(&table, 1.0, wavelength, 1);
        assert!((extinction - published).abs() < 6e-4 * published, "{wavelength}: {extinction} {published}");
    }
}
