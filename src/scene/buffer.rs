//! A scene that is made at run time, in fixed memory.

use core::fmt;

use heapless::Vec;

use super::{Background, BlackHole, Camera, Fresnel, Light, Medium, Object, Offset, Profile, Scene, ShadowRays, Tone};
use crate::math::{Real, Rgb, Vec3};

/// A scene with room for `OBJECTS` objects, `LIGHTS` lights and `PROFILES` profiles of media.
///
/// ```
/// use whit::{Background, Camera, Light, Material, Object, Rgb, SceneBuf, Shape, Vec3};
/// let camera = Camera::look_at(Vec3::new(0.0, 1.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
/// let mut buffer = SceneBuf::<f32, 8, 2>::new(camera, Background::Solid(Rgb::grey(0.5)));
/// for i in 0..5 {
///     let center = Vec3::new(i as f32 - 2.0, 0.0, 0.0);
///     buffer.add_object(Object::new(Shape::sphere(center, 0.4), Material::mirror(Rgb::grey(0.9))))?;
/// }
/// buffer.add_light(Light::point(Vec3::new(3.0, 5.0, 4.0), Rgb::WHITE))?;
/// assert_eq!(buffer.as_scene().objects.len(), 5);
/// # Ok::<(), whit::scene::Full>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneBuf<T: 'static, const OBJECTS: usize, const LIGHTS: usize, const PROFILES: usize = 0> {
    /// The eye.
    pub camera: Camera<T>,
    /// What rays see that meet nothing.
    pub background: Background<T>,
    /// What fills the space between the objects.
    pub medium: Medium<T>,
    /// How the reflectance of dielectrics and coats is computed.
    pub fresnel: Fresnel,
    /// From light to the values of pixels.
    pub tone: Tone<T>,
    /// A black hole.
    pub black_hole: Option<BlackHole<T>>,
    /// How shadow rays go where light is bent.
    pub shadow_rays: ShadowRays,
    /// How far from a surface the next ray starts.
    pub offset: Offset<T>,
    objects: Vec<Object<'static, T>, OBJECTS>,
    lights: Vec<Light<T>, LIGHTS>,
    profiles: Vec<Profile<'static, T>, PROFILES>,
}

/// There is no room left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full {
    /// What there is no room for.
    pub what: &'static str,
    /// How many there is room for.
    pub capacity: usize,
}

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no room for another {}: the capacity is {}", self.what, self.capacity)
    }
}

impl core::error::Error for Full {}

/// Memory that a reader of scene files can fill: a [`SceneBuf`], or on a host whatever grows.
pub trait SceneStore {
    /// How many objects and lights there is room for in all.
    fn room(&self) -> (usize, usize);

    /// Takes out all objects and lights and starts a scene in a vacuum.
    fn restart(&mut self, camera: Camera<f32>, background: Background<f32>);

    /// Adds an object.
    ///
    /// # Errors
    /// [`Full`]; the store is as before.
    fn add_object(&mut self, object: Object<'static, f32>) -> Result<(), Full>;

    /// Adds a light.
    ///
    /// # Errors
    /// [`Full`]; the store is as before.
    fn add_light(&mut self, light: Light<f32>) -> Result<(), Full>;
}

impl<const OBJECTS: usize, const LIGHTS: usize, const PROFILES: usize> SceneStore
    for SceneBuf<f32, OBJECTS, LIGHTS, PROFILES>
{
    fn room(&self) -> (usize, usize) {
        (OBJECTS, LIGHTS)
    }

    fn restart(&mut self, camera: Camera<f32>, background: Background<f32>) {
        *self = Self::new(camera, background);
    }

    fn add_object(&mut self, object: Object<'static, f32>) -> Result<(), Full> {
        self.add_object(object)
    }

    fn add_light(&mut self, light: Light<f32>) -> Result<(), Full> {
        self.add_light(light)
    }
}

impl<T: Real, const OBJECTS: usize, const LIGHTS: usize, const PROFILES: usize> SceneBuf<T, OBJECTS, LIGHTS, PROFILES> {
    /// Nothing, seen from nowhere: static memory for [`copy_from`](Self::copy_from) to fill.
    pub const EMPTY: Self =
        Self::new(Camera::with_half_height(Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, T::ZERO), Background::Solid(Rgb::BLACK));

    /// An empty scene in a vacuum.
    pub const fn new(camera: Camera<T>, background: Background<T>) -> Self {
        Self {
            camera,
            background,
            medium: Medium::VACUUM,
            fresnel: Fresnel::Exact,
            tone: Tone::Linear,
            black_hole: None,
            shadow_rays: ShadowRays::Straight,
            offset: Offset::Bounded,
            objects: Vec::new(),
            lights: Vec::new(),
            profiles: Vec::new(),
        }
    }

    /// A copy of a scene in another number type, each primitive of a slice an object of its own.
    ///
    /// # Errors
    /// [`Full`] when the scene has more primitives, lights or profiles than there is room for, or a profile that is a table.
    pub fn from_scene<U: Real>(scene: &Scene<'_, U>, convert: impl Fn(U) -> T) -> Result<Self, Full> {
        let mut buffer = Self::new(scene.camera.map(&convert), scene.background.map(&convert));
        buffer.copy_from(scene, convert)?;
        Ok(buffer)
    }

    /// Takes everything out and copies a scene in another number type, each primitive of a slice an object of its own. Where
    /// there is little stack, this fills a variable in place.
    ///
    /// # Errors
    /// [`Full`] as for [`from_scene`](Self::from_scene); the buffer holds a part of the scene then.
    pub fn copy_from<U: Real>(&mut self, scene: &Scene<'_, U>, convert: impl Fn(U) -> T) -> Result<(), Full> {
        self.clear();
        self.camera = scene.camera.map(&convert);
        self.background = scene.background.map(&convert);
        self.medium = scene.medium.map(&convert);
        self.fresnel = scene.fresnel;
        self.tone = scene.tone.map(&convert);
        self.black_hole = scene.black_hole.map(|hole| hole.map(&convert));
        self.shadow_rays = scene.shadow_rays;
        self.offset = scene.offset.map(&convert);
        for profile in scene.profiles {
            let table = Full { what: "table in another number type", capacity: 0 };
            self.add_profile(profile.map(&convert).ok_or(table)?)?;
        }
        for object in scene.objects {
            let mut index = 0;
            while let Some(part) = object.part(index, &convert) {
                self.add_object(part)?;
                index += 1;
            }
        }
        for light in scene.lights {
            self.add_light(light.map(&convert))?;
        }
        Ok(())
    }

    /// Adds an object.
    ///
    /// # Errors
    /// [`Full`]; the buffer is as before.
    pub fn add_object(&mut self, object: Object<'static, T>) -> Result<(), Full> {
        self.objects.push(object).map_err(|_| Full { what: "object", capacity: OBJECTS })
    }

    /// Adds a light.
    ///
    /// # Errors
    /// [`Full`]; the buffer is as before.
    pub fn add_light(&mut self, light: Light<T>) -> Result<(), Full> {
        self.lights.push(light).map_err(|_| Full { what: "light", capacity: LIGHTS })
    }

    /// Adds a profile, whose number is how many there were before.
    ///
    /// # Errors
    /// [`Full`]; the buffer is as before.
    pub fn add_profile(&mut self, profile: Profile<'static, T>) -> Result<(), Full> {
        self.profiles.push(profile).map_err(|_| Full { what: "profile", capacity: PROFILES })
    }

    /// Takes all objects, lights and profiles out.
    pub fn clear(&mut self) {
        self.profiles.clear();
        self.objects.clear();
        self.lights.clear();
    }

    /// The objects.
    #[must_use]
    pub fn objects_mut(&mut self) -> &mut [Object<'static, T>] {
        &mut self.objects
    }

    /// The lights.
    #[must_use]
    pub fn lights_mut(&mut self) -> &mut [Light<T>] {
        &mut self.lights
    }

    /// The scene, ready to be traced.
    #[must_use]
    pub fn as_scene(&self) -> Scene<'_, T> {
        Scene {
            camera: self.camera,
            background: self.background,
            medium: self.medium,
            fresnel: self.fresnel,
            objects: &self.objects,
            lights: &self.lights,
            tone: self.tone,
            profiles: &self.profiles,
            black_hole: self.black_hole,
            shadow_rays: self.shadow_rays,
            offset: self.offset,
            hierarchy: None,
        }
    }
}
