//! Choices and numbers, which are often at the end of their range, or next to one that was there before.

use whit::{Real, Rgb, Vec3};

/// Where the numbers of a case come from.
pub struct Source {
    random: fastrand::Rng,
    /// The largest coordinate.
    pub limit: f32,
    /// The largest amount of light.
    pub amount: f32,
    /// The smallest number.
    pub unit: f32,
    /// Whether the case is about the ends of the range.
    is_extreme: bool,
    numbers: Vec<f32>,
    points: Vec<Vec3<f32>>,
}

impl Source {
    /// The numbers of a case, for scenes in `T`.
    pub fn new<T: Real>(case: u64) -> Self {
        let range = T::RANGE.unwrap();
        let mut random = fastrand::Rng::with_seed(case);
        Self {
            limit: range.coordinate,
            amount: range.amount,
            unit: T::SMALLEST.to_f32(),
            is_extreme: random.u8(..3) > 0,
            random,
            numbers: Vec::new(),
            points: Vec::new(),
        }
    }

    /// A number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.random.usize(..count)
    }

    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// From `low` to `high`: one of some usual numbers, an end, next to an end, or anything between.
    pub fn number(&mut self, low: f32, high: f32, usual: &[f32]) -> f32 {
        let step = self.unit * self.random.i32(-3..=3) as f32;
        let x = match self.below(if self.is_extreme { 16 } else { 8 }) {
            0..=4 => self.pick(usual) + if self.once_in(8) { step } else { 0.0 },
            5 | 6 => low + (high - low) * self.random.f32(),
            7 => low + (high - low) * (-24.0 * self.random.f32()).exp2(),
            8..=10 => high,
            11 => high - step.abs(),
            12 | 13 => low,
            14 => low + step.abs(),
            _ => self.again() + step,
        };
        self.numbers.push(x);
        x.clamp(low, high)
    }

    fn again(&mut self) -> f32 {
        if self.numbers.is_empty() { 1.0 } else { self.numbers[self.random.usize(..self.numbers.len())] }
    }

    /// A coordinate, of either sign.
    pub fn coordinate(&mut self) -> f32 {
        let x = if self.is_extreme && self.once_in(3) {
            self.number(0.0, self.limit, &[0.0, 1.0, 3.0])
        } else {
            (self.random.f32() * 8.0 * 16.0).round() / 16.0
        };
        if self.once_in(2) { -x } else { x }
    }

    /// A length above 0.
    pub fn length(&mut self) -> f32 {
        self.number(self.unit, self.limit, &[0.25, 0.5, 1.0, 2.0, 4.0])
    }

    /// An amount of light.
    pub fn amount(&mut self) -> f32 {
        self.number(0.0, self.amount, &[0.0, 0.25, 0.5, 0.8, 1.0])
    }

    pub fn share(&mut self) -> f32 {
        self.number(0.0, 1.0, &[0.0, 0.25, 0.5, 0.9, 1.0])
    }

    pub fn color(&mut self) -> Rgb<f32> {
        self.triple(Self::amount)
    }

    pub fn triple(&mut self, number: impl Fn(&mut Self) -> f32) -> Rgb<f32> {
        if self.once_in(4) { Rgb::new(number(self), number(self), number(self)) } else { Rgb::grey(number(self)) }
    }

    /// A point, often next to one that was there before.
    pub fn point(&mut self) -> Vec3<f32> {
        let old = if self.points.is_empty() { Vec3::ZERO } else { self.points[self.random.usize(..self.points.len())] };
        let new = Vec3::new(self.coordinate(), self.coordinate(), self.coordinate());
        let axis = self.axis();
        let point = match self.below(10) {
            0..=5 => new,
            6 => old,
            7 => old + axis * self.again(),
            8 => old + axis * (self.unit * self.random.i32(1..5) as f32),
            _ => Vec3 { y: new.y, ..old },
        };
        let point = point.map(|x| x.clamp(-self.limit, self.limit));
        self.points.push(point);
        point
    }

    pub fn axis(&mut self) -> Vec3<f32> {
        let axis = self.pick(&[Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)]);
        if self.once_in(2) { -axis } else { axis }
    }

    /// A vector of length 1.
    pub fn unit_vector(&mut self) -> Vec3<f32> {
        let [x, y, z] = [0; 3].map(|_| self.random.f32() - 0.5);
        let v = match self.below(4) {
            0 => self.axis(),
            1 => self.axis() + self.axis() * (self.unit * self.random.i32(1..4) as f32),
            _ => Vec3::new(x, y, z),
        };
        v.normalized()
    }

    /// A direction of any length that is accepted where it is normalised first.
    pub fn course(&mut self) -> Vec3<f32> {
        let length = self.number(0.016, self.limit, &[1.0, 2.0, 30.0]);
        self.unit_vector() * length
    }

    /// A direction of any length that is accepted of planes.
    pub fn direction(&mut self) -> Vec3<f32> {
        let length = self.number(0.016, 1.4999, &[1.0]);
        self.unit_vector() * length
    }
}
