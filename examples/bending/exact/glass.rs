//! Graded media with closed forms.

use whit::Vec3;
use whit::scene::{Law, Level, Method, Profile};

use crate::world::Vector;

const FLAT: Level<f64> = Level::Height { origin: Vec3::ZERO, up: Vec3::new(0.0, 1.0, 0.0) };
const ROUND: Level<f64> = Level::Radius { center: Vec3::ZERO, radius: 0.0 };

/// n² = 2.25 − 0.3·y: light goes along parabolas.
pub fn linear(method: Method<f64>) -> Profile<'static, f64> {
    let law = Law::Polynomial { constant: 1.25, linear: -0.3, quadratic: 0.0 };
    Profile { level: FLAT, from: -3.0, to: 3.0, law, method }
}

/// n² = 2.56 − 1.6384·y²: light goes along sines.
pub fn parabolic(method: Method<f64>) -> Profile<'static, f64> {
    let law = Law::Polynomial { constant: 1.56, linear: 0.0, quadratic: -1.6384 };
    Profile { level: FLAT, from: -1.0, to: 1.0, law, method }
}

/// n = e^(−y).
pub fn exponential(method: Method<f64>) -> Profile<'static, f64> {
    let law = Law::Exponential { far: 0.0, excess: 1.0, scale: 1.0 };
    Profile { level: FLAT, from: -1.0, to: 2.0, law, method }
}

/// The height at the distance x of light that starts in the origin of [`exponential`] at an angle above the horizontal, in
/// radians.
pub fn exponential_height(angle: f64, x: f64) -> f64 {
    ((x - angle).cos() / angle.cos()).ln()
}

/// n² = 2 − r², inside of the radius 1.
pub fn luneburg(method: Method<f64>) -> Profile<'static, f64> {
    let law = Law::Polynomial { constant: 1.0, linear: 0.0, quadratic: -1.0 };
    Profile { level: ROUND, from: 0.0, to: 1.0, law, method }
}

/// Where light goes at the far point (1, 0, 0) of [`luneburg`], which it came to along the x axis at the height h.
pub fn luneburg_direction(h: f64) -> Vector {
    [(1.0 - h * h).sqrt(), -h, 0.0]
}

/// n = 2/(1 + r²).
pub fn fish_eye(method: Method<f64>) -> Profile<'static, f64> {
    Profile { level: ROUND, from: 0.0, to: 20.0, law: Law::FishEye { index: 2.0, radius: 1.0 }, method }
}

/// Where all light that starts at a point of [`fish_eye`] meets again.
pub fn conjugate(point: Vector) -> Vector {
    let square: f64 = point.iter().map(|x| x * x).sum();
    point.map(|x| -x / square)
}
