//! Beer's law by small steps, in `f32`.

/// The share of light that is left after a distance, by Euler's method for dI/dx = −c·I: each step takes c·dx of it.
///
/// What goes wrong: where a step takes more than there is, what is left is negative, and where it takes more than twice
/// as much, it grows from step to step without an end.
pub fn transmittance(constant: f32, distance: f32, steps: u32) -> f32 {
    let step = distance / steps as f32;
    (0..steps).fold(1.0, |left, _| left - constant * step * left)
}
