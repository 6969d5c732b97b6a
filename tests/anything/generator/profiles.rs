//! Profiles of media.

use whit::scene::{Law, Level, Method, Profile, Steps};

use super::Source;
use super::span::{EXCESS, LENGTH, POSITIVE, RATIO, SLOPE, TABLE, TOLERANCE};

/// Values of tables; those of a scene live as long as the program.
static FALLING: [f32; 4] = [0.3, 0.2, 0.1, 0.0];
static STEEP: [f32; 3] = [0.0, 0.9, -0.05];
static ENDS: [f32; 6] = [-0.9, -0.8, -0.6, 0.0, 1.0, 3.0];
static LARGE: [f32; 2] = [9.0, 4.1];
static SHORT: [f32; 1] = [0.5];
static WRONG: [f32; 3] = [0.1, f32::NAN, 0.1];

impl Source<'_> {
    /// Profiles for media to name; mostly none.
    pub fn profiles(&mut self) -> Vec<Profile<'static, f32>> {
        let count = if self.once_in(2) { 1 + self.below(3) } else { 0 };
        (0..count).map(|_| self.profile()).collect()
    }

    fn profile(&mut self) -> Profile<'static, f32> {
        let level = match self.below(2) {
            0 => Level::Height { origin: self.point(), up: self.unit() },
            _ => {
                Level::Radius { center: self.point(), radius: if self.once_in(2) { 0.0 } else { self.size(POSITIVE) } }
            }
        };
        let (a, b) = (self.coordinate(LENGTH), self.coordinate(LENGTH));
        let (low, high) = (a.min(b), a.max(b));
        let (from, to) = match level {
            _ if self.is_wild => (a, b),
            Level::Height { .. } => (low, high),
            Level::Radius { radius, .. } => (low.abs().min(high.abs()) - radius, low.abs().max(high.abs())),
        };
        let to = if to - from >= 1e-12 || self.is_wild { to } else { LENGTH.fit(from + from.abs().max(self.scale)) };
        Profile { level, from, to, law: self.law(from, to), method: self.method(to - from) }
    }

    /// Numbers that validation refuses more often than not, if they are any; so mostly they are made to fit.
    fn law(&mut self, from: f32, to: f32) -> Law<'static, f32> {
        let span = (to - from).abs().max(1e-12);
        let scale = if self.once_in(4) { self.number(POSITIVE) } else { POSITIVE.fit(span * self.number(SLOPE).abs()) };
        match self.below(8) {
            0 => Law::Polynomial { constant: self.number(EXCESS), linear: 0.0, quadratic: 0.0 },
            1 => {
                let (linear, quadratic) = (self.number(SLOPE) / span, self.number(SLOPE) / (span * span));
                // The level at which the index is that of a vacuum.
                let constant = self.number(EXCESS) - from * (linear + from * quadratic);
                Law::Polynomial { constant, linear, quadratic }
            }
            2 => {
                let excess = self.number(EXCESS);
                // From the excess at the lowest level to that at level 0, as far as there is any of it.
                let excess = if self.once_in(2) { excess } else { excess * (from / scale).clamp(-39.0, 39.0).exp() };
                Law::Exponential { far: self.pick(&[1.0, 1.1, 0.5, 900.0], 1.0), excess, scale }
            }
            3 => Law::Thermal { excess: self.number(EXCESS), ratio: self.number(RATIO), scale },
            4 => Law::Inversion {
                below: self.number(EXCESS),
                above: self.number(EXCESS),
                height: self.coordinate(LENGTH),
                thickness: scale,
            },
            5 => Law::FishEye { index: 1.0 + self.number(EXCESS), radius: scale },
            6 => Law::luneburg(POSITIVE.fit(to.abs().max(from.abs()))),
            _ => {
                let values = self.table();
                let least = span / (values.len().max(2) - 1) as f32;
                Law::Table { spacing: if self.is_wild { scale } else { POSITIVE.fit(scale.max(least)) }, values }
            }
        }
    }

    fn table(&mut self) -> &'static [f32] {
        let valid = self.pick::<&'static [f32]>(&[&FALLING, &ENDS, &LARGE, &STEEP], &FALLING);
        match self.below(16) {
            13 if self.is_wild => &SHORT,
            14 if self.is_wild => &WRONG,
            15 if self.is_wild => &[],
            12 => Box::leak(Box::new([self.number(TABLE); 2])),
            _ => valid,
        }
    }

    fn method(&mut self, span: f32) -> Method<f32> {
        let length = if self.once_in(4) {
            self.number(POSITIVE)
        } else {
            POSITIVE.fit(span.abs() * self.pick(&[0.25, 0.01, 0.001, 1.0, 3.0, 100.0, 0.1], 0.1))
        };
        match self.below(3) {
            0 => Method::Layers { thickness: if self.is_wild { length } else { length.max(span / 60_000.0) } },
            1 => Method::Steps(Steps::Fixed { length }),
            _ => Method::Steps(Steps::Controlled { tolerance: self.number(TOLERANCE) }),
        }
    }
}
