//! Eye rays.

use whit::scene::{Aperture, Camera, Extent};

use super::Numbers;
use super::shapes::Ray;
use super::vector::Vector;

/// Dimension of the sample numbers for the point of the lens.
pub const LENS: u32 = 1;

/// The ray for the point (px, py) of the picture, in pixels from its upper left corner.
pub fn eye_ray(camera: &Camera<f32>, [width, height]: [u32; 2], [px, py]: [f64; 2], numbers: Numbers<'_>) -> Ray {
    let (width, height) = (f64::from(width), f64::from(height));
    let (eye, target) = (Vector::from(camera.eye), Vector::from(camera.target));
    let forward = (target - eye).normalized();
    let right = forward.cross(camera.up.into()).normalized();
    let up = right.cross(forward);
    let half_height = match camera.extent {
        Extent::PixelEdges => f64::from(camera.half_height),
        Extent::PixelCentres => f64::from(camera.half_height) * height / (height - 1.0).max(1.0),
    };
    let half_width = half_height * width / height;
    let x = (2.0 * px / width - 1.0) * half_width;
    let y = (1.0 - 2.0 * py / height) * half_height;
    let sight = forward + right * x + up * y;
    let Some(lens) = &camera.lens else { return Ray::new(eye, sight) };
    let [s, t] = numbers(LENS);
    let [a, b] = match lens.aperture {
        Aperture::Square { side } => [(s - 0.5) * f64::from(side), (t - 0.5) * f64::from(side)],
        Aperture::Disc { radius } => concentric([s, t]).map(|offset| offset * f64::from(radius)),
    };
    let in_focus = eye + sight * f64::from(lens.focus);
    let origin = eye + right * a + up * b;
    Ray::new(origin, in_focus - origin)
}

/// A point of the unit square on the unit disc: P. Shirley and K. Chiu, A Low Distortion Map Between Disk and Square,
/// Journal of Graphics Tools 2 (3), 1997.
pub fn concentric([s, t]: [f64; 2]) -> [f64; 2] {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
    let (x, y) = (2.0 * s - 1.0, 2.0 * t - 1.0);
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let (radius, angle) = if x.abs() > y.abs() { (x, FRAC_PI_4 * y / x) } else { (y, FRAC_PI_2 - FRAC_PI_4 * x / y) };
    [radius * angle.cos(), radius * angle.sin()]
}
