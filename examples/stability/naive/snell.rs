//! Snell's law and the Fresnel equations as textbooks print them, in `f32`.

/// cos θ₂ = √(1 − η²(1 − c²)) with η = n₁/n₂; `None` where the radicand is negative: total reflection.
///
/// What goes wrong: near the critical angle the radicand is the difference of two numbers near 1, each with its own
/// rounding error, so its sign is a matter of chance. For indices that are nearly equal η² is itself next to 1, and the
/// radicand keeps no digits at all.
pub fn transmitted_cosine(n1: f32, n2: f32, cosine: f32) -> Option<f32> {
    let eta = n1 / n2;
    let radicand = 1.0 - eta * eta * (1.0 - cosine * cosine);
    if radicand < 0.0 { None } else { Some(radicand.sqrt()) }
}

/// The refracted direction η·D + (η·c₁ − c₂)·N for the unit vectors `incident` and `normal`, which face each other.
///
/// What goes wrong: it is not normalised, so each refraction leaves its error in the length.
pub fn refract(incident: [f32; 3], normal: [f32; 3], n1: f32, n2: f32) -> Option<[f32; 3]> {
    let [a, b] = [incident, normal];
    let cosine = -(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    let along = n1 / n2 * cosine - transmitted_cosine(n1, n2, cosine)?;
    Some([0, 1, 2].map(|i| n1 / n2 * a[i] + along * b[i]))
}

/// The reflectance of unpolarised light, the mean of ((n₁c₁ − n₂c₂)/(n₁c₁ + n₂c₂))² and
/// ((n₁c₂ − n₂c₁)/(n₁c₂ + n₂c₁))².
///
/// What goes wrong: along an interface between equal media it is 0/0; between nearly equal ones both differences cancel.
pub fn reflectance(n1: f32, n2: f32, cosine: f32) -> f32 {
    let Some(c2) = transmitted_cosine(n1, n2, cosine) else { return 1.0 };
    let s = (n1 * cosine - n2 * c2) / (n1 * cosine + n2 * c2);
    let p = (n1 * c2 - n2 * cosine) / (n1 * c2 + n2 * cosine);
    (s * s + p * p) / 2.0
}
