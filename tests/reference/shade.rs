//! The light that a surface sends to the eye by itself: its body and its highlight.

use whit::scene::{Exponent, Lobe, Material, Pattern};

use super::light::arriving;
use super::optics::reflect;
use super::shadow::Way;
use super::vector::{Color, Vector};
use super::world::{Hit, World};
use super::{Counts, Numbers};

/// Dimension of the sample numbers for the first light at depth 0.
pub const FIRST_LIGHT: u32 = 2;

/// Body: colour · share · (emission + Σ L·(ambient + diffuse·max(0, N·ω))), with the share that a coat leaves to the
/// body. Highlight: Σ L · colour · cosˢ. The sums are over the lights in front of the surface that no object hides, in
/// the colour that the media on the way leave them.
pub fn local(
    world: &World<'_>,
    hit: &Hit<'_>,
    view: Vector,
    share: Color,
    depth: u32,
    numbers: Numbers<'_>,
    counts: &mut Counts,
) -> Color {
    let material = &hit.object.material;
    let body = material.body.map(|body| {
        (
            pattern(&body.color, hit.point) * share,
            f64::from(body.emission),
            f64::from(body.ambient),
            f64::from(body.diffuse),
        )
    });
    let mut light = body.map_or(Color::BLACK, |(color, emission, ..)| color * emission);
    if body.is_none() && material.highlight.is_none() {
        return light;
    }
    let lights = world.scene.lights;
    for (i, source) in (0..).zip(lights) {
        let dimension = FIRST_LIGHT + depth * lights.len() as u32 + i;
        let Some(arriving) = arriving(source, hit.point, dimension, numbers) else { continue };
        let Some(way) = Way::to_light(world, hit, &arriving) else { continue };
        let omega = way.direction();
        if hit.normal.dot(omega) <= 0.0 || hit.geometric.dot(omega) <= 0.0 {
            continue;
        }
        counts.shadow += 1;
        if way.is_blocked(world) {
            continue;
        }
        let color_of_light = arriving.color * way.clarity(world);
        if let Some((color, _, ambient, diffuse)) = body {
            light += color * color_of_light * (ambient + diffuse * hit.normal.dot(omega).max(0.0));
        }
        if let Some(highlight) = &material.highlight {
            let cosine = match highlight.lobe {
                Lobe::Blinn => hit.normal.dot((omega - view).normalized()),
                Lobe::Phong => reflect(view, hit.normal).dot(omega),
            };
            let exponent = match highlight.exponent {
                Exponent::Integer(n) => f64::from(n),
                Exponent::Real(s) => f64::from(s),
            };
            light += color_of_light * Color::from(highlight.color) * cosine.max(0.0).powf(exponent);
        }
    }
    light
}

/// The factors on the light of a surface's own, and on that of its branches.
pub fn balance(material: &Material<f32>) -> (f64, f64) {
    material.balance.map_or((1.0, 1.0), |balance| {
        let (ratio, brightness) = (f64::from(balance.ratio), f64::from(balance.brightness));
        (brightness * (1.0 - ratio), brightness * ratio)
    })
}

/// The colour of a body at a point.
pub fn pattern(pattern: &Pattern<f32>, point: Vector) -> Color {
    match *pattern {
        Pattern::Solid(color) => color.into(),
        Pattern::Checker { even, odd, u, v } => {
            let sum = point.dot(u.into()).floor() + point.dot(v.into()).floor();
            if sum.rem_euclid(2.0) == 0.0 { even.into() } else { odd.into() }
        }
        Pattern::Gradient { from, to, origin, axis } => {
            let t = (point - origin.into()).dot(axis.into()).clamp(0.0, 1.0);
            Color::from(from) * (1.0 - t) + Color::from(to) * t
        }
        Pattern::Rings { even, odd, center, width } => {
            let ring = ((point - center.into()).length() / f64::from(width)).floor();
            if ring.rem_euclid(2.0) == 0.0 { even.into() } else { odd.into() }
        }
    }
}
