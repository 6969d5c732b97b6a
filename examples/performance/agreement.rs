//! Whether two programs found the same.

use std::path::Path;

use crate::rays::{RayFiles, records};

/// How far Embree's floor reaches from the middle.
pub const REACH: f32 = 64.0;
/// Where Embree's rays begin.
pub const NEAR: f32 = 1e-4;
/// Of a distance.
const TOLERANCE: f32 = 1e-3;

/// Numbers of rays.
pub struct Agreement {
    pub closest: usize,
    /// Those that meet the floor where it is in one scene only.
    pub outside: usize,
    /// Those that meet something before Embree's rays begin.
    pub nearer: usize,
    pub closest_differ: usize,
    pub shadow: usize,
    pub shadow_differ: usize,
}

/// A ray, and the two distances.
struct Answer<'a> {
    ray: &'a [f32; 8],
    ours: f32,
    peers: f32,
}

impl Agreement {
    /// Of what whit found and what Embree found.
    pub fn of(files: &RayFiles, ours: &Path, peers: &Path) -> Result<Self, String> {
        let (rays, ours, peers) = (records::<8>(&files.rays)?, records::<1>(ours)?, records::<1>(peers)?);
        if rays.len() != ours.len() || rays.len() != peers.len() {
            return Err("not all rays were answered".to_owned());
        }
        let answers = rays.iter().zip(ours.into_iter().zip(peers));
        let answers: Vec<_> = answers.map(|(ray, ([ours], [peers]))| Answer { ray, ours, peers }).collect();
        let (closest, shadow) = answers.split_at(files.closest.min(answers.len()));
        let outside = closest.iter().filter(|answer| answer.is_outside()).count();
        let nearer = closest.iter().filter(|answer| answer.is_nearer()).count();
        let differ = |answer: &&Answer<'_>| !answer.is_outside() && !answer.is_nearer() && answer.differs();
        Ok(Self {
            closest: closest.len(),
            outside,
            nearer,
            closest_differ: closest.iter().filter(differ).count(),
            shadow: shadow.len(),
            shadow_differ: shadow.iter().filter(|answer| answer.ours != answer.peers).count(),
        })
    }
}

impl Answer<'_> {
    /// Whether the ray meets something where Embree has no floor.
    fn is_outside(&self) -> bool {
        let [x, y, _, right, back, ..] = self.ray;
        let place = |from: &f32, along: &f32| from + along * self.ours;
        self.ours.is_finite() && place(x, right).abs().max(place(y, back).abs()) > REACH
    }

    fn is_nearer(&self) -> bool {
        self.ours < NEAR
    }

    /// Infinity is equal to itself, and to nothing else.
    fn differs(&self) -> bool {
        let near = (self.ours - self.peers).abs() <= TOLERANCE * self.ours;
        self.ours != self.peers && !(near && self.ours.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_agree_to_a_thousandth() {
        let ray = [0.0, 0.0, 1.0, 0.8, 0.0, -0.6, f32::INFINITY, 0.0];
        let answer = |ours, peers| Answer { ray: &ray, ours, peers };
        assert!(!answer(2.0, 2.001).differs() && answer(2.0, 2.01).differs());
        assert!(!answer(f32::INFINITY, f32::INFINITY).differs());
        assert!(answer(2.0, f32::INFINITY).differs() && answer(f32::INFINITY, 2.0).differs());
        assert!(answer(81.0, 81.0).is_outside() && !answer(79.0, 79.0).is_outside());
        assert!(!answer(f32::INFINITY, 2.0).is_outside());
        assert!(answer(5e-5, 2.0).is_nearer() && !answer(2e-4, 2e-4).is_nearer());
    }
}
