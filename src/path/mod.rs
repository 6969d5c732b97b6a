//! How light gets from a point to the next surface: in a straight line, or bent by the medium or by a black hole.

mod around;
mod arrival;
mod chords;
mod curve;
mod field;
mod graded;
mod integrate;
mod layers;
mod level;
mod orbit;
mod piece;
mod shadow;
mod straight;

pub(crate) use arrival::{Arrival, StepsLeft};
pub(crate) use shadow::{Target, Way, has_bent_shadows, is_hidden, is_lit_straight, towards};
use straight::is_lit;
pub(crate) use straight::{next_surface, next_tinted_surface};

use crate::intersect::{Ray, Wanted, search_scene};
use crate::math::Real;
use crate::scene::{Effects, Index, Object, Scene};
use around::Around;
use arrival::Landing;
use graded::Journey;
use orbit::Passage;

/// Whether a tracer of such effects has paths that are not straight.
pub(crate) const fn is_bent<const EFFECTS: u64>() -> bool {
    Effects::from_bits(EFFECTS).has(Effects::GRADED.with(Effects::BLACK_HOLE))
}

/// A path that starts as a ray, in a scene.
pub(crate) struct Path<'p, 'a, T> {
    pub scene: &'p Scene<'a, T>,
    /// Of the medium that it starts in.
    pub index: Index<T>,
    /// What it may meet: the scene's objects, or nothing.
    pub objects: &'a [Object<'a, T>],
    pub wanted: Wanted,
    /// How far it goes.
    pub limit: T,
}

impl<'p, 'a, T: Real> Path<'p, 'a, T> {
    /// The path to the next surface.
    pub(crate) fn new(scene: &'p Scene<'a, T>, index: Index<T>) -> Self {
        Self { scene, index, objects: scene.objects, wanted: Wanted::Nearest, limit: T::FARTHEST }
    }

    /// Follows the path to its end.
    pub(crate) fn follow<const EFFECTS: u64>(&self, ray: &Ray<T>, steps: &mut StepsLeft) -> Arrival<'a, T> {
        let effects = const { Effects::from_bits(EFFECTS) };
        let &Self { objects, wanted, limit, .. } = self;
        let around = Around::new(objects, wanted);
        match (&self.scene.black_hole, self.scene.profile(&self.index)) {
            (Some(hole), _) if effects.has(Effects::BLACK_HOLE) => {
                Passage { around, hole, limit }.follow::<EFFECTS>(ray, steps)
            }
            (_, Some(profile)) if effects.has(Effects::GRADED) => {
                Journey { around, profile, distance: T::ZERO, limit }.follow::<EFFECTS>(*ray, steps)
            }
            _ => {
                let hit =
                    if objects.is_empty() { None } else { search_scene::<T, EFFECTS>(self.scene, ray, limit, wanted) };
                match hit {
                    Some(hit) => Arrival::Surface(Landing::straight(hit, ray, T::ZERO)),
                    None => Arrival::at_limit(limit, Ray { origin: ray.at(limit), ..*ray }),
                }
            }
        }
    }
}
