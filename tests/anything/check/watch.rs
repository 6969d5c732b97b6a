//! An observer that counts by itself.

use whit::trace::{Cut, RayKind};
use whit::{Observer, Rgb};

/// Counts of rays and pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Watch {
    pub rays: u64,
    /// Of the pixel at hand.
    pub rays_here: u64,
    /// Of the pixel that took most.
    pub most_rays: u64,
    pub most_samples: u32,
    pub pixels: usize,
    /// Of the bent ray that took most.
    pub most_steps: u32,
    pub steps: u64,
    /// Whether every weight that was cut is a number that a weight can be.
    pub is_odd: bool,
}

impl Observer for Watch {
    fn ray(&mut self, _kind: RayKind) {
        self.rays += 1;
        self.rays_here += 1;
        self.most_rays = self.most_rays.max(self.rays_here);
    }

    fn steps(&mut self, count: u32) {
        self.most_steps = self.most_steps.max(count);
        self.steps += u64::from(count);
    }

    fn cut(&mut self, reason: Cut, throughput: Rgb<f32>) {
        // Each of 9 bounces may double a weight, which 1024 is far above; what a body shows may be brightened.
        let most = if reason == Cut::Steps { 1024.0 * 1e12 } else { 1024.0 };
        let is_weight = |x: f32| (0.0..=most).contains(&x);
        self.is_odd |= !(is_weight(throughput.r) && is_weight(throughput.g) && is_weight(throughput.b));
    }

    fn pixel(&mut self, _x: u32, _y: u32, samples: u32) {
        self.rays_here = 0;
        self.most_samples = self.most_samples.max(samples);
        self.pixels += 1;
    }
}
