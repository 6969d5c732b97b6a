//! From wavelengths, in nanometres, to linear red, green and blue.

use std::sync::LazyLock;

use super::complex::Complex;
use super::vector::Color;

/// The wavelengths that stand for red, green and blue.
pub const CHANNELS: [f64; 3] = [611.4, 549.1, 464.2];

/// What is known at the wavelengths of the channels, at another one: linear between them, constant outside.
pub fn interpolate([red, green, blue]: [Complex; 3], wavelength: f64) -> Complex {
    let between = |(low_end, low): (f64, Complex), (high_end, high): (f64, Complex)| {
        let t = ((wavelength - low_end) / (high_end - low_end)).clamp(0.0, 1.0);
        low * (1.0 - t).into() + high * t.into()
    };
    let [at_red, at_green, at_blue] = CHANNELS;
    if wavelength < at_green {
        between((at_blue, blue), (at_green, green))
    } else {
        between((at_green, green), (at_red, red))
    }
}

/// Wavelengths, each with what light of it adds to linear sRGB. Light of all of them, equally strong, is (1, 1, 1).
pub fn daylight() -> &'static [(f64, Color)] {
    static WEIGHTS: LazyLock<Vec<(f64, Color)>> = LazyLock::new(weights);
    &WEIGHTS
}

/// The colour matching functions of the CIE 1931 2° standard observer, every 5 nm from 380 to 780.
const OBSERVER: &str = include_str!("cie1931.csv");
const FIRST: u32 = 380;
const LAST: u32 = 780;
const STEP: u32 = 5;

/// IEC 61966-2-1.
const XYZ_TO_SRGB: [[f64; 3]; 3] = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

/// Every nanometre.
fn weights() -> Vec<(f64, Color)> {
    let rows: Vec<[f64; 3]> = OBSERVER
        .lines()
        .skip(1)
        .map(|line| {
            let values: Vec<f64> = line.split(',').skip(1).map(|value| value.parse().unwrap()).collect();
            [values[0], values[1], values[2]]
        })
        .collect();
    let colors: Vec<(f64, Color)> = (FIRST..=LAST)
        .map(|wavelength| {
            let xyz = observer(&rows, f64::from(wavelength - FIRST) / f64::from(STEP));
            let channel = |row: [f64; 3]| (0..3).map(|i| row[i] * xyz[i]).sum();
            (f64::from(wavelength), Color(XYZ_TO_SRGB.map(channel)))
        })
        .collect();
    let white = colors.iter().fold(Color::BLACK, |sum, &(_, color)| sum + color).map(f64::recip);
    colors.into_iter().map(|(wavelength, color)| (wavelength, color * white)).collect()
}

/// Between the rows: the cubic through the four nearest ones.
fn observer(rows: &[[f64; 3]], place: f64) -> [f64; 3] {
    let first = (place as usize).saturating_sub(1).min(rows.len() - 4);
    let at = |row: usize| (first + row) as f64;
    let weight = |row: usize| -> f64 {
        (0..4).filter(|&other| other != row).map(|other| (place - at(other)) / (at(row) - at(other))).product()
    };
    [0, 1, 2].map(|i| (0..4).map(|row| weight(row) * rows[first + row][i]).sum())
}
