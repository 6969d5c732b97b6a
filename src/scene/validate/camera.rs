//! Cameras and lights.

use super::number::{
    BRIGHTEST, Fault, POSITIVE, amount, check, color, direction, dot, ensure, minus, point, positive, within,
};
use crate::scene::{Aperture, Camera, Emitter, Light};

impl Camera<f32> {
    pub(in crate::scene) const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.eye, "eye"));
        ensure!(point(self.target, "target"));
        ensure!(direction(self.up, "up"));
        let sight = minus(self.target, self.eye);
        ensure!(check(dot(sight, sight) > 1e-24, "target", "a point away from the eye"));
        let along = dot(sight, self.up);
        let parallel = along * along >= 0.999_999 * dot(sight, sight) * dot(self.up, self.up);
        ensure!(check(!parallel, "up", "a direction that is not the line of sight"));
        ensure!(check(within(self.half_height, 1e-6, 1e6), "half_height", "a tangent from 1e-6 to 1e6"));
        let Some(lens) = &self.lens else { return Ok(()) };
        ensure!(match lens.aperture {
            Aperture::Disc { radius } => amount(radius, "lens.aperture"),
            Aperture::Square { side } => amount(side, "lens.aperture"),
        });
        positive(lens.focus, "lens.focus")
    }
}

impl Light<f32> {
    pub(in crate::scene) const fn check(&self) -> Result<(), Fault> {
        ensure!(color(self.color, "color"));
        match self.emitter {
            Emitter::Point { position } => ensure!(point(position, "position")),
            Emitter::Directional { towards } => ensure!(direction(towards, "towards")),
            Emitter::Sphere { center, radius } => {
                ensure!(point(center, "center"));
                ensure!(positive(radius, "radius"));
            }
            Emitter::Parallelogram { corner, edge_u, edge_v } => {
                ensure!(point(corner, "corner"));
                ensure!(point(edge_u, "edge_u"));
                ensure!(point(edge_v, "edge_v"));
            }
        }
        let Some(falloff) = &self.falloff else { return Ok(()) };
        ensure!(check(within(falloff.constant, 1e-12, BRIGHTEST), "falloff.constant", POSITIVE));
        ensure!(amount(falloff.linear, "falloff.linear"));
        check(within(falloff.quadratic, 0.0, 1e24), "falloff.quadratic", "a number from 0 to 1e24")
    }
}
