//! Numbers that look random and are the same in every run.

use whit::Vec3;

/// `fastrand`'s numbers, in the ways that hard cases ask for.
pub struct Random(fastrand::Rng);

impl Random {
    /// A stream for each case and round.
    pub fn new(case: u64, round: u64) -> Self {
        Self(fastrand::Rng::with_seed((case << 48) ^ round))
    }

    /// From 0 to `count` − 1.
    pub fn below(&mut self, count: usize) -> usize {
        self.0.usize(..count)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0.f64()
    }

    /// In [−1, 1).
    pub fn symmetric(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Above 0, all decades from 10⁻ⁿ to 10ⁿ alike.
    pub fn decades(&mut self, n: f64) -> f64 {
        10_f64.powf(n * self.symmetric())
    }

    /// The same with either sign.
    pub fn signed_decades(&mut self, n: f64) -> f64 {
        if self.below(2) == 0 { self.decades(n) } else { -self.decades(n) }
    }

    /// A point whose coordinates are of independent decades.
    pub fn point_of_decades(&mut self, n: f64) -> Vec3<f32> {
        let mut coordinate = || self.signed_decades(n) as f32;
        Vec3::new(coordinate(), coordinate(), coordinate())
    }

    /// In the cube from −1 to 1.
    pub fn in_cube(&mut self) -> [f64; 3] {
        [self.symmetric(), self.symmetric(), self.symmetric()]
    }

    /// A unit vector, all directions alike.
    pub fn direction(&mut self) -> [f64; 3] {
        let (z, angle) = (self.symmetric(), self.unit() * std::f64::consts::TAU);
        let r = (1.0 - z * z).sqrt();
        [r * angle.cos(), r * angle.sin(), z]
    }

    /// Three weights of at least 0 with sum 1.
    pub fn weights(&mut self) -> [f64; 3] {
        let root = self.unit().sqrt();
        let v = self.unit();
        [1.0 - root, root * (1.0 - v), root * v]
    }
}
