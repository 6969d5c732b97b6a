//! Single rays.

use whit::{Budget, Destination, Intersection, Ray, Real, Rgb, Scene, Settings, Stats, Tone, Vec3};

use super::bound::limits;
use super::{Everything, Fault, LARGE, Order, require};

/// So many rays at most come of one.
const MOST: u32 = 300;

impl<T: Real> Order<'_, T> {
    pub(super) fn check_rays<const MEDIA: usize>(&self, tracer: &Everything<'_, T, LARGE, MEDIA>) -> Result<(), Fault> {
        for ray in self.eye_rays().iter().chain(&self.rays) {
            if let Some(intersection) = tracer.intersect(ray) {
                require(is_fine(&intersection), || format!("{intersection:?} of {ray:?}"))?;
            }
            self.check_destination(tracer, ray)?;
            let rays_per_pixel = self.settings.budget.rays_per_pixel.min(MOST);
            let budget = Budget { rays_per_pixel, ..self.settings.budget };
            let mut stats = Stats::default();
            let light = tracer.trace(*ray, &budget, &mut stats);
            require(stats.rays() <= u64::from(rays_per_pixel), || format!("{stats:?} of {ray:?}"))?;
            self.check_light(light).map_err(|fault| format!("{fault} of {ray:?}"))?;
        }
        Ok(())
    }

    /// Where a ray goes, if it is known, is a direction; and with no steps it is not known where light goes that is bent.
    fn check_destination<const MEDIA: usize>(
        &self,
        tracer: &Everything<'_, T, LARGE, MEDIA>,
        ray: &Ray<T>,
    ) -> Result<(), Fault> {
        match tracer.destination(ray, self.settings.budget.steps_per_ray) {
            Destination::Away(direction) => {
                require(is_unit(direction) || !finite(ray.origin), || format!("away in {direction:?} of {ray:?}"))
            }
            Destination::Surface(there) => require(is_fine(&there), || format!("{there:?} of {ray:?}")),
            Destination::Captured => require(self.scene.black_hole.is_some(), || "there is no hole".into()),
            Destination::OutOfSteps => require(self.bends(), || format!("steps of {ray:?}")),
        }
    }

    /// Rays from the eye through some points of the picture. What they bring shows what a pixel would not, in which
    /// what is not a number is black.
    pub(super) fn eye_rays(&self) -> Vec<Ray<T>> {
        let camera = self.scene.camera;
        let forward = (camera.target - camera.eye).normalized();
        let right = forward.cross(camera.up).normalized();
        let up = right.cross(forward);
        let steps = [-1.0, -0.375, 0.0, 0.5].map(|step| camera.half_height * T::from_f32(step));
        let through = |x: T, y: T| (forward + right * x + up * y).normalized();
        let ray = |x: T, y: T| Ray { origin: camera.eye, direction: through(x, y) };
        steps.into_iter().flat_map(|x| steps.into_iter().map(move |y| ray(x, y))).collect()
    }

    /// A number, and no more than there can be; where the scene is too bright for the number type, infinity too.
    fn check_light(&self, light: Rgb<T>) -> Result<(), Fault> {
        let settings = Settings { budget: self.settings.budget, ..Settings::new(1, 1) };
        let linear = Scene { tone: Tone::Linear, ..*self.scene };
        let (highest, _) = limits(&linear, &settings, u64::from(MOST));
        let is_bright = highest > f64::from(T::MAX.to_f32().min(f32::MAX)) * 1e-3;
        let most = if is_bright { T::MAX * T::TWO } else { T::from_f32((highest as f32).max(f32::MIN_POSITIVE)) };
        let fine = |x: T| x >= T::ZERO && x <= most;
        require(fine(light.r) && fine(light.g) && fine(light.b), || format!("{light:?}, more than {highest:e}"))
    }
}

fn finite<T: Real>(v: Vec3<T>) -> bool {
    [v.x, v.y, v.z].into_iter().all(|x| x.abs() <= T::MAX)
}

fn is_unit<T: Real>(v: Vec3<T>) -> bool {
    (v.length() - T::ONE).abs() < T::from_f32(1e-5)
}

fn is_fine<T: Real>(intersection: &Intersection<T>) -> bool {
    let length = intersection.normal.length();
    // A triangle without an area has no normal.
    let has_normal = length == T::ZERO || is_unit(intersection.normal);
    let left = intersection.leave(-intersection.direction);
    // That of a bent path is a share of a piece of it, which may underflow.
    intersection.distance >= T::ZERO
        && intersection.distance < T::MAX
        && has_normal
        && is_unit(intersection.direction)
        && finite(intersection.point)
        && finite(intersection.offset)
        && finite(left.origin)
}
