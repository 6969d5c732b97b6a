//! The objects that a piece of a ray may meet, each once and in the order of the list.

use super::Ray;
use super::search::has;
use super::walk::walk;
use crate::math::Real;
use crate::scene::{Effects, Scene};

/// How many are told one by one.
const FEW: usize = 16;

/// The numbers of objects that a ray may meet before a limit.
pub(crate) struct Candidates {
    /// In ascending order; more than `FEW` are all.
    numbers: [u16; FEW],
    count: usize,
}

impl Candidates {
    /// All objects, where the scene has no hierarchy.
    pub(crate) fn new<T: Real, const EFFECTS: u64>(scene: &Scene<'_, T>, ray: &Ray<T>, limit: T) -> Self {
        let mut few = Self { numbers: [0; FEW], count: 0 };
        let hierarchy = match &scene.hierarchy {
            Some(hierarchy) if has::<EFFECTS>(Effects::HIERARCHY) => hierarchy,
            _ => return Self::all(scene),
        };
        for leaf in hierarchy.leaves.iter().take(hierarchy.unbounded) {
            few.add(leaf.object as u16);
        }
        walk(hierarchy, ray, limit, |leaf| few.add(leaf.object as u16).then_some(limit));
        if few.count > FEW { Self::all(scene) } else { few }
    }

    fn all<T>(scene: &Scene<'_, T>) -> Self {
        Self { numbers: [0; FEW], count: scene.objects.len().max(FEW + 1) }
    }

    /// Puts a number into its place; whether there was room.
    fn add(&mut self, number: u16) -> bool {
        let place = self.numbers.iter().take(self.count).take_while(|other| **other < number).count();
        if self.numbers.iter().take(self.count).nth(place) == Some(&number) {
            return true;
        }
        let mut next = number;
        for other in self.numbers.iter_mut().take(self.count + 1).skip(place) {
            core::mem::swap(other, &mut next);
        }
        self.count += 1;
        self.count <= FEW
    }

    /// The numbers.
    pub(crate) fn iter(&self) -> impl Iterator<Item = u16> {
        let number =
            |place: usize| if self.count > FEW { Some(place as u16) } else { self.numbers.get(place).copied() };
        (0..self.count).map_while(number)
    }
}
