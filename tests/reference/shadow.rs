//! The way from a surface to a light.

use whit::scene::{Shadow, ShadowRays};

use super::aim::{Path, Target, aim};
use super::light::Arriving;
use super::shapes::Ray;
use super::vector::{Color, Vector};
use super::walk::{Span, Walk};
use super::world::{Hit, World};

/// A way to a light, past the objects or not.
pub enum Way {
    Straight { towards: Vector, ray: Ray, distance: f64 },
    Bent { ray: Ray, path: Path, scale: f64 },
}

impl Way {
    /// The way that light comes by, if any. A bent one is bent all the way as the medium at its start bends light, whatever
    /// objects it leads through.
    pub fn to_light(world: &World<'_>, hit: &Hit<'_>, arriving: &Arriving) -> Option<Self> {
        let (ray, distance) = (hit.leave(arriving.direction), arriving.distance);
        let bend = if world.scene.shadow_rays == ShadowRays::Bent { world.bend(&ray) } else { None };
        let Some(bend) = bend else { return Some(Self::Straight { towards: arriving.direction, ray, distance }) };
        let target =
            if distance.is_finite() { Target::Point(ray.at(distance)) } else { Target::Direction(ray.direction) };
        let path = aim(bend, hit.point, target)?;
        Some(Self::Bent { ray: hit.leave(path.direction), path, scale: bend.scale() })
    }

    /// Towards the light, of length 1, at its start.
    pub fn direction(&self) -> Vector {
        match self {
            Self::Straight { towards, .. } => *towards,
            Self::Bent { ray, .. } => ray.direction,
        }
    }

    /// Whether an object with a full shadow is in the way, or the hole.
    pub fn is_blocked(&self, world: &World<'_>) -> bool {
        match self {
            Self::Straight { ray, distance, .. } => {
                let swallowed = world.hole.is_some_and(|hole| hole.blocks(ray.origin, ray.direction, *distance));
                swallowed || world.is_blocked(ray, *distance)
            }
            Self::Bent { .. } => self
                .find(world, |span, last| {
                    // What the light lies on does not hide it.
                    let reach = if last { span.length * (1.0 - 1e-9) } else { span.reach() };
                    (span.near && world.is_blocked(&span.ray, reach)).then_some(())
                })
                .is_some(),
        }
    }

    /// The colour that the media leave of the light.
    pub fn clarity(&self, world: &World<'_>) -> Color {
        let Self::Straight { ray, distance, .. } = self else {
            let mut clarity = Color::WHITE;
            self.find(world, |span, _| {
                let of_chord = world.clarity(&span.ray, span.length, |o| o.shadow == Shadow::Tinted);
                clarity = clarity * of_chord.map(|share| share.powf(span.stretch));
                None::<()>
            });
            return clarity;
        };
        world.clarity(ray, *distance, |o| o.shadow == Shadow::Tinted)
    }

    /// What is found in the spans of a bent way; of each, whether it may be the last one.
    fn find<T>(&self, world: &World<'_>, mut visit: impl FnMut(&Span, bool) -> Option<T>) -> Option<T> {
        let Self::Bent { ray, path, scale } = self else { return None };
        path.pieces.iter().enumerate().find_map(|(i, piece)| {
            let last = i + 1 == path.pieces.len();
            let walk = Walk { world, piece, scale: *scale, start: (i == 0).then_some(ray) };
            walk.find(if last { path.last } else { 1.0 }, &mut |span| visit(span, last))
        })
    }
}
