//! Media whose index of refraction changes from place to place.

use whit::scene;

use super::law::{Index, Law};
use super::vector::Vector;

/// What the index depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level {
    Height { origin: Vector, up: Vector },
    Radius { center: Vector, radius: f64 },
}

/// A profile in `f64`.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    pub level: Level,
    pub law: Law,
    /// The levels between which the index is smooth, from the lowest one where it varies to the highest.
    pub joints: Vec<f64>,
}

/// Where a level is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// The index is constant.
    Below,
    /// After the joint of that number.
    Within(usize),
    /// The index is constant.
    Above,
}

impl Level {
    pub fn at(&self, point: Vector) -> f64 {
        match *self {
            Self::Height { origin, up } => (point - origin).dot(up),
            Self::Radius { center, radius } => (point - center).length() - radius,
        }
    }

    /// The gradient of the level; none in the middle of a ball.
    pub fn gradient(&self, point: Vector) -> Vector {
        match *self {
            Self::Height { up, .. } => up,
            Self::Radius { center, .. } => {
                let away = point - center;
                if away.length() > 0.0 { away.normalized() } else { Vector::ZERO }
            }
        }
    }

    /// The distances at which a line reaches a level, in order.
    pub fn reached(&self, level: f64, origin: Vector, direction: Vector) -> Option<[f64; 2]> {
        match *self {
            Self::Height { up, .. } => {
                let distance = (level - self.at(origin)) / direction.dot(up);
                distance.is_finite().then_some([distance; 2])
            }
            Self::Radius { center, radius } => {
                let to_center = center - origin;
                let along = to_center.dot(direction);
                let across = to_center - direction * along;
                let square = (radius + level).powi(2) - across.dot(across);
                (square >= 0.0).then(|| [along - square.sqrt(), along + square.sqrt()])
            }
        }
    }

    /// Whether places have that level.
    fn exists(&self, level: f64) -> bool {
        match *self {
            Self::Height { .. } => true,
            Self::Radius { radius, .. } => radius + level > 0.0,
        }
    }
}

impl Profile {
    pub fn new(level: Level, from: f64, to: f64, law: Law) -> Self {
        let mut joints = vec![from];
        joints.extend(law.joints(from, to));
        joints.push(to);
        Self { level, law, joints }
    }

    fn ends(&self) -> [f64; 2] {
        [self.joints[0], *self.joints.last().unwrap()]
    }

    /// The index of refraction at a point.
    pub fn index(&self, point: Vector) -> f64 {
        let [from, to] = self.ends();
        let level = self.level.at(point).clamp(from, to);
        let number = self.joints.iter().rposition(|&joint| joint <= level).unwrap_or(0);
        self.law.at(level, from, number.min(self.joints.len() - 2)).n
    }

    /// The index at a point by the law that holds after a joint, wherever the point is, and the gradient of the index.
    pub fn smooth(&self, point: Vector, number: usize) -> (f64, Vector) {
        let Index { n, slope } = self.law.at(self.level.at(point), self.joints[0], number);
        (n, self.level.gradient(point) * slope)
    }

    /// The region of a point, and on a border the one that the direction leads into.
    pub fn region(&self, point: Vector, direction: Vector) -> Region {
        let tolerance =
            1e-13 * (point.largest() + self.joints.iter().fold(0.0_f64, |most, joint| most.max(joint.abs())));
        let level = self.level.at(point);
        let rising = direction.dot(self.level.gradient(point)) >= 0.0;
        let passed = |&joint: &f64| {
            if (level - joint).abs() <= tolerance { rising || !self.level.exists(joint) } else { level > joint }
        };
        match self.joints.iter().filter(|joint| passed(joint)).count() {
            0 if !self.level.exists(self.joints[0]) => Region::Within(0),
            0 => Region::Below,
            count if count == self.joints.len() => Region::Above,
            count => Region::Within(count - 1),
        }
    }

    /// The levels between which a region lies.
    pub fn bounds(&self, region: Region) -> [f64; 2] {
        let [from, to] = self.ends();
        match region {
            Region::Below => [f64::NEG_INFINITY, from],
            Region::Within(number) => {
                let [low, high] = [self.joints[number], self.joints[number + 1]];
                [if self.level.exists(low) { low } else { f64::NEG_INFINITY }, high]
            }
            Region::Above => [to, f64::INFINITY],
        }
    }

    /// The region across the upper border or the lower one.
    pub fn next(&self, region: Region, upwards: bool) -> Region {
        let last = self.joints.len() - 2;
        match (region, upwards) {
            (Region::Below, _) => Region::Within(0),
            (Region::Above, _) => Region::Within(last),
            (Region::Within(0), false) => Region::Below,
            (Region::Within(number), false) => Region::Within(number - 1),
            (Region::Within(number), true) if number == last => Region::Above,
            (Region::Within(number), true) => Region::Within(number + 1),
        }
    }

    /// The smallest length over which the index changes its ways.
    pub fn feature(&self) -> f64 {
        let [from, to] = self.ends();
        self.law.feature().min(to - from)
    }
}

impl From<&scene::Profile<'_, f32>> for Profile {
    fn from(profile: &scene::Profile<'_, f32>) -> Self {
        let level = match profile.level {
            scene::Level::Height { origin, up } => Level::Height { origin: origin.into(), up: up.into() },
            scene::Level::Radius { center, radius } => Level::Radius { center: center.into(), radius: radius.into() },
        };
        Self::new(level, profile.from.into(), profile.to.into(), Law::from(&profile.law))
    }
}
