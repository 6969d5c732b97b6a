//! The way through a medium that is cut into layers.

use super::arrival::{Arrival, StepsLeft};
use super::graded::{Journey, Leg, Zone};
use super::level;
use crate::intersect::Ray;
use crate::math::{Real, Vec3};
use crate::scene::{Layers, Profile};

/// Light in a layer.
pub(super) struct Layered<'p, 'a, T> {
    profile: &'p Profile<'a, T>,
    layers: Layers<T>,
    /// Which one the light is in.
    layer: T,
    position: Vec3<T>,
    /// n·direction, of which what lies along the layers does not change.
    momentum: Vec3<T>,
}

impl<'p, 'a, T: Real> Layered<'p, 'a, T> {
    /// Light that starts in a layer, or comes from one side of them all.
    pub(super) fn new<const EFFECTS: u64>(
        profile: &'p Profile<'a, T>,
        thickness: T,
        ray: &Ray<T>,
        before: Zone,
    ) -> Self {
        let layers = profile.layers(thickness);
        let layer = match before {
            Zone::Below => -T::ONE,
            Zone::Between => layers.at(profile.level.of::<EFFECTS>(ray.origin)),
            Zone::Above => layers.count,
        };
        let index = (T::ONE + profile.square::<EFFECTS>(layers.level(layer)).excess).sqrt();
        Self { profile, layers, layer, position: ray.origin, momentum: ray.direction * index }
    }

    /// n² − 1 in a layer.
    fn excess<const EFFECTS: u64>(&self, layer: T) -> T {
        self.profile.square::<EFFECTS>(self.layers.level(layer)).excess
    }

    /// Follows the path from layer to layer.
    pub(super) fn follow<const EFFECTS: u64>(
        mut self,
        journey: &mut Journey<'_, 'a, T>,
        steps: &mut StepsLeft,
    ) -> Leg<'a, T> {
        let level = self.profile.level;
        if let Some(side) = self.entering() {
            self.cross::<EFFECTS>(side);
        }
        loop {
            let ray = Ray { origin: self.position, direction: self.momentum.normalized() };
            if let Some(zone) = self.outside() {
                return Leg::Border(ray, zone);
            }
            if !steps.take() {
                return Leg::End(Arrival::OutOfSteps(ray.direction));
            }
            let (_, up) = level::with_gradient::<T, EFFECTS>(&level, ray.origin);
            let (below, above) = (self.layers.border(self.layer), self.layers.border(self.layer + T::ONE));
            let falling =
                if ray.direction.dot(up) < T::ZERO { level::down_to::<T, EFFECTS>(&level, below, &ray) } else { None };
            // Where light falls along a round layer, it leaves it at the top all the same.
            let (way, side) = match falling {
                Some(way) => (Some(way), -T::ONE),
                None => (level::up_to::<T, EFFECTS>(&level, above, &ray), T::ONE),
            };
            match journey.stretch::<EFFECTS>(&ray, way) {
                Ok(there) => self.position = there.origin,
                Err(arrival) => return Leg::End(arrival),
            }
            self.cross::<EFFECTS>(side);
        }
    }

    /// The zone outside of the layers that the light is in.
    fn outside(&self) -> Option<Zone> {
        if self.layer < T::ZERO {
            Some(Zone::Below)
        } else if self.layer >= self.layers.count {
            Some(Zone::Above)
        } else {
            None
        }
    }

    /// Which way light from outside crosses the border to the first layer.
    fn entering(&self) -> Option<T> {
        self.outside().map(|zone| if zone == Zone::Below { T::ONE } else { -T::ONE })
    }

    /// Snell's law at the border to the next layer upwards (1) or downwards (−1): what of the momentum lies along the border
    /// stays, and its length becomes the next index; or else the reflection is total.
    fn cross<const EFFECTS: u64>(&mut self, side: T) {
        let (_, up) = level::with_gradient::<T, EFFECTS>(&self.profile.level, self.position);
        let next = self.layer + side;
        let across = self.momentum.dot(up);
        let change = self.excess::<EFFECTS>(next) - self.excess::<EFFECTS>(self.layer);
        let square = across * across + change;
        let behind = if square > T::ZERO {
            self.layer = next;
            square.sqrt() * side
        } else {
            -across
        };
        self.momentum += up * (behind - across);
    }
}
