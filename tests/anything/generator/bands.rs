//! Samples of the spectrum; those of a scene live as long as the program.

use whit::Rgb;
use whit::optics::{Band, bands};

use super::Source;

static ONE: [Band; 1] = bands();
static FEW: [Band; 3] = bands();
static MANY: [Band; 12] = bands();
/// Weights and wavelengths at the ends of their ranges.
static ENDS: [Band; 4] = [
    Band { wavelength: 1.0, weight: Rgb::new(1e3, -1e3, 0.0) },
    Band { wavelength: 1e6, weight: Rgb::new(-1e3, 1e3, -0.0) },
    Band { wavelength: 550.0, weight: Rgb::new(0.0, 1e3, 1e-40) },
    Band { wavelength: 1.0, weight: Rgb::new(1e3, 1e3, -1e3) },
];
static NEGATIVE: [Band; 2] =
    [Band { wavelength: 400.0, weight: Rgb::grey(-1.0) }, Band { wavelength: 700.0, weight: Rgb::grey(-1e3) }];
static WRONG: [Band; 1] = [Band { wavelength: f32::NAN, weight: Rgb::grey(f32::INFINITY) }];

pub fn random(source: &mut Source<'_>) -> &'static [Band] {
    let valid = source.pick::<&'static [Band]>(&[&FEW, &MANY, &ONE, &ENDS, &NEGATIVE], &FEW);
    match source.below(16) {
        14 if source.is_wild => &WRONG,
        15 if source.is_wild => &[],
        _ => valid,
    }
}
