//! What the page does: it opens scenes, and renders them as it is asked to.

use whit::render::{Encoding, Frame, Order, Sampling, Settings, Size};
use whit::scene::Lens;
use whit::trace::{Budget, Observer, RayKind, Termination};
use whit::{Camera, Effects, Fresnel, Real, Rgb, Scene, Tracer, Vec3, scenes};

use crate::memory;
use crate::picture::CAPACITY;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::{Number, converted, decode};

/// All but those that no scene in the number type can have, so that they take no room in the module.
const EFFECTS: u64 = if Number::IS_FIXED { LISTED.without(BENT_LIGHT).bits() } else { LISTED.bits() };
/// The page searches lists of objects: it has no memory for a hierarchy.
const LISTED: Effects = Effects::ALL.without(Effects::HIERARCHY);
const BENT_LIGHT: Effects = Effects::HEIGHT_PROFILE
    .with(Effects::RADIUS_PROFILE)
    .with(Effects::POLYNOMIAL_LAW)
    .with(Effects::EXPONENTIAL_LAW)
    .with(Effects::FISH_EYE_LAW)
    .with(Effects::TABLE_LAW)
    .with(Effects::LAYERS)
    .with(Effects::FIXED_STEPS)
    .with(Effects::CONTROLLED_STEPS)
    .with(Effects::BLACK_HOLE)
    .with(Effects::BENT_SHADOWS);
/// The most bounces are 32; a scene with dispersion needs two entries more.
const STACK: usize = 34;
const MEDIA: usize = 8;

/// The camera as the page moves it: eye, target, up, and the distance in focus where there is a lens.
type Pose = [f32; 10];

pub struct Page {
    /// As it was opened, with its own camera.
    scene: Option<Scene<'static, Number>>,
    frame: Option<Frame<'static, Number, EFFECTS, STACK, Rays, MEDIA>>,
    /// Where the frame's scene is kept.
    in_second: bool,
    pub pose: Pose,
}

/// What is asked of a picture.
pub struct Wishes {
    pub size: Size,
    /// A pixel's, or those along a side of a grid.
    pub samples: u32,
    pub is_grid: bool,
    pub depth: u32,
    pub cutoff: f32,
    /// 0 for the background, 1 for black, else magenta.
    pub termination: u32,
    pub fresnel: Fresnel,
}

/// Counts the rays.
#[derive(Clone)]
struct Rays(u32);

impl Observer for Rays {
    fn ray(&mut self, _kind: RayKind) {
        self.0 = self.0.wrapping_add(1);
    }
}

impl Page {
    pub const EMPTY: Self = Self { scene: None, frame: None, in_second: false, pose: [0.0; 10] };

    /// Gives up the scene, so that its memory is free.
    fn close(&mut self) {
        (self.scene, self.frame) = (None, None);
    }

    pub fn open_scene(&mut self, index: usize) {
        let Some((_, scene)) = const { &scenes::ALL }.get(index) else { return };
        self.close();
        if let Some(scene) = converted(scene) {
            self.open(scene);
        }
    }

    /// Opens what the first records describe.
    pub fn open_file(&mut self, bytes: usize) {
        let count = bytes / size_of::<Record>();
        self.close();
        let scene = memory::records().get(..count).and_then(decode::scene);
        if let Some(scene) = scene {
            self.open(scene);
        }
    }

    fn open(&mut self, scene: Scene<'static, Number>) {
        let Camera { eye, target, up, lens, .. } = scene.camera;
        let focus = lens.map_or(Number::ZERO, |lens| lens.focus);
        let pose = [eye.x, eye.y, eye.z, target.x, target.y, target.z, up.x, up.y, up.z, focus];
        self.pose = pose.map(Number::to_f32);
        self.scene = Some(scene);
    }

    /// Begins a picture. After a refusal all is as before.
    pub fn start(&mut self, wishes: &Wishes) -> Result<(), Refusal> {
        let scene = self.scene.ok_or(Refusal::NoScene)?;
        if wishes.size.pixels() > CAPACITY as u64 {
            return Err(Refusal::TooManyPixels);
        }
        let camera = posed(&scene.camera, &self.pose);
        let scene = memory::keep(Scene { camera, fresnel: wishes.fresnel, ..scene }, !self.in_second);
        if Number::IS_FIXED {
            // Names what bends light in the scene, where the tracer would name the effects that it lacks.
            scene.validate().map_err(Refusal::Scene)?;
        }
        let tracer = Tracer::try_new(scene).map_err(Refusal::Tracer)?;
        let frame = Frame::observed(&tracer, wishes.settings(), Rays(0)).map_err(Refusal::Settings)?;
        self.frame = Some(frame);
        self.in_second = !self.in_second;
        memory::picture().begin(wishes.size, Encoding::of(scene));
        Ok(())
    }

    /// Traces about so many rays more and tells how many pixels are left.
    pub fn step(&mut self, rays: u32) -> u32 {
        let picture = memory::picture();
        if let Some(frame) = &mut self.frame {
            let Ok(_) = frame.step(rays, picture) else { return 0 };
        }
        picture.left
    }

    /// The rays of the picture so far.
    pub fn rays(&self) -> u32 {
        self.frame.as_ref().map_or(0, |frame| frame.observer().0)
    }
}

impl Wishes {
    fn settings(&self) -> Settings<Number> {
        let termination = match self.termination {
            0 => Termination::Background,
            1 => Termination::Black,
            _ => Termination::Color(Rgb::new(Number::ONE, Number::ZERO, Number::ONE)),
        };
        let sampling = match self.samples {
            1 => Sampling::Grid(1),
            side if self.is_grid => Sampling::Grid(side.min(255) as u8),
            count => Sampling::Sequence(count),
        };
        Settings {
            order: Order::CoarseToFine,
            sampling,
            budget: Budget {
                cutoff: Number::from_f32(self.cutoff),
                termination,
                ..Budget::with_depth(self.depth.min(255) as u8)
            },
            ..Settings::new(self.size.width, self.size.height)
        }
    }
}

fn posed(camera: &Camera<Number>, pose: &Pose) -> Camera<Number> {
    let [x, y, z, at_x, at_y, at_z, up_x, up_y, up_z, focus] = pose.map(Number::from_f32);
    Camera {
        eye: Vec3::new(x, y, z),
        target: Vec3::new(at_x, at_y, at_z),
        up: Vec3::new(up_x, up_y, up_z),
        lens: camera.lens.map(|lens| Lens { focus, ..lens }),
        ..*camera
    }
}
