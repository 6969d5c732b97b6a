//! Where scenes come from: the built-in ones, each traced by code for its own effects, and files.

use std::path::Path;

use whit::render::{Encoding, Size};
use whit::scene::{Full, Hierarchy, Leaf, Node, SceneStore, nff};
use whit::{Background, Camera, Effects, Light, Object, Scene, Tracer, scenes};

use crate::work::{Job, Picture, trace};

/// The deepest tree the tool has room for.
pub const DEPTH: usize = 128;

pub enum Source {
    BuiltIn { name: &'static str, scene: Scene<'static, f32> },
    File { name: String, identity: String, size: Size, scene: FileScene },
}

/// Traces a built-in scene by code for just its own effects.
macro_rules! trace_built_in {
    ($name:expr, $job:expr; $($scene:ident)*) => {{
        $(if $name.eq_ignore_ascii_case(stringify!($scene)) {
            return trace(&whit::tracer!(scenes::$scene, DEPTH), $job);
        })*
        Err(format!("this program has no tracer for the scene `{}`", $name))
    }};
}

impl Source {
    /// Finds a built-in scene by its name, or reads a file.
    pub fn open(name: &str) -> Result<Self, String> {
        if let Some((name, scene)) = scenes::ALL.into_iter().find(|(built_in, _)| *built_in == name) {
            return Ok(Self::BuiltIn { name, scene });
        }
        let path = Path::new(name);
        if path.extension().is_none_or(|extension| extension != "nff") {
            let names = scenes::ALL.map(|(name, _)| name).join(", ");
            return Err(format!("scene `{name}`: expected one of {names}, or a path to an .nff file"));
        }
        let text = std::fs::read(path).map_err(|error| format!("{name}: {error}"))?;
        let mut scene = FileScene::default();
        let summary = nff::read_bytes(&text, &mut scene).map_err(|error| format!("{name}: {error}"))?;
        let name = path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let identity = format!("a file of {} bytes with CRC-32 {:08x}", text.len(), crc32fast::hash(&text));
        Ok(Self::File { name, identity, size: summary.size, scene })
    }

    pub fn name(&self) -> &str {
        match self {
            Self::BuiltIn { name, .. } => name,
            Self::File { name, .. } => name,
        }
    }

    /// Which scene it is, wherever it is kept.
    pub fn identity(&self) -> String {
        match self {
            Self::BuiltIn { name, .. } => (*name).to_owned(),
            Self::File { identity, .. } => identity.clone(),
        }
    }

    /// The size of the picture when none is asked for.
    pub fn size(&self) -> Size {
        match self {
            Self::BuiltIn { name: "card" | "flake", .. } => Size::new(512, 512),
            Self::BuiltIn { .. } => Size::new(640, 480),
            Self::File { size, .. } => *size,
        }
    }

    pub fn encoding(&self) -> Encoding {
        match self {
            Self::BuiltIn { scene, .. } => Encoding::of(scene),
            Self::File { .. } => Encoding::Srgb,
        }
    }

    pub fn render(&self, job: &Job) -> Result<Picture, String> {
        match self {
            Self::BuiltIn { name, .. } => trace_built_in!(
                name, job; SHOWCASE SPHERES MIRRORS FLAKE CARD METALS WINDOW GLASS DEEP TINTS BUBBLE OIL TITANIUM PRISM
                MIRAGE SHIP SUNSET LENSES HOLE
            ),
            Self::File { scene, .. } => {
                const EFFECTS: u64 = nff::EFFECTS.with(Effects::HIERARCHY).bits();
                let scene = scene.as_scene().ok_or("the file was not read")?;
                let mut nodes = vec![Node::EMPTY; Hierarchy::nodes(scene.parts())];
                let mut leaves = vec![Leaf::EMPTY; scene.parts()];
                let hierarchy = Hierarchy::build(&scene, &mut nodes, &mut leaves).map_err(|full| full.to_string())?;
                let scene = scene.with_hierarchy(hierarchy);
                let tracer = Tracer::<f32, EFFECTS, DEPTH>::try_new(&scene);
                trace(&tracer.map_err(|error| error.to_string())?, job)
            }
        }
    }
}

/// A scene file in memory that grows.
#[derive(Default)]
pub struct FileScene {
    surroundings: Option<(Camera<f32>, Background<f32>)>,
    objects: Vec<Object<'static, f32>>,
    lights: Vec<Light<f32>>,
}

impl FileScene {
    fn as_scene(&self) -> Option<Scene<'_, f32>> {
        let (camera, background) = self.surroundings?;
        Some(Scene::new(camera, background).with_objects(&self.objects).with_lights(&self.lights))
    }
}

impl SceneStore for FileScene {
    fn room(&self) -> (usize, usize) {
        (usize::MAX, usize::MAX)
    }

    fn restart(&mut self, camera: Camera<f32>, background: Background<f32>) {
        *self = Self { surroundings: Some((camera, background)), ..Self::default() };
    }

    fn add_object(&mut self, object: Object<'static, f32>) -> Result<(), Full> {
        self.objects.push(object);
        Ok(())
    }

    fn add_light(&mut self, light: Light<f32>) -> Result<(), Full> {
        self.lights.push(light);
        Ok(())
    }
}
