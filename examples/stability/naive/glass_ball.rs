//! A ray through a ball of glass, in textbook formulas and `f32`.

use super::snell;

/// What becomes of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// It misses the ball.
    Past,
    /// It goes in and out again; the direction behind.
    Through([f32; 3]),
    /// It goes in and is reflected totally on the other side.
    Inside,
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Follows a ray of unit direction from outside through a ball with the index of refraction `n`.
///
/// What goes wrong: no ray that gets into a ball can be reflected totally in it, since it meets the surface from inside
/// at the very angle it got in with. Rounding makes the two angles differ, and where the ray comes in at a grazing angle,
/// the other one is next to the critical angle.
pub fn follow(origin: [f32; 3], direction: [f32; 3], center: [f32; 3], radius: f32, n: f32) -> Way {
    let from_center = [0, 1, 2].map(|i| origin[i] - center[i]);
    let b = 2.0 * dot(from_center, direction);
    let c = dot(from_center, from_center) - radius * radius;
    let discriminant = b * b - 4.0 * c;
    if discriminant < 0.0 {
        return Way::Past;
    }
    let t = (-b - discriminant.sqrt()) / 2.0;
    if t <= 0.0 {
        return Way::Past;
    }
    let normal_at = |point: [f32; 3]| [0, 1, 2].map(|i| (point[i] - center[i]) / radius);
    let entry = [0, 1, 2].map(|i| origin[i] + t * direction[i]);
    let Some(inner) = snell::refract(direction, normal_at(entry), 1.0, n) else { return Way::Past };
    // From a point on the ball the other end of a chord is at −2(p − c)·d.
    let chord = -2.0 * dot(normal_at(entry), inner) * radius;
    let exit = [0, 1, 2].map(|i| entry[i] + chord * inner[i]);
    match snell::refract(inner, normal_at(exit).map(|x| -x), n, 1.0) {
        Some(outer) => Way::Through(outer),
        None => Way::Inside,
    }
}
