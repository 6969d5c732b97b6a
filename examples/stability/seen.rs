//! A ray tracer of a few lines whose parts can be exchanged, for pictures of what a naive part does.

use whit::{Ray, Rgb, Vec3};

use super::picture::{HEIGHT, WIDTH};

/// What a ray meets.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    pub distance: f32,
    pub point: Vec3<f32>,
    /// Unit normal on the side of the ray.
    pub normal: Vec3<f32>,
    /// The colour of the surface there.
    pub color: Rgb<f32>,
}

/// The eye of the pictures.
pub struct Eye {
    pub position: Vec3<f32>,
    pub target: Vec3<f32>,
    /// Half the height of the picture at distance 1.
    pub half_height: f32,
}

impl Eye {
    /// The ray through a point of the picture.
    pub fn ray(&self, x: f32, y: f32) -> Ray<f32> {
        let forward = (self.target - self.position).normalized();
        let right = forward.cross(Vec3::new(0.0, 1.0, 0.0)).normalized();
        let (width, height) = (WIDTH as f32, HEIGHT as f32);
        let scale = 2.0 * self.half_height / height;
        let (across, up) = ((x - width / 2.0) * scale, (height / 2.0 - y) * scale);
        let direction = (forward + right * across + right.cross(forward) * up).normalized();
        Ray { origin: self.position, direction }
    }
}

/// The light of a directional light, if no surface stands in its way, and a little from everywhere.
pub fn light(
    ray: &Ray<f32>,
    towards: Vec3<f32>,
    meet: impl Fn(&Ray<f32>) -> Option<Seen>,
    leave: impl Fn(&Ray<f32>, &Seen, Vec3<f32>) -> Ray<f32>,
) -> Rgb<f32> {
    let Some(seen) = meet(ray) else { return Rgb::new(0.55, 0.7, 0.9) };
    let cosine = seen.normal.dot(towards).max(0.0);
    let is_lit = cosine > 0.0 && meet(&leave(ray, &seen, towards)).is_none();
    seen.color * if is_lit { 0.15 + 0.8 * cosine } else { 0.15 }
}

/// Squares of the given side on the ground.
pub fn checker(point: Vec3<f32>, side: f32) -> Rgb<f32> {
    let odd = ((point.x / side).floor() + (point.z / side).floor()) as i64 & 1;
    if odd == 0 { Rgb::grey(0.75) } else { Rgb::new(0.45, 0.12, 0.1) }
}
