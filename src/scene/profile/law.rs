//! The index of refraction by level.

use super::{Square, table};
use crate::math::Real;
use crate::scene::Effects;

/// The index of refraction n as a function of the level ℓ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law<'a, T> {
    /// n² = 1 + constant + linear·ℓ + quadratic·ℓ²
    ///
    /// Light goes along parabolas where n² is linear, and along sines where it is quadratic. [`Law::luneburg`] is one.
    Polynomial {
        /// n² − 1 at the level 0.
        constant: T,
        /// In 1/scene unit.
        linear: T,
        /// In 1/scene unit².
        quadratic: T,
    },
    /// n = far + excess·e^(−ℓ/scale): an atmosphere.
    Exponential {
        /// The index far up; 1 for air.
        far: T,
        /// What it is more at the level 0; 2.8e-4 for air at sea level.
        excess: T,
        /// Scale height, in scene units; 8 km for air.
        scale: T,
    },
    /// n = 1 + excess/(1 + ratio·e^(−ℓ/scale)): air over warm ground or a cold sea. See [`Law::warm_air`].
    Thermal {
        /// n − 1 far up.
        excess: T,
        /// How much warmer the air is at the level 0 than far up, as a share of the temperature there; above −1.
        ratio: T,
        /// Over which height the difference falls to 1/e, in scene units.
        scale: T,
    },
    /// n = 1 + below + (above − below)/(1 + e^(−(ℓ − height)/thickness)): a layer of warm air on cold air.
    Inversion {
        /// n − 1 far below.
        below: T,
        /// n − 1 far above.
        above: T,
        /// The level of the middle of the change.
        height: T,
        /// Most of the change is within three times this length, in scene units.
        thickness: T,
    },
    /// n = index/(1 + (ℓ/radius)²): Maxwell's fish-eye, in which light goes along circles.
    FishEye {
        /// In the centre.
        index: T,
        /// Where the index is half of that, in scene units.
        radius: T,
    },
    /// n = 1 + `values[i]` at the level from + i·spacing, with cubic curves between them that have no kinks.
    Table {
        /// Between levels, in scene units.
        spacing: T,
        /// n − 1, two at least, for all levels up to `to`.
        values: &'a [T],
    },
}

/// n − 1 of air at 1013 hPa, times its temperature in kelvins (visible light).
const REFRACTIVITY: f32 = 0.0789;

impl Law<'_, f32> {
    /// Air at the pressure of 1013 hPa whose temperature falls (or, with a negative difference, rises) with height:
    /// T = ambient + difference·e^(−ℓ/scale), in kelvins, with n − 1 = 0.0789/T.
    pub const fn warm_air(ambient: f32, difference: f32, scale: f32) -> Self {
        Self::Thermal { excess: REFRACTIVITY / ambient, ratio: difference / ambient, scale }
    }

    /// Air at the pressure of 1013 hPa, of one temperature in kelvins below a height and of another one above it, with
    /// n − 1 = 0.0789/T.
    pub const fn inversion(below: f32, above: f32, height: f32, thickness: f32) -> Self {
        Self::Inversion { below: REFRACTIVITY / below, above: REFRACTIVITY / above, height, thickness }
    }

    /// Luneburg's lens, n = √(2 − (r/radius)²): it brings parallel light to one point of its rim, and has the index 1 there.
    pub const fn luneburg(radius: f32) -> Self {
        Self::Polynomial { constant: 1.0, linear: 0.0, quadratic: -1.0 / (radius * radius) }
    }
}

impl<T: Real> Law<'_, T> {
    /// The square of the index at a level; a table starts at the level `from`. Of laws that a tracer's effects leave out, it
    /// is that of a vacuum.
    #[inline]
    pub(super) fn square<const EFFECTS: u64>(&self, level: T, from: T) -> Square<T> {
        let effects = const { Effects::from_bits(EFFECTS) };
        match *self {
            Self::Polynomial { constant, linear, quadratic } if effects.has(Effects::POLYNOMIAL_LAW) => Square {
                excess: constant + level * (linear + level * quadratic),
                slope: linear + T::TWO * quadratic * level,
            },
            Self::Exponential { far, excess, scale } if effects.has(Effects::EXPONENTIAL_LAW) => {
                let part = excess * decay(level / scale);
                above_one(far - T::ONE + part, -part / scale)
            }
            Self::Thermal { excess, ratio, scale } if effects.has(Effects::EXPONENTIAL_LAW) => {
                let part = ratio * decay(level / scale);
                let inverse = T::ONE / (T::ONE + part);
                above_one(excess * inverse, excess * inverse * inverse * part / scale)
            }
            Self::Inversion { below, above, height, thickness } if effects.has(Effects::EXPONENTIAL_LAW) => {
                let share = T::ONE / (T::ONE + decay((level - height) / thickness));
                let change = (above - below) * share;
                above_one(below + change, change * (T::ONE - share) / thickness)
            }
            Self::FishEye { index, radius } if effects.has(Effects::FISH_EYE_LAW) => {
                let x = level / radius;
                let n = index / (T::ONE + x * x);
                let square = n * n;
                let slope = -(T::TWO + T::TWO) * square * n * x / (index * radius);
                Square { excess: square - T::ONE, slope }
            }
            Self::Table { spacing, values } if effects.has(Effects::TABLE_LAW) => {
                let (value, slope) = table::at(values, (level - from) / spacing);
                above_one(value, slope / spacing)
            }
            _ => Square { excess: T::ZERO, slope: T::ZERO },
        }
    }

    /// The length over which the law changes its ways, of which a step does not go past anything; the largest number where
    /// it has none.
    pub(super) fn feature(&self) -> T {
        match *self {
            Self::Polynomial { .. } => T::MAX,
            // The places that a step looks at are at most half of it apart.
            Self::Exponential { scale, .. } | Self::Thermal { scale, .. } => scale * T::from_f32(4.0),
            Self::Inversion { thickness, .. } => thickness * T::from_f32(3.0),
            Self::FishEye { radius, .. } => radius,
            Self::Table { spacing, .. } => spacing * T::TWO,
        }
    }

    /// The same law in another number type; `None` for a table, which is a slice of numbers.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Option<Law<'static, U>> {
        Some(match *self {
            Self::Polynomial { constant, linear, quadratic } => {
                Law::Polynomial { constant: f(constant), linear: f(linear), quadratic: f(quadratic) }
            }
            Self::Exponential { far, excess, scale } => {
                Law::Exponential { far: f(far), excess: f(excess), scale: f(scale) }
            }
            Self::Thermal { excess, ratio, scale } => {
                Law::Thermal { excess: f(excess), ratio: f(ratio), scale: f(scale) }
            }
            Self::Inversion { below, above, height, thickness } => {
                Law::Inversion { below: f(below), above: f(above), height: f(height), thickness: f(thickness) }
            }
            Self::FishEye { index, radius } => Law::FishEye { index: f(index), radius: f(radius) },
            Self::Table { .. } => return None,
        })
    }
}

/// n² − 1 = (n − 1)(n + 1) and its slope.
#[inline]
fn above_one<T: Real>(excess: T, slope: T) -> Square<T> {
    Square { excess: excess * (T::TWO + excess), slope: T::TWO * (T::ONE + excess) * slope }
}

/// e^(−x), held where no number type overflows and nothing is left of a change.
#[inline]
fn decay<T: Real>(x: T) -> T {
    let most = T::from_f32(40.0);
    (-x.max(-most).min(most)).exp()
}
