//! Thin films: light reflected by the two faces of a film interferes.

use whit::scene::{Film, Spectrum, Thickness};

use super::complex::Complex;
use super::spectrum::{CHANNELS, daylight, interpolate};
use super::vector::{Color, Vector};

/// What is behind a film: its index of refraction at the wavelengths of red, green and blue.
pub type Base = [Complex; 3];

/// The reflectance per channel, held between 0 and 1, for light from a medium of index `outer` that arrives at an angle
/// of that cosine.
pub fn reflectance(film: &Film<f32>, point: Vector, outer: f64, cosine: f64, base: Base) -> Color {
    let thickness = thickness(&film.thickness, point);
    let at = |wavelength, base| airy(outer, cosine, film.index.into(), thickness, base, wavelength);
    let color = match film.spectrum {
        Spectrum::Wavelengths => Color([0, 1, 2].map(|i| at(CHANNELS[i], base[i]))),
        Spectrum::Bands(bands) => bands.iter().fold(Color::BLACK, |sum, band| {
            let wavelength = band.wavelength.into();
            sum + Color::from(band.weight) * at(wavelength, interpolate(base, wavelength))
        }),
        Spectrum::Table => daylight().iter().fold(Color::BLACK, |sum, &(wavelength, weight)| {
            sum + weight * at(wavelength, interpolate(base, wavelength))
        }),
    };
    color.map(|channel| channel.clamp(0.0, 1.0))
}

/// In nanometres, at a point of the surface.
pub fn thickness(thickness: &Thickness<f32>, point: Vector) -> f64 {
    let (from, to, t) = match *thickness {
        Thickness::Uniform(thickness) => return thickness.into(),
        Thickness::Gradient { from, to, origin, axis } => (from, to, (point - origin.into()).dot(axis.into())),
        Thickness::Radial { from, to, center, radius } => {
            (from, to, (point - center.into()).length() / f64::from(radius))
        }
    };
    let t = t.clamp(0.0, 1.0);
    f64::from(from) * (1.0 - t) + f64::from(to) * t
}

/// The sum of all waves that go to and fro in the film, r = (r₁ + r₂·e^(2iβ))/(1 + r₁·r₂·e^(2iβ)) with the amplitudes
/// r₁ and r₂ of its faces and β = 2π·d·n·cos θ/λ in it; the mean over both polarisations. G. B. Airy, 1833; M. Born and
/// E. Wolf, Principles of Optics, section 7.6.
///
/// q = n·cos θ = √(n² − (n₀·sin θ₀)²) in each of the three media, imaginary where a wave cannot propagate.
pub fn airy(outer: f64, cosine: f64, film: f64, thickness: f64, base: Complex, wavelength: f64) -> f64 {
    let along = Complex::from(outer * outer * (1.0 - cosine * cosine));
    let squares = [(outer * outer).into(), (film * film).into(), base * base];
    let q = [(outer * cosine).into(), (squares[1] - along).sqrt(), (squares[2] - along).sqrt()];
    let twice_beta = Complex::new(0.0, 4.0 * std::f64::consts::PI * thickness / wavelength) * q[1];
    let round_trip = twice_beta.exp();
    let sum = |amplitude: fn(Complex, Complex, Complex, Complex) -> Complex| {
        let upper = amplitude(squares[0], q[0], squares[1], q[1]);
        let lower = amplitude(squares[1], q[1], squares[2], q[2]) * round_trip;
        ((upper + lower) / (Complex::ONE + upper * lower)).norm_squared()
    };
    let s = sum(|_, q1, _, q2| (q1 - q2) / (q1 + q2));
    let p = sum(|square1, q1, square2, q2| (square2 * q1 - square1 * q2) / (square2 * q1 + square1 * q2));
    0.5 * (s + p)
}
