//! The law of reflection as textbooks print it, in `f32`.

/// The mirrored direction D − 2(D·N)·N of the unit vectors `incident` and `normal`.
///
/// What goes wrong: a normal that is a rounding error too long makes each direction longer than the last one. A ray
/// tracer takes the parameter along a ray for a distance, and cosines from scalar products, so both drift away.
pub fn reflect(incident: [f32; 3], normal: [f32; 3]) -> [f32; 3] {
    let along = incident[0] * normal[0] + incident[1] * normal[1] + incident[2] * normal[2];
    [0, 1, 2].map(|i| incident[i] - 2.0 * along * normal[i])
}
