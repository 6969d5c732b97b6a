//! Metals by their complex index of refraction.

use crate::math::Rgb;

/// The complex index of refraction η + ik of a conductor at the wavelengths of the three channels: 611.4, 549.1 and
/// 464.2 nm.
///
/// A channel stands for one wavelength. A colour integrated over the whole spectrum differs, most for gold, by 0.07: its
/// reflectance climbs within the green.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor {
    /// The real part η.
    pub index: Rgb<f32>,
    /// The imaginary part k, the extinction coefficient. Light is absorbed by 4πk/λ per length.
    pub extinction: Rgb<f32>,
}

impl Conductor {
    /// Reflectance at normal incidence from a vacuum, R₀ = ((η − 1)² + k²)/((η + 1)² + k²): Schlick's R₀ and the colour
    /// of the metal.
    #[must_use]
    pub const fn normal_reflectance(&self) -> Rgb<f32> {
        Rgb::new(
            reflectance(self.index.r, self.extinction.r),
            reflectance(self.index.g, self.extinction.g),
            reflectance(self.index.b, self.extinction.b),
        )
    }
}

/// Evaporated aluminium, R₀ = (0.910, 0.915, 0.921) (Rakić 1995).
pub const ALUMINIUM: Conductor =
    Conductor { index: Rgb::new(1.3216, 1.0114, 0.6832), extinction: Rgb::new(7.3112, 6.6169, 5.6254) };

/// Silver, R₀ = (0.989, 0.985, 0.977) (Babar and Weaver 2015).
pub const SILVER: Conductor =
    Conductor { index: Rgb::new(0.0485, 0.0510, 0.0523), extinction: Rgb::new(4.0931, 3.5691, 2.8116) };

/// Gold, R₀ = (0.946, 0.839, 0.349) (Babar and Weaver 2015).
pub const GOLD: Conductor =
    Conductor { index: Rgb::new(0.1491, 0.2948, 1.4030), extinction: Rgb::new(3.1106, 2.3796, 1.6863) };

/// Copper, R₀ = (0.965, 0.651, 0.557) (Babar and Weaver 2015).
pub const COPPER: Conductor =
    Conductor { index: Rgb::new(0.1039, 0.7859, 1.1425), extinction: Rgb::new(3.2483, 2.4118, 2.3926) };

/// Iron, R₀ = (0.526, 0.512, 0.500) (Johnson and Christy 1974).
pub const IRON: Conductor =
    Conductor { index: Rgb::new(2.8896, 2.9500, 2.6428), extinction: Rgb::new(3.0404, 2.9302, 2.8030) };

/// Chromium, R₀ = (0.552, 0.555, 0.558) (Johnson and Christy 1974).
pub const CHROMIUM: Conductor =
    Conductor { index: Rgb::new(3.1780, 3.1801, 2.4488), extinction: Rgb::new(3.3000, 3.3299, 3.2060) };

/// Titanium, R₀ = (0.607, 0.582, 0.548) (Johnson and Christy 1974). Other films were measured at 0.4 to 0.6.
pub const TITANIUM: Conductor =
    Conductor { index: Rgb::new(2.6588, 2.5402, 2.3030), extinction: Rgb::new(3.6976, 3.4305, 3.0796) };

const fn reflectance(index: f32, extinction: f32) -> f32 {
    let (below, above, square) = (index - 1.0, index + 1.0, extinction * extinction);
    (below * below + square) / (above * above + square)
}
