//! The reflectance of surfaces with a thin film.

use crate::math::{Complex, Real, Rgb, Vec3};
use crate::optics::Coating;
use crate::scene::{Effects, Film, Spectrum, Thickness};

/// The reflectance at a point of a film between a medium of index `outer` and a base of complex index, per channel.
///
/// It is held between 0 and 1: a saturated colour of the spectrum lies outside of what the primaries can show.
pub(super) fn reflectance_of_film<T: Real, const EFFECTS: u64>(
    film: &Film<T>,
    point: Vec3<T>,
    outer: T,
    base: Rgb<Complex<T>>,
    cosine: T,
) -> Rgb<T> {
    let effects = const { Effects::from_bits(EFFECTS) };
    let thickness = thickness_at::<T, EFFECTS>(&film.thickness, point);
    let coating = Coating { outer, film: film.index, base };
    let color = match film.spectrum {
        Spectrum::Wavelengths if effects.has(Effects::FILM_WAVELENGTHS) => coating.by_wavelengths(cosine, thickness),
        Spectrum::Bands(bands) if effects.has(Effects::FILM_BANDS) => coating.by_bands(cosine, thickness, bands),
        Spectrum::Table if effects.has(Effects::FILM_TABLE) => coating.by_table(cosine, thickness),
        _ => Rgb::BLACK,
    };
    color.max(Rgb::BLACK).min(Rgb::WHITE)
}

/// The thickness of a film at a point of its surface, in nanometres.
fn thickness_at<T: Real, const EFFECTS: u64>(thickness: &Thickness<T>, point: Vec3<T>) -> T {
    let effects = const { Effects::from_bits(EFFECTS) };
    let mix = |from: T, to: T, t: T| from + (to - from) * t.max(T::ZERO).min(T::ONE);
    match *thickness {
        Thickness::Uniform(thickness) => thickness,
        Thickness::Gradient { from, to, origin, axis } if effects.has(Effects::FILM_GRADIENT) => {
            mix(from, to, T::held((point - origin).products(axis)))
        }
        Thickness::Radial { from, to, center, radius } if effects.has(Effects::FILM_RADIAL) => {
            mix(from, to, (point - center).length() / radius)
        }
        _ => T::ZERO,
    }
}
