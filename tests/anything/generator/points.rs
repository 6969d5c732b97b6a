//! Points and directions, often on or near those that were there before.

use whit::Vec3;

use super::Source;
use super::span::LENGTH;

const AXES: [Vec3<f32>; 6] = [
    Vec3::new(0.0, 1.0, 0.0),
    Vec3::new(0.0, 0.0, -1.0),
    Vec3::new(1.0, 0.0, 0.0),
    Vec3::new(0.0, -1.0, -0.0),
    Vec3::new(-0.0, 0.0, 1.0),
    Vec3::new(-1.0, -0.0, 0.0),
];

impl Source<'_> {
    fn old(&mut self) -> Vec3<f32> {
        let place = usize::from(self.byte());
        self.vectors.get(place % self.vectors.len().max(1)).copied().unwrap_or(Vec3::ZERO)
    }

    pub fn axis(&mut self) -> Vec3<f32> {
        self.pick(&AXES, Vec3::new(0.0, 1.0, 0.0))
    }

    fn coordinates(&mut self) -> Vec3<f32> {
        Vec3::new(self.coordinate(LENGTH), self.coordinate(LENGTH), self.coordinate(LENGTH))
    }

    /// A place in the scene.
    pub fn point(&mut self) -> Vec3<f32> {
        let v = match self.below(16) {
            0..=8 => self.coordinates(),
            9 => self.old(),
            // On a surface, if the one is its middle and the other its radius.
            10 => self.old() + self.axis() * self.again(),
            11 => Vec3 { y: self.coordinate(LENGTH), ..self.old() },
            12 => (self.old() + self.old()) * 0.5,
            13 => self.old() + self.axis() * self.scale,
            14 => self.nudged_vector(),
            _ => Vec3::ZERO,
        };
        self.keep_vector(v)
    }

    fn nudged_vector(&mut self) -> Vec3<f32> {
        let Vec3 { x, y, z } = self.old();
        Vec3::new(self.nudged(x), self.nudged(y), self.nudged(z))
    }

    /// Any vector that is not too short to tell its direction.
    pub fn direction(&mut self) -> Vec3<f32> {
        let v = match self.below(16) {
            0..=5 => self.axis(),
            6 | 7 => self.coordinates(),
            8 => self.old(),
            9 => self.old() - self.old(),
            10 => self.nudged_vector(),
            11 => self.axis() * self.again(),
            12 => self.old() + self.axis() * self.again(),
            13 => self.axis() + self.axis() * self.again(),
            14 => self.axis() + self.axis() * 0.5,
            _ => self.coordinates() * self.again(),
        };
        let v = self.keep_vector(v);
        if self.is_wild || v.length_squared() > 1e-24 { v } else { self.axis() }
    }

    /// A vector of length 1, as near as validation asks.
    pub fn unit(&mut self) -> Vec3<f32> {
        let v = self.direction();
        let unit = exact_unit(v);
        match self.below(8) {
            0..=5 => unit,
            6 => unit * 1.000_49,
            _ => unit * 0.999_51,
        }
    }

    fn keep_vector(&mut self, v: Vec3<f32>) -> Vec3<f32> {
        let v = v.map(|x| self.fit(x, LENGTH));
        if self.vectors.len() < 32 {
            self.vectors.push(v);
        }
        v
    }
}

/// v/|v|, whatever its length.
pub fn exact_unit(v: Vec3<f32>) -> Vec3<f32> {
    let wide = v.map(f64::from);
    let unit = wide * (1.0 / wide.length());
    if unit.length().is_finite() { unit.map(|x| x as f32) } else { v }
}
