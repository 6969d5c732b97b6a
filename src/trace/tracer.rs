//! A scene together with the code that it calls for.

use core::fmt;

use super::budget::USUAL_STEPS;
use super::media::Media;
use super::{Budget, Context, Observer, RayTree, Samples, Sequence};
use crate::intersect::{Destination, Hit, Intersection, Ray};
use crate::math::{Real, Rgb};
use crate::path::{self, Arrival, Path, StepsLeft, next_surface};
use crate::scene::{Effects, Object, Scene, SceneError};

/// A scene, to be traced by code for the effects `EFFECTS` ([`Effects::bits`]), with a stack for `DEPTH` branches
/// ([`Scene::stack`]: as many as bounces, two more in a scene with dispersion) that each remember `MEDIA` media
/// ([`Scene::media`]: 0 where transparent objects are clear and stand alone).
///
/// Code for other effects is not compiled, so a scene that needs more is refused: by the compiler for a constant scene
/// ([`tracer!`](crate::tracer!), [`Tracer::new`]), by an error for one that is known only at run time
/// ([`Tracer::try_new`]).
///
/// A tracer of its scene's own effects compiles:
///
/// ```
/// use whit::{Tracer, scenes::SHOWCASE};
/// static TRACER: Tracer<f32, { SHOWCASE.effects().bits() }, 5> = Tracer::new(&SHOWCASE);
/// ```
///
/// One effect fewer does not:
///
/// ```compile_fail,E0080
/// use whit::{Effects, Tracer, scenes::SHOWCASE};
/// static TRACER: Tracer<f32, { SHOWCASE.effects().without(Effects::CONE).bits() }, 5> = Tracer::new(&SHOWCASE);
/// ```
///
/// Nor does a number that no scene may hold:
///
/// ```compile_fail,E0080
/// use whit::{Background, Camera, Rgb, Scene, Tracer, Vec3};
/// const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
/// const CAMERA: Camera<f32> = Camera::look_at(UP, UP, UP, 40.0);
/// static SCENE: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(Rgb::grey(0.5)));
/// static TRACER: Tracer<f32, 0, 5> = Tracer::new(&SCENE);
/// ```
///
/// ```compile_fail,E0080
/// use whit::{Material, Object, Scene, Shape, Vec3, scenes::SPHERES};
/// const NOTHING: [Object<'static, f32>; 1] = [Object::new(Shape::sphere(Vec3::ZERO, 1.0), Material::dielectric(0.0))];
/// const SCENE: Scene<'static, f32> = SPHERES.with_objects(&NOTHING);
/// let tracer = whit::tracer!(SCENE);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, T, const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize = 0> {
    scene: &'a Scene<'a, T>,
}

/// The tracer of a constant `f32` scene, compiled for just the effects of that scene and checked by the compiler.
///
/// `tracer!(SCENE)` goes to at most 8 bounces, `tracer!(SCENE, 12)` to at most 12.
///
/// ```
/// let tracer = whit::tracer!(whit::scenes::SHOWCASE, 12);
/// ```
#[macro_export]
macro_rules! tracer {
    ($scene:path) => {
        $crate::tracer!($scene, 8)
    };
    ($scene:path, $depth:expr) => {
        const {
            $crate::Tracer::<f32, { $scene.effects().bits() }, { $scene.stack($depth) }, { $scene.media() }>::new(
                &$scene,
            )
        }
    };
}

/// Why a scene cannot be traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TracerError {
    /// The scene calls for these effects, which the tracer was compiled without.
    MissingEffects(Effects),
    /// The scene has media that have to be remembered ([`Scene::media`]), and `MEDIA` is 0.
    NoMedia,
    /// The scene has a number out of its range.
    Scene(SceneError),
}

impl fmt::Display for TracerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingEffects(effects) => write!(f, "the tracer was compiled without: {effects}"),
            Self::NoMedia => f.write_str("the scene has media that attenuate or overlap: expected MEDIA above 0"),
            Self::Scene(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for TracerError {}

impl<'a, const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize> Tracer<'a, f32, EFFECTS, DEPTH, MEDIA> {
    /// The tracer of a constant scene, for use in constant evaluation.
    ///
    /// # Panics
    /// When the scene calls for more than `EFFECTS` or has a number out of its range: in a constant or a static, that
    /// is an error of compilation. Use [`Tracer::try_new`] at run time.
    #[must_use]
    #[allow(clippy::panic)] // The only way to stop a constant's evaluation.
    pub const fn new(scene: &'a Scene<'a, f32>) -> Self {
        assert!(Self::missing(scene).is_empty(), "the scene calls for effects that are not in EFFECTS");
        assert!(Self::remembers(scene), "the scene has media that attenuate or overlap: MEDIA must be above 0");
        if let Err(error) = scene.check() {
            panic!("{}", error.expected);
        }
        Self { scene }
    }
}

impl<'a, T: Real, const EFFECTS: u64, const DEPTH: usize, const MEDIA: usize> Tracer<'a, T, EFFECTS, DEPTH, MEDIA> {
    /// The tracer of a scene that is known only at run time.
    ///
    /// # Errors
    /// Names the effects that the scene calls for and `EFFECTS` lacks, or the field of the scene that is out of range;
    /// [`TracerError::NoMedia`] where `MEDIA` must be above 0.
    pub fn try_new(scene: &'a Scene<'a, T>) -> Result<Self, TracerError> {
        let missing = Self::missing(scene);
        if !missing.is_empty() {
            return Err(TracerError::MissingEffects(missing));
        }
        if !Self::remembers(scene) {
            return Err(TracerError::NoMedia);
        }
        scene.validate().map_err(TracerError::Scene)?;
        Ok(Self { scene })
    }

    const fn missing(scene: &Scene<'_, T>) -> Effects {
        scene.effects().without(Effects::from_bits(EFFECTS))
    }

    const fn remembers(scene: &Scene<'_, T>) -> bool {
        MEDIA > 0 || scene.media() == 0
    }

    /// The largest number of bounces that the stack has room for.
    #[must_use]
    pub const fn depth(&self) -> usize {
        let disperses = Effects::from_bits(EFFECTS).has(Effects::DISPERSION);
        if disperses { DEPTH.saturating_sub(self.scene.stack(0)) } else { DEPTH }
    }

    /// The scene.
    #[must_use]
    pub const fn scene(&self) -> &'a Scene<'a, T> {
        self.scene
    }

    /// The first surface that a ray meets; `None` where it meets nothing up to a distance of 2⁶⁰. The ray's direction must
    /// have length 1 and its origin coordinates of at most 1e12.
    ///
    /// A flat surface that the origin lies on is not met; a closed body is met from inside if the ray goes in. Where light is
    /// bent, its path is followed for at most 10,000 steps: [`destination`](Self::destination) says how it ended.
    ///
    /// ```
    /// use whit::{Ray, Vec3, scenes::SPHERES};
    /// let camera = SPHERES.camera;
    /// let ray = Ray { origin: camera.eye, direction: (camera.target - camera.eye).normalized() };
    /// let under_the_middle = whit::tracer!(SPHERES).intersect(&ray).unwrap();
    /// println!("object {}, {} away", under_the_middle.object, under_the_middle.distance);
    /// ```
    #[must_use]
    pub fn intersect(&self, ray: &Ray<T>) -> Option<Intersection<T>> {
        if path::is_bent::<EFFECTS>() {
            return match self.destination(ray, USUAL_STEPS) {
                Destination::Surface(there) => Some(there),
                Destination::Away(_) | Destination::Captured | Destination::OutOfSteps => None,
            };
        }
        let hit = next_surface::<T, EFFECTS>(self.scene, ray)?;
        Some(Intersection::new::<EFFECTS>(&hit, self.number_of(&hit)?, ray, &self.scene.offset))
    }

    /// Whether something that casts a full shadow, or the horizon of a black hole, is between a ray's origin and the place at this
    /// distance along it. The ray is as for [`intersect`](Self::intersect) and goes straight; what lies within 2⁻¹³ of the
    /// distance from its end is not in its way, nor is what lets light through with a tint.
    ///
    /// This takes less time than to look for the first surface.
    ///
    /// ```
    /// use whit::{Ray, scenes::SPHERES};
    /// let camera = SPHERES.camera;
    /// let ray = Ray { origin: camera.eye, direction: (camera.target - camera.eye).normalized() };
    /// assert!(whit::tracer!(SPHERES).is_occluded(&ray, 1000.0));
    /// ```
    #[must_use]
    pub fn is_occluded(&self, ray: &Ray<T>, distance: T) -> bool {
        !path::is_lit_straight::<T, EFFECTS>(self.scene, ray, distance)
    }

    /// Where light goes that starts as a ray, in at most so many steps if it is bent. The ray is as for
    /// [`intersect`](Self::intersect); it starts in the medium that its origin lies in.
    ///
    /// ```
    /// use whit::scene::{BlackHole, Steps};
    /// use whit::{Background, Camera, Destination, Ray, Rgb, Scene, Vec3};
    /// const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
    /// const EYE: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.0, 50.0), Vec3::ZERO, UP, 40.0);
    /// const HOLE: BlackHole<f32> =
    ///     BlackHole { center: Vec3::ZERO, mass: 1.0, steps: Steps::Controlled { tolerance: 1e-5 } };
    /// const SCENE: Scene<'static, f32> = Scene::new(EYE, Background::Solid(Rgb::BLACK)).with_black_hole(HOLE);
    /// // Light that would go past the hole at 10 times its mass is turned by 0.5904 (34°).
    /// let ray = Ray { origin: Vec3::new(-1e6, 10.0, 0.0), direction: Vec3::new(1.0, 0.0, 0.0) };
    /// let Destination::Away(direction) = whit::tracer!(SCENE).destination(&ray, 1000) else { panic!() };
    /// assert!((f32::atan2(-direction.y, direction.x) - 0.5904).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn destination(&self, ray: &Ray<T>, steps: u16) -> Destination<T> {
        let (media, _) = Media::<MEDIA>::around::<T, EFFECTS>(self.scene, ray);
        let index = media.medium(self.scene).index;
        match Path::new(self.scene, index).follow::<EFFECTS>(ray, &mut StepsLeft::new(steps)) {
            Arrival::Surface(landing) => {
                let object = self.number_of(&landing.hit).unwrap_or(self.scene.objects.len());
                let there = Intersection::new::<EFFECTS>(&landing.hit, object, &landing.chord, &self.scene.offset);
                let (direction, distance) = (landing.direction, landing.distance);
                Destination::Surface(Intersection { direction, distance, ..there })
            }
            Arrival::Away(direction) | Arrival::Limit(Ray { direction, .. }) => Destination::Away(direction),
            Arrival::Captured => Destination::Captured,
            Arrival::OutOfSteps(_) => Destination::OutOfSteps,
        }
    }

    /// The place of the object that is hit in the scene's list.
    fn number_of(&self, hit: &Hit<'_, T>) -> Option<usize> {
        let place = |object| core::ptr::from_ref::<Object<'_, T>>(object).addr();
        let bytes = place(hit.object).checked_sub(place(self.scene.objects.first()?))?;
        Some(bytes / size_of::<Object<'_, T>>())
    }

    /// The light that comes back along one ray, whose direction must have length 1 and whose origin coordinates of at
    /// most 1e12. Lights with an area are sampled at their first sample point. Where lights are too bright for the number
    /// type this is infinite; the pixels of a frame are held at the largest number.
    #[must_use]
    pub fn trace(&self, ray: Ray<T>, budget: &Budget<T>, observer: &mut impl Observer) -> Rgb<T> {
        let samples = Samples { sequence: Sequence::new(0, 0), index: 0 };
        let context = Context { scene: self.scene, budget, samples };
        let mut tree = RayTree::<T, DEPTH, MEDIA>::new();
        tree.start::<EFFECTS, _>(ray, budget.rays_per_pixel, self.scene, observer);
        loop {
            let mut rays = u32::MAX;
            if let Some(light) = tree.advance::<EFFECTS, _>(&context, &mut rays, observer) {
                return light;
            }
        }
    }
}
