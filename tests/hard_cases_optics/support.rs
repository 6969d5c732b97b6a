//! What the cases share: random numbers, vectors in `f64`, scenes and shots into them.

use whit::{Background, Budget, Camera, Effects, Ray, Rgb, Scene, Stats, Tracer, Vec3};

pub const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);

/// A tracer for any scene whose media stand alone.
pub type Alone<'a> = Tracer<'a, f32, { Effects::ALL.bits() }, 66, 0>;
/// A tracer for any scene whose media overlap.
pub type Nested<'a> = Tracer<'a, f32, { Effects::ALL.bits() }, 66, 4>;

/// A scene that is looked into by single rays.
pub fn scene<'a>(background: Background<f32>) -> Scene<'a, f32> {
    Scene::new(Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, UP, 40.0), background)
}

/// What one ray sees, and what was counted.
pub fn shoot<const MEDIA: usize>(
    tracer: &Tracer<'_, f32, { Effects::ALL.bits() }, 66, MEDIA>,
    ray: Ray<f32>,
    depth: u8,
) -> (Rgb<f32>, Stats) {
    let mut stats = Stats::default();
    let light = tracer.trace(ray, &Budget::with_depth(depth), &mut stats);
    (light, stats)
}

/// `fastrand`'s numbers, in the ways that hard cases ask for.
#[derive(Clone)]
pub struct Random(fastrand::Rng);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(fastrand::Rng::with_seed(seed))
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0.f64()
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A unit vector, evenly over the sphere.
    pub fn direction(&mut self) -> [f64; 3] {
        let (z, angle) = (self.between(-1.0, 1.0), self.between(0.0, std::f64::consts::TAU));
        let r = (1.0 - z * z).sqrt();
        [r * angle.cos(), r * angle.sin(), z]
    }
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a + s·b
pub fn plus(a: [f64; 3], s: f64, b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + s * b[i])
}

pub fn unit(a: [f64; 3]) -> [f64; 3] {
    a.map(|x| x / dot(a, a).sqrt())
}

/// The nearest `f32`.
pub fn single([x, y, z]: [f64; 3]) -> Vec3<f32> {
    Vec3::new(x as f32, y as f32, z as f32)
}

pub fn double(v: Vec3<f32>) -> [f64; 3] {
    [v.x, v.y, v.z].map(f64::from)
}

/// The value so many steps of the number type further up, for values above 0.
pub fn ulps_up(x: f32, ulps: i32) -> f32 {
    f32::from_bits(x.to_bits().wrapping_add_signed(ulps))
}
