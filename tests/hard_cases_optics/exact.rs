//! Snell's law and the Fresnel equations on `f32` inputs, without rounding or nearly so.

/// A number m·2ᵉ with an integer m: every finite `f32` that is not negative.
fn parts(x: f32) -> (i128, i32) {
    let (exponent, fraction) = ((x.to_bits() >> 23) as i32, i128::from(x.to_bits() & 0x7f_ffff));
    if exponent == 0 { (fraction, -149) } else { (fraction | 0x80_0000, exponent - 150) }
}

/// Whether n₂² < n₁²(1 − c²), in integers: no rounding at all. The cosine is at least 2⁻¹³.
pub fn is_total(n1: f32, n2: f32, cosine: f32) -> bool {
    let ((m1, e1), (m2, e2), (mc, ec)) = (parts(n1), parts(n2), parts(cosine));
    let unit = (2 * e1 + 2 * ec.min(0)).min(2 * e2);
    let in_units = |m: i128, e: i32| m.checked_mul(1 << (e - unit)).unwrap();
    in_units(m2 * m2, 2 * e2) - in_units(m1 * m1, 2 * e1) + in_units(m1 * m1 * mc * mc, 2 * e1 + 2 * ec) < 0
}

/// R_s, R_p and cos θ₂ in `f64`; `None` on total reflection.
pub fn fresnel(n1: f32, n2: f32, cosine: f32) -> Option<[f64; 3]> {
    let (n1, n2, c) = (f64::from(n1), f64::from(n2), f64::from(cosine));
    let radicand = (n2 - n1) * (n2 + n1) + (n1 * c) * (n1 * c);
    if radicand < 0.0 {
        return None;
    }
    let g = radicand.sqrt();
    let s = (n1 * c - g) / (n1 * c + g);
    let p = (n2 * n2 * c - n1 * g) / (n2 * n2 * c + n1 * g);
    Some([s * s, p * p, g / n2])
}

/// cos θ of the critical angle from n₁ into the thinner n₂.
pub fn critical_cosine(n1: f32, n2: f32) -> f64 {
    let (n1, n2) = (f64::from(n1), f64::from(n2));
    ((n1 - n2) * (n1 + n2)).sqrt() / n1
}
