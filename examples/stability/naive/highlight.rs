//! A highlight as textbooks print it, in `f32`.

/// max(0, N·H)ˢ for the unit vectors `normal` and `half`.
///
/// What goes wrong: rounding makes the cosine of two vectors that agree a little more than 1, and a high power makes a
/// lot of that.
pub fn highlight(normal: [f32; 3], half: [f32; 3], exponent: f32) -> f32 {
    let cosine = normal[0] * half[0] + normal[1] * half[1] + normal[2] * half[2];
    cosine.max(0.0).powf(exponent)
}
