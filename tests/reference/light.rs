//! Light that comes straight from a light or from far away.

use whit::scene::{Background, Emitter, Light};

use super::Numbers;
use super::camera::concentric;
use super::stars::stars;
use super::vector::{Color, Vector};

/// What a point receives from a light if nothing is in the way.
pub struct Arriving {
    /// Towards the light, of length 1.
    pub direction: Vector,
    /// Infinite for a directional light.
    pub distance: f64,
    pub color: Color,
}

/// Light at a point; none if the point is where the light is. `dimension` is that of the sample numbers.
pub fn arriving(light: &Light<f32>, point: Vector, dimension: u32, numbers: Numbers<'_>) -> Option<Arriving> {
    let color = Color::from(light.color);
    let source = match light.emitter {
        Emitter::Directional { towards } => {
            let direction = Vector::from(towards).normalized();
            return Some(Arriving { direction, distance: f64::INFINITY, color });
        }
        Emitter::Point { position } => position.into(),
        Emitter::Sphere { center, radius } => {
            let center = Vector::from(center);
            if center == point {
                return None;
            }
            let [x, y] = concentric(numbers(dimension));
            let (tangent, bitangent) = frame((center - point).normalized());
            center + (tangent * x + bitangent * y) * f64::from(radius)
        }
        Emitter::Parallelogram { corner, edge_u, edge_v } => {
            let [s, t] = numbers(dimension);
            Vector::from(corner) + Vector::from(edge_u) * s + Vector::from(edge_v) * t
        }
    };
    let distance = (source - point).length();
    if distance == 0.0 {
        return None;
    }
    let attenuation = light.falloff.map_or(1.0, |falloff| {
        let [constant, linear, quadratic] = [falloff.constant, falloff.linear, falloff.quadratic].map(f64::from);
        1.0 / (constant + linear * distance + quadratic * distance * distance)
    });
    Some(Arriving { direction: (source - point).normalized(), distance, color: color * attenuation })
}

/// Two directions across a unit vector and each other: T. Duff et al., Building an Orthonormal Basis, Revisited,
/// Journal of Computer Graphics Techniques 6 (1), 2017.
pub fn frame(w: Vector) -> (Vector, Vector) {
    let sign = if w.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (sign + w.z);
    let b = w.x * w.y * a;
    (Vector::new(1.0 + sign * w.x * w.x * a, sign * b, -sign * w.x), Vector::new(b, sign + w.y * w.y * a, -w.y))
}

/// Light from far away.
pub fn background(background: &Background<f32>, direction: Vector) -> Color {
    match *background {
        Background::Solid(color) => color.into(),
        Background::Gradient { below, above, up } => {
            let t = 0.5 * (1.0 + direction.dot(up.into()));
            Color::from(below) * (1.0 - t) + Color::from(above) * t
        }
        Background::Sky { horizon, up } => Color::from(horizon) * (1.0 - direction.dot(up.into())).powi(4),
        Background::Stars { sky, brightness, cells, radius } => {
            stars(sky.into(), brightness.into(), cells, radius.into(), direction)
        }
    }
}
