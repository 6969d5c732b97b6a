//! The index of refraction by level, and its slope, from the formulas that describe the laws.

use whit::scene;

/// A law in `f64`.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    Polynomial { constant: f64, linear: f64, quadratic: f64 },
    Exponential { far: f64, excess: f64, scale: f64 },
    Thermal { excess: f64, ratio: f64, scale: f64 },
    Inversion { below: f64, above: f64, height: f64, thickness: f64 },
    FishEye { index: f64, radius: f64 },
    Table { spacing: f64, values: Vec<f64> },
}

/// The index and how much it grows per scene unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    pub n: f64,
    pub slope: f64,
}

impl Law {
    /// At a level. A table goes by the cubic that belongs after the value of that number, so that it has no kinks there.
    pub fn at(&self, level: f64, from: f64, number: usize) -> Index {
        match self {
            Self::Polynomial { constant, linear, quadratic } => {
                let n = (1.0 + constant + linear * level + quadratic * level * level).sqrt();
                Index { n, slope: (linear + 2.0 * quadratic * level) / (2.0 * n) }
            }
            Self::Exponential { far, excess, scale } => {
                let part = excess * (-level / scale).exp();
                Index { n: far + part, slope: -part / scale }
            }
            Self::Thermal { excess, ratio, scale } => {
                let part = ratio * (-level / scale).exp();
                Index { n: 1.0 + excess / (1.0 + part), slope: excess * part / (scale * (1.0 + part).powi(2)) }
            }
            Self::Inversion { below, above, height, thickness } => {
                // With x = (ℓ − height)/(2·thickness), 1/(1 + e^(−2x)) is (1 + tanh x)/2.
                let x = (level - height) / (2.0 * thickness);
                let n = 1.0 + 0.5 * (below + above) + 0.5 * (above - below) * x.tanh();
                Index { n, slope: (above - below) / (4.0 * thickness * x.cosh().powi(2)) }
            }
            Self::FishEye { index, radius } => {
                let below = 1.0 + (level / radius).powi(2);
                Index { n: index / below, slope: -2.0 * index * level / (radius * below).powi(2) }
            }
            Self::Table { spacing, values } => table(values, (level - from) / spacing, number, *spacing),
        }
    }

    /// The length over which it changes its ways, if it has one.
    pub fn feature(&self) -> f64 {
        match *self {
            Self::Polynomial { .. } => f64::INFINITY,
            Self::Exponential { scale, .. } | Self::Thermal { scale, .. } => scale,
            Self::Inversion { thickness, .. } => thickness,
            Self::FishEye { radius, .. } => radius,
            Self::Table { spacing, .. } => spacing,
        }
    }

    /// The levels between two where a derivative jumps.
    pub fn joints(&self, from: f64, to: f64) -> Vec<f64> {
        match self {
            Self::Table { spacing, values } => {
                (1..values.len()).map(|i| from + i as f64 * spacing).filter(|&level| level < to).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// E. Catmull and R. Rom, A Class of Local Interpolating Splines, 1974: the cubic through two values whose slopes are
/// those between their neighbours, or at the ends to the only one; past the last value a line.
fn table(values: &[f64], place: f64, number: usize, spacing: f64) -> Index {
    let last = values.len() - 1;
    let slope = |i: usize| match i {
        0 => values[1] - values[0],
        i if i == last => values[last] - values[last - 1],
        i => 0.5 * (values[i + 1] - values[i - 1]),
    };
    if number >= last {
        let slope = slope(last);
        return Index { n: 1.0 + values[last] + slope * (place - last as f64), slope: slope / spacing };
    }
    let t = place - number as f64;
    let (a, b, a_slope, b_slope) = (values[number], values[number + 1], slope(number), slope(number + 1));
    // Hermite's basis, and its derivative.
    let n = a * (1.0 + 2.0 * t) * (1.0 - t).powi(2)
        + a_slope * t * (1.0 - t).powi(2)
        + b * t * t * (3.0 - 2.0 * t)
        + b_slope * t * t * (t - 1.0);
    let change = (b - a) * 6.0 * t * (1.0 - t) + a_slope * (1.0 - t) * (1.0 - 3.0 * t) + b_slope * t * (3.0 * t - 2.0);
    Index { n: 1.0 + n, slope: change / spacing }
}

impl From<&scene::Law<'_, f32>> for Law {
    fn from(law: &scene::Law<'_, f32>) -> Self {
        match *law {
            scene::Law::Polynomial { constant, linear, quadratic } => {
                Self::Polynomial { constant: constant.into(), linear: linear.into(), quadratic: quadratic.into() }
            }
            scene::Law::Exponential { far, excess, scale } => {
                Self::Exponential { far: far.into(), excess: excess.into(), scale: scale.into() }
            }
            scene::Law::Thermal { excess, ratio, scale } => {
                Self::Thermal { excess: excess.into(), ratio: ratio.into(), scale: scale.into() }
            }
            scene::Law::Inversion { below, above, height, thickness } => Self::Inversion {
                below: below.into(),
                above: above.into(),
                height: height.into(),
                thickness: thickness.into(),
            },
            scene::Law::FishEye { index, radius } => Self::FishEye { index: index.into(), radius: radius.into() },
            scene::Law::Table { spacing, values } => {
                Self::Table { spacing: spacing.into(), values: values.iter().map(|&value| value.into()).collect() }
            }
        }
    }
}
