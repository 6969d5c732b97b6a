//! Profiles of media, and what bends light.

use super::number::{Fault, POSITIVE, check, ensure, length, minus, point, positive, unit, within};
use crate::math::{Real, Vec3};
use crate::scene::{BlackHole, Law, Level, Method, Profile, Steps};

const INDEX: &str = "numbers that give an index of refraction from 1e-3 to 1e3 between the levels `from` and `to`";
const TABLE: &str = "two values at least, each of an index from 0.1 to 10, and at most twice its neighbour's";
const DIGITS: &str = "terms of at most 1e6 times their sum, so that digits are left of it";
const WARMTH: &str = "a temperature from 1e-3 to 1e12 times that far up, everywhere";
const LAYERS: &str = "a thickness that makes at most 65535 layers";

impl Profile<'_, f32> {
    pub(in crate::scene) const fn check(&self) -> Result<(), Fault> {
        ensure!(self.check_levels());
        ensure!(self.law.check(self.from, self.to));
        self.method.check(self.to - self.from)
    }

    const fn check_levels(&self) -> Result<(), Fault> {
        ensure!(length(self.from, "from"));
        ensure!(length(self.to, "to"));
        ensure!(check(self.to - self.from >= 1e-12, "to", "a level above `from`"));
        match self.level {
            Level::Height { origin, up } => {
                ensure!(point(origin, "level.origin"));
                unit(up, "level.up")
            }
            Level::Radius { center, radius } => {
                ensure!(point(center, "level.center"));
                ensure!(check(within(radius, 0.0, 1e12), "level.radius", "a number from 0 to 1e12"));
                check(self.from >= -radius, "from", "at least −`level.radius`")
            }
        }
    }
}

impl Law<'_, f32> {
    pub(super) const fn check(&self, from: f32, to: f32) -> Result<(), Fault> {
        let ok = match *self {
            Law::Polynomial { constant, linear, quadratic } => {
                let vertex = -linear / (2.0 * quadratic);
                let inside = if vertex > from && vertex < to { vertex } else { from };
                let squares = [
                    polynomial(constant, linear, quadratic, from),
                    polynomial(constant, linear, quadratic, to),
                    polynomial(constant, linear, quadratic, inside),
                ];
                let farthest = from.abs().max(to.abs());
                let terms = polynomial(constant.abs(), linear.abs(), quadratic.abs(), farthest);
                ensure!(check(has_digits(terms, squares[0].min(squares[1]).min(squares[2])), "law", DIGITS));
                is_square(squares[0]) && is_square(squares[1]) && is_square(squares[2])
            }
            Law::Exponential { far, excess, scale } => {
                ensure!(positive(scale, "law.scale"));
                let at = [decay(from / scale), decay(to / scale)];
                let ends = [far as f64 + excess as f64 * at[0], far as f64 + excess as f64 * at[1]];
                let terms = far.abs() as f64 + excess.abs() as f64 * at[0];
                ensure!(check(has_digits(terms, ends[0].min(ends[1])), "law", DIGITS));
                is_index(ends[0]) && is_index(ends[1])
            }
            Law::Thermal { excess, ratio, scale } => {
                ensure!(positive(scale, "law.scale"));
                let warmth = [1.0 + ratio as f64 * decay(from / scale), 1.0 + ratio as f64 * decay(to / scale)];
                ensure!(check(is_warmth(warmth[0]) && is_warmth(warmth[1]), "law.ratio", WARMTH));
                is_index(1.0 + excess as f64 / warmth[0]) && is_index(1.0 + excess as f64 / warmth[1])
            }
            Law::Inversion { below, above, height, thickness } => {
                ensure!(length(height, "law.height"));
                ensure!(positive(thickness, "law.thickness"));
                is_index(1.0 + below as f64) && is_index(1.0 + above as f64)
            }
            Law::FishEye { index, radius } => {
                ensure!(positive(radius, "law.radius"));
                let (a, b) = (from as f64 / radius as f64, to as f64 / radius as f64);
                let n = index as f64;
                is_index(n) && is_index(n / (1.0 + a * a)) && is_index(n / (1.0 + b * b))
            }
            Law::Table { spacing, values } => {
                ensure!(positive(spacing, "law.spacing"));
                ensure!(check(is_table(values), "law.values", TABLE));
                return reaches(values.len(), spacing, to - from);
            }
        };
        check(ok, "law", INDEX)
    }
}

impl Method<f32> {
    const fn check(&self, span: f32) -> Result<(), Fault> {
        match self {
            Method::Layers { thickness } => {
                ensure!(check(within(*thickness, 1e-12, 1e12), "method.thickness", POSITIVE));
                check(span / *thickness <= 65_535.0, "method.thickness", LAYERS)
            }
            Method::Steps(Steps::Fixed { length }) => positive(*length, "method.length"),
            Method::Steps(Steps::Controlled { tolerance }) => check_tolerance(*tolerance, "method.tolerance"),
        }
    }
}

const fn check_tolerance(tolerance: f32, field: &'static str) -> Result<(), Fault> {
    check(within(tolerance, 1e-7, 0.1), field, "a number from 1e-7 to 0.1")
}

impl<T: Real> Profile<'_, T> {
    /// The same check for every number type. A table is not converted as a whole, but each value on its own.
    pub(super) fn check_any(&self) -> Result<(), Fault> {
        if let Some(profile) = self.map(T::to_f32) {
            return profile.check();
        }
        let Law::Table { spacing, values } = self.law else { return Ok(()) };
        let (spacing, constant) = (spacing.to_f32(), Law::Polynomial { constant: 0.0, linear: 0.0, quadratic: 0.0 });
        let rest = self.map_with_law(constant, T::to_f32);
        rest.check()?;
        check(values.len() >= 2, "law.values", TABLE)?;
        for pair in values.windows(2) {
            let pair = [pair.first(), pair.last()].map(|value| value.map_or(0.0, |value| value.to_f32()));
            Law::Table { spacing, values: &pair }.check(0.0, spacing)?;
        }
        reaches(values.len(), spacing, rest.to - rest.from)
    }
}

impl BlackHole<f32> {
    pub(super) const fn check(&self, eye: Vec3<f32>) -> Result<(), Fault> {
        ensure!(point(self.center, "black_hole.center"));
        ensure!(check(within(self.mass, 1e-9, 1e9), "black_hole.mass", "a number from 1e-9 to 1e9"));
        let away = minus(eye, self.center);
        let (square, horizon) = (super::number::dot(away, away), 2.0 * self.mass);
        ensure!(check(square > horizon * horizon, "black_hole.center", "an eye outside of the horizon at 2·`mass`"));
        match self.steps {
            Steps::Fixed { length } => {
                check(within(length, 1e-4, 0.5), "black_hole.steps.length", "a share of the distance from 1e-4 to 0.5")
            }
            Steps::Controlled { tolerance } => check_tolerance(tolerance, "black_hole.steps.tolerance"),
        }
    }
}

const fn polynomial(constant: f32, linear: f32, quadratic: f32, level: f32) -> f64 {
    let level = level as f64;
    1.0 + constant as f64 + level * (linear as f64 + level * quadratic as f64)
}

/// Whether something is left of a sum of such terms when each is rounded: of sums that are too small, others will tell.
const fn has_digits(terms: f64, sum: f64) -> bool {
    !(sum > 0.0 && terms > sum * (1u32 << 20) as f64)
}

const fn is_warmth(warmth: f64) -> bool {
    warmth >= 1e-3 && warmth <= 1e12
}

const fn is_square(square: f64) -> bool {
    square >= 1e-6 && square <= 1e6
}

const fn is_index(index: f64) -> bool {
    index >= 1e-3 && index <= 1e3
}

/// Whether so many values reach from the first level to the last, to a thousandth of the spacing.
const fn reaches(values: usize, spacing: f32, span: f32) -> Result<(), Fault> {
    check((values as f32 - 0.999) * spacing >= span, "law.values", "values up to the level `to`")
}

#[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
const fn is_table(values: &[f32]) -> bool {
    let mut i = 0;
    while i < values.len() {
        if !within(values[i], -0.9, 9.0) {
            return false;
        }
        if i > 0 {
            let (a, b) = (1.0 + values[i - 1], 1.0 + values[i]);
            if a > 2.0 * b || b > 2.0 * a {
                return false;
            }
        }
        i += 1;
    }
    values.len() >= 2
}

/// e^(−x), with x held between −40 and 40, in constant evaluation: five terms of its series at x/2¹², squared twelve times.
const fn decay(x: f32) -> f64 {
    let held = if x > 40.0 {
        40.0
    } else if x < -40.0 {
        -40.0
    } else {
        x
    };
    let small = -(held as f64) / 4096.0;
    let mut power = 1.0 + small * (1.0 + small / 2.0 * (1.0 + small / 3.0 * (1.0 + small / 4.0 * (1.0 + small / 5.0))));
    let mut i = 0;
    while i < 12 {
        power *= power;
        i += 1;
    }
    power
}

#[cfg(test)]
mod tests {
    use super::decay;

    #[test]
    fn the_exponential_is_right() {
        for x in [-40.0, -3.5, -0.1, 0.0, 1e-6, 0.7, 12.0, 40.0] {
            let exact = (-f64::from(x)).exp();
            assert!((decay(x) / exact - 1.0).abs() < 1e-9, "{x}");
        }
    }
}
