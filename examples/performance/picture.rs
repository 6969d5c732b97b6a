//! Pictures in PPM, and how they differ.

use std::path::Path;

/// The root of the mean square of the differences of the bytes of two pictures.
pub fn difference(one: &Path, other: &Path) -> Result<f64, String> {
    let read = |path: &Path| {
        image::open(path).map(|picture| picture.into_rgb8()).map_err(|error| format!("{}: {error}", path.display()))
    };
    let (one, other) = (read(one)?, read(other)?);
    if one.dimensions() != other.dimensions() {
        return Err("the pictures have different sizes".to_owned());
    }
    let square = |(&a, &b): (&u8, &u8)| f64::from(a.abs_diff(b)).powi(2);
    let sum: f64 = one.as_raw().iter().zip(other.as_raw()).map(square).sum();
    Ok((sum / one.as_raw().len() as f64).sqrt())
}
