//! Light from a light along a bent path.

use super::illumination::Illumination;
use super::{Budget, Cut, Observer};
use crate::math::{Real, Rgb};
use crate::path::{StepsLeft, Target, Way, is_hidden, towards};
use crate::scene::{Effects, Index, Scene};

/// A path to a light, if it is bent, and the steps that are left for it.
pub(super) struct BentLight<T> {
    way: Option<(Way<T>, Index<T>)>,
    steps: StepsLeft,
}

impl<T: Real> BentLight<T> {
    pub(super) fn new(budget: &Budget<T>) -> Self {
        Self { way: None, steps: StepsLeft::new(budget.steps_per_ray) }
    }

    /// Finds the bent path for light that would come straight; `None` if there is none.
    pub(super) fn aim<const EFFECTS: u64>(
        &mut self,
        scene: &Scene<'_, T>,
        index: Index<T>,
        straight: Illumination<T>,
    ) -> Option<Illumination<T>> {
        let Illumination { ray, distance, color } = straight;
        let infinite = distance == T::MAX;
        let target = if infinite { Target::Direction(ray.direction) } else { Target::Point(ray.at(distance)) };
        let way = towards::<T, EFFECTS>(scene, index, ray.origin, target, &mut self.steps)?;
        self.way = Some((way, index));
        Some(Illumination { ray: way.ray, distance: if infinite { distance } else { way.length }, color })
    }

    /// Whether something is in the way of the path.
    pub(super) fn is_hidden<const EFFECTS: u64>(&mut self, scene: &Scene<'_, T>) -> bool {
        match &self.way {
            Some((way, index)) if Effects::from_bits(EFFECTS).has(Effects::BENT_SHADOWS) => {
                is_hidden::<T, EFFECTS>(scene, *index, way, &mut self.steps)
            }
            _ => false,
        }
    }

    /// Reports the steps that were taken, and that there were too few of them; gives how many. The throughput is that of
    /// the light, which was lost then.
    pub(super) fn report(&self, throughput: Rgb<T>, observer: &mut impl Observer) -> u32 {
        observer.steps(self.steps.taken());
        if self.steps.were_too_few {
            observer.cut(Cut::Steps, throughput.map(T::to_f32));
        }
        self.steps.taken()
    }
}
