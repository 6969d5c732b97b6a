//! Ray against sphere by the formula of the textbooks.

use whit::Vec3;

/// The roots of a·t² + b·t + c in rising order, with b² − 4·a·c for the discriminant.
#[must_use]
pub fn sphere(origin: Vec3<f32>, direction: Vec3<f32>, center: Vec3<f32>, radius: f32) -> Option<[f32; 2]> {
    let from_center = origin - center;
    let a = direction.dot(direction);
    let b = 2.0 * direction.dot(from_center);
    let c = from_center.dot(from_center) - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    Some([(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)])
}
