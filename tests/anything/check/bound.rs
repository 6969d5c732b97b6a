//! The most light that a pixel can show.
//!
//! A sample that is not a number would come out as the largest one; this tells it from a bright one.

use whit::scene::{Body, Emitter, Highlight};
use whit::{Background, Light, Material, Pattern, Real, Rgb, Scene, Settings, Termination, Tone};

/// What underflow may add up to.
const SMALLEST: f64 = 1e-35;

/// An upper bound on a pixel, and a lower one.
pub fn limits<T: Real>(scene: &Scene<'_, T>, settings: &Settings<T>, branches: u64) -> (f64, f64) {
    let far = match scene.background {
        Background::Solid(color) => largest(color),
        Background::Gradient { below, above, .. } => largest(below).max(largest(above)) * 1.01,
        Background::Sky { horizon, .. } => largest(horizon) * 16.1,
        Background::Stars { sky, brightness, .. } => largest(sky) + value(brightness),
    };
    let cut = match settings.budget.termination {
        Termination::Color(color) => largest(color),
        Termination::Background | Termination::Black => 0.0,
    };
    let arriving: f64 = scene.lights.iter().map(arriving).sum();
    let own = scene.objects.iter().map(|object| own(&object.material, arriving)).fold(0.0, f64::max);
    // Each bounce at most doubles what a branch weighs, and a branch sees one surface or has up to 5 that are cut.
    let weight = 2.0_f64.powi(i32::from(settings.budget.depth).min(16) + 1);
    let light = (far.max(cut) * 6.0 + own) * weight * (branches as f64 + 1.0);
    match scene.tone {
        Tone::Linear => (light * 1.01 + SMALLEST, 0.0),
        Tone::Display { gain, lift } => ((light * value(gain) + value(lift).max(0.0)) * 1.01 + SMALLEST, value(lift)),
    }
}

fn arriving<T: Real>(light: &Light<T>) -> f64 {
    let share = match (light.emitter, light.falloff) {
        (Emitter::Directional { .. }, _) | (_, None) => 1.0,
        (_, Some(falloff)) => 1.0 / value(falloff.constant),
    };
    largest(light.color) * share
}

fn own<T: Real>(material: &Material<T>, arriving: f64) -> f64 {
    let body = material.body.map_or(0.0, |Body { color, emission, ambient, diffuse }| {
        let color = match color {
            Pattern::Solid(color) => largest(color),
            Pattern::Checker { even: a, odd: b, .. }
            | Pattern::Rings { even: a, odd: b, .. }
            | Pattern::Gradient { from: a, to: b, .. } => largest(a).max(largest(b)),
        };
        color * (value(emission) + arriving * (value(ambient) + value(diffuse)))
    });
    let highlight = material.highlight.map_or(0.0, |Highlight { color, .. }| largest(color) * arriving);
    let share = material.balance.map_or(1.0, |balance| value(balance.brightness) * (1.0 - value(balance.ratio)));
    (body + highlight) * share
}

fn largest<T: Real>(color: Rgb<T>) -> f64 {
    value(color.max_channel())
}

fn value<T: Real>(x: T) -> f64 {
    f64::from(x.to_f32())
}
