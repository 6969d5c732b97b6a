//! Lights and what is far away.

use whit::scene::{Emitter, Falloff};
use whit::{Background, Light};

use super::Source;
use super::span::{AMOUNT, POSITIVE};

impl Source<'_> {
    pub fn light(&mut self) -> Light<f32> {
        let emitter = match self.below(6) {
            0 | 1 => Emitter::Point { position: self.point() },
            2 => Emitter::Directional { towards: self.direction() },
            3 => Emitter::Sphere { center: self.point(), radius: self.size(POSITIVE) },
            _ => Emitter::Parallelogram { corner: self.point(), edge_u: self.point(), edge_v: self.point() },
        };
        let falloff = if self.once_in(3) { Some(self.falloff()) } else { None };
        Light { emitter, color: self.color(), falloff }
    }

    fn falloff(&mut self) -> Falloff<f32> {
        let constant = self.number(POSITIVE);
        Falloff { constant, linear: self.number(AMOUNT), quadratic: self.number(AMOUNT) }
    }

    pub fn background(&mut self) -> Background<f32> {
        match self.below(4) {
            0 | 1 => Background::Solid(self.color()),
            2 => Background::Gradient { below: self.color(), above: self.color(), up: self.unit() },
            _ => Background::Sky { horizon: self.color(), up: self.unit() },
        }
    }
}
