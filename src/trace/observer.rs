//! Seeing what a render does, at no cost to those who do not look.

use crate::math::Rgb;

/// The reason a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the camera.
    Eye,
    /// A reflected branch.
    Reflected,
    /// A transmitted branch.
    Transmitted,
    /// A branch that goes straight on through a surface, inside a medium of higher priority.
    Passed,
    /// From a surface to a light.
    Shadow,
}

/// The limit that cut a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// [`Budget::depth`](crate::Budget::depth)
    Depth,
    /// [`Budget::cutoff`](crate::Budget::cutoff)
    Cutoff,
    /// [`Budget::rays_per_pixel`](crate::Budget::rays_per_pixel)
    Rays,
    /// [`MOST_PASSED`](super::MOST_PASSED) surfaces in a row that it went straight through.
    Passed,
    /// [`Budget::steps_per_ray`](crate::Budget::steps_per_ray)
    Steps,
}

/// Is told of events while a frame is traced. Every method does nothing unless it is written; `()` sees nothing, and
/// the calls are not in the binary.
pub trait Observer {
    /// A ray is sent.
    #[inline]
    fn ray(&mut self, kind: RayKind) {
        let _ = kind;
    }

    /// A bent ray took so many steps to the next surface.
    #[inline]
    fn steps(&mut self, count: u32) {
        let _ = count;
    }

    /// A branch fell into a black hole.
    #[inline]
    fn captured(&mut self) {}

    /// A branch was reflected totally.
    #[inline]
    fn total_internal_reflection(&mut self) {}

    /// A branch of light is inside of more media than it can remember; the one of the lowest priority is forgotten.
    #[inline]
    fn media_overflow(&mut self) {}

    /// A branch was cut, and with it `throughput` of the light of the current sample.
    #[inline]
    fn cut(&mut self, reason: Cut, throughput: Rgb<f32>) {
        let _ = (reason, throughput);
    }

    /// The pixel in column `x` of row `y` is complete, the mean of so many samples.
    #[inline]
    fn pixel(&mut self, x: u32, y: u32, samples: u32) {
        let _ = (x, y, samples);
    }
}

impl Observer for () {}

impl<O: Observer> Observer for &mut O {
    #[inline]
    fn ray(&mut self, kind: RayKind) {
        (**self).ray(kind);
    }
    #[inline]
    fn steps(&mut self, count: u32) {
        (**self).steps(count);
    }
    #[inline]
    fn captured(&mut self) {
        (**self).captured();
    }
    #[inline]
    fn total_internal_reflection(&mut self) {
        (**self).total_internal_reflection();
    }
    #[inline]
    fn media_overflow(&mut self) {
        (**self).media_overflow();
    }
    #[inline]
    fn cut(&mut self, reason: Cut, throughput: Rgb<f32>) {
        (**self).cut(reason, throughput);
    }
    #[inline]
    fn pixel(&mut self, x: u32, y: u32, samples: u32) {
        (**self).pixel(x, y, samples);
    }
}

impl<A: Observer, B: Observer> Observer for (A, B) {
    #[inline]
    fn ray(&mut self, kind: RayKind) {
        self.0.ray(kind);
        self.1.ray(kind);
    }
    #[inline]
    fn steps(&mut self, count: u32) {
        self.0.steps(count);
        self.1.steps(count);
    }
    #[inline]
    fn captured(&mut self) {
        self.0.captured();
        self.1.captured();
    }
    #[inline]
    fn total_internal_reflection(&mut self) {
        self.0.total_internal_reflection();
        self.1.total_internal_reflection();
    }
    #[inline]
    fn media_overflow(&mut self) {
        self.0.media_overflow();
        self.1.media_overflow();
    }
    #[inline]
    fn cut(&mut self, reason: Cut, throughput: Rgb<f32>) {
        self.0.cut(reason, throughput);
        self.1.cut(reason, throughput);
    }
    #[inline]
    fn pixel(&mut self, x: u32, y: u32, samples: u32) {
        self.0.pixel(x, y, samples);
        self.1.pixel(x, y, samples);
    }
}

/// Counts of rays and cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Rays from the camera.
    pub eye: u64,
    /// Reflected branches.
    pub reflected: u64,
    /// Transmitted branches.
    pub transmitted: u64,
    /// Branches that went straight through a surface.
    pub passed: u64,
    /// Rays to lights.
    pub shadow: u64,
    /// Total internal reflections.
    pub total_internal: u64,
    /// Times that a branch was inside of more media than it could remember.
    pub media_overflows: u64,
    /// Branches cut by the depth.
    pub cut_by_depth: u64,
    /// Branches cut by the cutoff.
    pub cut_by_cutoff: u64,
    /// Branches cut by the rays per pixel.
    pub cut_by_budget: u64,
    /// Branches and shadow rays cut after too many surfaces that they went straight through.
    pub cut_by_passing: u64,
    /// Steps of bent rays.
    pub steps: u64,
    /// Branches that fell into a black hole.
    pub captured: u64,
    /// Branches cut by the steps per ray.
    pub cut_by_steps: u64,
}

impl Stats {
    /// All rays.
    #[must_use]
    pub const fn rays(&self) -> u64 {
        self.eye + self.reflected + self.transmitted + self.passed + self.shadow
    }

    /// The counts of two parts of a picture, together.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self {
            eye: self.eye + other.eye,
            reflected: self.reflected + other.reflected,
            transmitted: self.transmitted + other.transmitted,
            passed: self.passed + other.passed,
            shadow: self.shadow + other.shadow,
            total_internal: self.total_internal + other.total_internal,
            media_overflows: self.media_overflows + other.media_overflows,
            cut_by_depth: self.cut_by_depth + other.cut_by_depth,
            cut_by_cutoff: self.cut_by_cutoff + other.cut_by_cutoff,
            cut_by_budget: self.cut_by_budget + other.cut_by_budget,
            cut_by_passing: self.cut_by_passing + other.cut_by_passing,
            steps: self.steps + other.steps,
            captured: self.captured + other.captured,
            cut_by_steps: self.cut_by_steps + other.cut_by_steps,
        }
    }
}

impl Observer for Stats {
    #[inline]
    fn ray(&mut self, kind: RayKind) {
        // Five additions cost less than a jump that cannot be foreseen.
        self.eye += u64::from(kind == RayKind::Eye);
        self.reflected += u64::from(kind == RayKind::Reflected);
        self.transmitted += u64::from(kind == RayKind::Transmitted);
        self.passed += u64::from(kind == RayKind::Passed);
        self.shadow += u64::from(kind == RayKind::Shadow);
    }

    #[inline]
    fn steps(&mut self, count: u32) {
        self.steps += u64::from(count);
    }

    #[inline]
    fn captured(&mut self) {
        self.captured += 1;
    }

    #[inline]
    fn total_internal_reflection(&mut self) {
        self.total_internal += 1;
    }

    #[inline]
    fn media_overflow(&mut self) {
        self.media_overflows += 1;
    }

    #[inline]
    fn cut(&mut self, reason: Cut, _throughput: Rgb<f32>) {
        match reason {
            Cut::Depth => self.cut_by_depth += 1,
            Cut::Cutoff => self.cut_by_cutoff += 1,
            Cut::Rays => self.cut_by_budget += 1,
            Cut::Passed => self.cut_by_passing += 1,
            Cut::Steps => self.cut_by_steps += 1,
        }
    }
}

/// Per pixel, the throughput that was cut: the weight of what the budget did not look at.
///
/// `write` receives column, row and the mean over the pixel's samples.
#[derive(Clone, Copy, Debug)]
pub struct Dropped<F> {
    sum: Rgb<f32>,
    write: F,
}

impl<F: FnMut(u32, u32, Rgb<f32>)> Dropped<F> {
    /// An observer that hands each pixel's lost throughput to `write`.
    pub const fn new(write: F) -> Self {
        Self { sum: Rgb::BLACK, write }
    }
}

impl<F: FnMut(u32, u32, Rgb<f32>)> Observer for Dropped<F> {
    #[inline]
    fn cut(&mut self, _reason: Cut, throughput: Rgb<f32>) {
        self.sum += throughput;
    }

    #[inline]
    fn pixel(&mut self, x: u32, y: u32, samples: u32) {
        let mean = self.sum * (1.0 / samples.max(1) as f32);
        self.sum = Rgb::BLACK;
        (self.write)(x, y, mean);
    }
}
