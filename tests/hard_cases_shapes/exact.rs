//! Vectors of `f64`, apart from the library's.

use whit::{Ray, Vec3};

/// The unit roundoff of `f32`.
pub const ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

pub type Vector = [f64; 3];

pub fn exact(v: Vec3<f32>) -> Vector {
    [v.x, v.y, v.z].map(f64::from)
}

pub fn rounded(v: Vector) -> Vec3<f32> {
    Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32)
}

pub fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn times(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub fn unit(a: Vector) -> Vector {
    times(a, 1.0 / length(a))
}

/// The ray from a point towards another, its direction rounded once.
pub fn ray_to(origin: Vec3<f32>, target: Vector) -> Ray<f32> {
    Ray { origin, direction: rounded(unit(minus(target, exact(origin)))) }
}

/// The same number so many steps of `f32` up or down.
pub fn nudged(x: f32, steps: i32) -> f32 {
    (0..steps.abs()).fold(x, |x, _| if steps > 0 { x.next_up() } else { x.next_down() })
}
