//! Ray against triangle as it was published: Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection"
//! (Journal of Graphics Tools, 1997), with its two faces and its ε.
//!
//! Two triangles work out the side of their shared edge from different numbers, so both can round it away: some rays
//! pass between them. And ε is compared with a volume in scene units, so small triangles are never met.

/// Where the determinant counts as 0.
const EPSILON: f32 = 0.000_001;

/// The distance to the triangle in lengths of `direction`, which may be negative; `None` where the line passes by.
#[must_use]
pub fn intersect(origin: [f32; 3], direction: [f32; 3], vertices: [[f32; 3]; 3]) -> Option<f32> {
    let edge_1 = minus(vertices[1], vertices[0]);
    let edge_2 = minus(vertices[2], vertices[0]);
    let p = cross(direction, edge_2);
    let determinant = dot(edge_1, p);
    if determinant > -EPSILON && determinant < EPSILON {
        return None;
    }
    let inverse = 1.0 / determinant;
    let s = minus(origin, vertices[0]);
    let u = dot(s, p) * inverse;
    if !(0.0..=1.0).contains(&u) {
        return None;
    }
    let q = cross(s, edge_1);
    let v = dot(direction, q) * inverse;
    if v < 0.0 || u + v > 1.0 {
        return None;
    }
    Some(dot(edge_2, q) * inverse)
}

fn minus(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
