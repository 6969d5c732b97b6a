//! A sky with stars.

use super::vector::{Color, Vector};

/// The light from a direction: see [`Background::Stars`](whit::scene::Background::Stars).
pub fn stars(sky: Color, brightness: f64, cells: u16, radius: f64, direction: Vector) -> Color {
    let axes = direction.axes();
    // The first of the longest ones.
    let axis = (0..3).rev().max_by(|&a, &b| axes[a].abs().total_cmp(&axes[b].abs())).unwrap();
    let major = axes[axis];
    let face = 2 * axis as u32 + u32::from(major < 0.0);
    let of_face = |coordinate: f64| 0.5 * (coordinate / major.abs() + 1.0) * f64::from(cells);
    let [s, t] = [of_face(axes[(axis + 1) % 3]), of_face(axes[(axis + 2) % 3])];
    let [i, j] = [s, t].map(|place| (place.floor() as i64).clamp(0, i64::from(cells) - 1) as u32);
    let h = mix(face.wrapping_add(6_u32.wrapping_mul(i.wrapping_add(u32::from(cells).wrapping_mul(j)))));
    if h.is_multiple_of(2) {
        return sky;
    }
    let g = mix(h ^ 0x9e37_79b9);
    let center = |bits: u32| radius + (1.0 - 2.0 * radius) * f64::from(bits) / 65536.0;
    let [x, y] = [s - f64::from(i) - center(g & 0xffff), t - f64::from(j) - center(g >> 16)];
    let square = x * x + y * y;
    if square >= radius * radius {
        return sky;
    }
    let magnitude = (f64::from(h >> 8 & 0xffff) / 65536.0).powi(4);
    let warmth = f64::from(h >> 24) / 256.0;
    let color = Color([0.7, 0.8, 1.0]) * (1.0 - warmth) + Color([1.0, 0.8, 0.6]) * warmth;
    sky + color * (brightness * magnitude * (1.0 - square / (radius * radius)).powi(2))
}

/// Chris Wellons, Prospecting for Hash Functions, 2018: `lowbias32`.
fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ x >> 16
}
