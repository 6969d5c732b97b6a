//! Optical constants of real materials, with their sources.
//!
//! Single indices of refraction are for the sodium D line, 589.3 nm; [`dispersive`] has the same media as functions of
//! wavelength, and there are [`Conductor`]s. R₀ is the reflectance at normal incidence, next to a vacuum. The indices
//! of glasses, acrylic, diamond, fluoride, seawater and oil are relative to air, so 0.03 % below those relative to a
//! vacuum, which is less than two pieces of the same material differ.
//!
//! ```
//! use whit::optics::materials::{GOLD, WATER, dispersive};
//!
//! const TINT: whit::Rgb<f32> = GOLD.normal_reflectance();
//! assert!(TINT.r > TINT.g && TINT.g > TINT.b);
//! assert!((dispersive::WATER.index(589.3) as f32 - WATER).abs() < 1e-4);
//! ```
//!
//! Most numbers come by way of the database refractiveindex.info (Polyanskiy 2024), which is in the public domain.

mod conductor;
pub mod dispersive;

pub use conductor::{ALUMINIUM, CHROMIUM, COPPER, Conductor, GOLD, IRON, SILVER, TITANIUM};

use crate::math::Rgb;

/// Water at 20 °C: n = 1.3333 and R₀ = 0.020 (Daimon and Masumura 2007).
pub const WATER: f32 = 1.3333;

/// Seawater of salinity 35 ‰ at 20 °C: n = 1.3394 and R₀ = 0.021 (Quan and Fry 1995).
pub const SEAWATER: f32 = 1.3394;

/// Ice at −7 °C: n = 1.3097 and R₀ = 0.018 (Warren and Brandt 2008). Its birefringence of 0.0014 is left out.
pub const ICE: f32 = 1.3097;

/// Fused quartz, that is, fused silica, at 20 °C: n = 1.4584 and R₀ = 0.035 (Malitson 1965).
pub const FUSED_QUARTZ: f32 = 1.4584;

/// Crown glass, Schott N-BK7, at 20 °C: n = 1.5167 and R₀ = 0.042 (Schott 2017). Lenses; near to window glass.
pub const CROWN_GLASS: f32 = 1.5167;

/// Dense flint glass, Schott SF10, at 20 °C: n = 1.7280 and R₀ = 0.071 (Schott 2017). Prisms; a heavy lead glass.
pub const FLINT_GLASS: f32 = 1.7280;

/// Diamond at room temperature: n = 2.4173 and R₀ = 0.172 (Peter 1923).
pub const DIAMOND: f32 = 2.4173;

/// Acrylic glass, poly(methyl methacrylate), at 20 °C: n = 1.4925 and R₀ = 0.039 (Beadie et al. 2015).
pub const ACRYLIC: f32 = 1.4925;

/// The liquid of a soap film: [`WATER`], which is what a film is but for two layers of soap one molecule thick
/// (Rijnbout 1970). Glycerol raises it: pure, it has 1.472 (Rheims, Köser and Wriedt 1997).
pub const SOAP_FILM: f32 = WATER;

/// Virgin olive oil at 20 °C: n = 1.469, from 1.4677 to 1.4705, and R₀ = 0.036 (Codex Alimentarius 33-1981).
pub const OLIVE_OIL: f32 = 1.469;

/// Magnesium fluoride at 19 °C, the coating of lenses: n = 1.3777 and R₀ = 0.025 (Dodge 1984). It is the ordinary index
/// of the crystal; evaporated films have from 1.38 to 1.42.
pub const MAGNESIUM_FLUORIDE: f32 = 1.3777;

/// A film of titanium dioxide, as on anodised titanium: n = 2.4107, or 2.436 at 550 nm, and R₀ = 0.171 (Siefke et al.
/// 2016, an atomic layer deposition of 350 nm). Films have from 2.1 to 2.5, by density and crystal.
pub const TITANIUM_DIOXIDE: f32 = 2.4107;

/// The absorption of pure water at 22 °C per metre, at 611.4, 549.1 and 464.2 nm (Pope and Fry 1997).
///
/// Light I₀ becomes I₀·e^(−c·x) after x metres. Where a scene unit is m metres, the extinction per scene unit is m·c.
/// Scattering is left out.
pub const WATER_EXTINCTION: Rgb<f32> = Rgb::new(0.2656, 0.0555, 0.01009);
