//! Transparent media with their dispersion, for visible light from 400 to 700 nm.

use crate::optics::{Cauchy, Sellmeier};

/// Crown glass, Schott N-BK7, at 20 °C: n_d = 1.51680, Abbe number 64.17 (Schott 2017).
pub const CROWN_GLASS: Sellmeier =
    Sellmeier { b: [1.039_612_12, 0.231_792_344, 1.010_469_45], c: [0.006_000_698_67, 0.020_017_914_4, 103.560_653] };

/// Dense flint glass, Schott SF10, at 20 °C: n_d = 1.72825, Abbe number 28.41 (Schott 2017).
pub const FLINT_GLASS: Sellmeier =
    Sellmeier { b: [1.616_259_77, 0.259_229_334, 1.077_623_17], c: [0.012_753_455_9, 0.058_198_395_4, 116.607_68] };

/// Fused quartz, that is, fused silica, at 20 °C: n_d = 1.45846, Abbe number 67.82 (Malitson 1965).
pub const FUSED_QUARTZ: Sellmeier = Sellmeier {
    b: [0.696_166_3, 0.407_942_6, 0.897_479_4],
    c: [0.068_404_3 * 0.068_404_3, 0.116_241_4 * 0.116_241_4, 9.896_161 * 9.896_161],
};

/// Diamond at room temperature: n_d = 2.4175, Abbe number 55.3 (Peter 1923).
pub const DIAMOND: Sellmeier = Sellmeier { b: [0.3306, 4.3356, 0.0], c: [0.1750 * 0.1750, 0.1060 * 0.1060, 0.0] };

/// Water at 20 °C: n_d = 1.33340, Abbe number 55.8 (Daimon and Masumura 2007).
///
/// Two of its four terms, with resonances at 135 and 162 nm, are taken together; from 380 to 780 nm that changes the
/// index by less than 6e-6.
pub const WATER: Sellmeier = Sellmeier {
    b: [0.568_402_756_5, 0.193_459_3, 0.113_074_868_8],
    c: [0.005_101_829_712, 0.019_130_5, 10.697_927_21],
};

/// Ice at −7 °C: n_d = 1.3097. Fitted to the 31 values of Warren and Brandt (2008) from 400 to 700 nm, which have four
/// decimals, with an error below 1.2e-4.
pub const ICE: Cauchy = Cauchy { a: 1.300_08, b: 0.003_534, c: -7.38e-5 };

/// Acrylic glass, poly(methyl methacrylate), at 20 °C: n_d = 1.4925, Abbe number 59. Fitted to the formula of Beadie et
/// al. (2015) from 420 to 700 nm, with an error below 4e-5.
pub const ACRYLIC: Cauchy = Cauchy { a: 1.480_64, b: 0.003_898, c: 6.936e-5 };
