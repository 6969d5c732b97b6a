//! What is counted: the rendering of a small picture by one thread.
#![allow(unsafe_code)] // For the name of a function.

use std::hint::black_box;
use std::path::Path;

use whit::render::{ForEach, Pixel, Size};
use whit::scene::{Hierarchy, Leaf, Node, Sphere, nff};
use whit::{Effects, Frame, Object, Scene, Settings, Shape, Stats, Tracer, scenes};

use crate::files;
use crate::subject::{LARGEST, Subject};

/// Of the pictures, of one sample a pixel.
pub const SIZE: Size = Size::new(64, 48);
/// Bounces.
pub const DEPTH: u8 = 5;
const STACK: usize = DEPTH as usize;

/// What Valgrind counts the instructions in.
pub const FUNCTION: &str = "counted";

/// Does some work, whose instructions are counted.
#[unsafe(no_mangle)]
#[inline(never)]
fn counted(work: &mut dyn FnMut()) {
    work();
}

/// Counts a tracer at work.
macro_rules! draw_built_in {
    ($name:expr, $draw:ident; $($scene:ident)*) => {{
        $(if $name.eq_ignore_ascii_case(stringify!($scene)) {
            return $draw(&whit::tracer!(scenes::$scene, DEPTH as usize));
        })*
        Err(format!("this program has no tracer for the scene `{}`: is it built with --release?", $name))
    }};
}

/// Does what is counted of a subject, with a tracer for just the effects of its scene.
pub fn run(subject: Subject) -> Result<(), String> {
    match subject {
        Subject::BuiltIn(name) => with_built_in!(draw_built_in(name, draw;)),
        Subject::Flake(count) => flake(count, |scene| in_boxes(scene, draw_flake)),
        Subject::File(name) => file(name, |scene| in_boxes(scene, draw_file)),
        Subject::Building => flake(LARGEST, build),
    }
}

/// How many rays are traced in it, shadow rays included; none where it is no picture.
pub fn rays(subject: Subject) -> Result<Option<u64>, String> {
    match subject {
        Subject::BuiltIn(wanted) => {
            let scene = scenes::ALL.into_iter().find(|(name, _)| *name == wanted);
            scene.map(|(_, scene)| count_rays(&scene)).transpose()
        }
        Subject::Flake(count) => flake(count, |scene| in_boxes(scene, count_rays)).map(Some),
        Subject::File(name) => file(name, |scene| in_boxes(scene, count_rays)).map(Some),
        Subject::Building => Ok(None),
    }
}

fn draw<const EFFECTS: u64, const STACK: usize, const MEDIA: usize>(
    tracer: &Tracer<'_, f32, EFFECTS, STACK, MEDIA>,
) -> Result<(), String> {
    let settings = Settings::new(SIZE.width, SIZE.height).with_depth(DEPTH);
    let mut frame = Frame::new(tracer, settings).map_err(|error| error.to_string())?;
    let mut target = ForEach::new(SIZE, |pixel: Pixel| {
        black_box(pixel);
        Ok::<(), core::convert::Infallible>(())
    });
    let mut done = None;
    counted(black_box(&mut || done = Some(frame.render(&mut target))));
    if done == Some(Ok(())) { Ok(()) } else { Err("the picture was not finished".to_owned()) }
}

/// By a tracer for all effects, to which a scene takes the same rays as to one for its own.
fn count_rays(scene: &Scene<'_, f32>) -> Result<u64, String> {
    let tracer = Tracer::<f32, { Effects::ALL.bits() }, { STACK + 2 }, 8>::try_new(scene);
    let tracer = tracer.map_err(|error| error.to_string())?;
    let settings = Settings::new(SIZE.width, SIZE.height).with_depth(DEPTH);
    let mut frame = Frame::observed(&tracer, settings, Stats::default()).map_err(|error| error.to_string())?;
    let mut target = ForEach::new(SIZE, |_: Pixel| Ok::<(), core::convert::Infallible>(()));
    let Ok(()) = frame.render(&mut target) else { return Err("the picture was not finished".to_owned()) };
    Ok(frame.observer().rays())
}

fn draw_flake(scene: &Scene<'_, f32>) -> Result<(), String> {
    const EFFECTS: Effects =
        scenes::FLAKE.effects().without(Effects::SPHERES).with(Effects::SPHERE).with(Effects::HIERARCHY);
    draw(&Tracer::<f32, { EFFECTS.bits() }, STACK, 0>::try_new(scene).map_err(|error| error.to_string())?)
}

fn draw_file(scene: &Scene<'_, f32>) -> Result<(), String> {
    const EFFECTS: Effects = nff::EFFECTS.with(Effects::HIERARCHY);
    draw(&Tracer::<f32, { EFFECTS.bits() }, STACK>::try_new(scene).map_err(|error| error.to_string())?)
}

/// The sphere-flake with so many spheres, each an object.
fn flake<R>(count: usize, work: impl FnOnce(&Scene<'_, f32>) -> Result<R, String>) -> Result<R, String> {
    let spheres: [Sphere<f32>; LARGEST] = scenes::flake_spheres();
    let [floor, balls] = scenes::FLAKE.objects else {
        return Err("the flake is no longer balls on a floor".to_owned());
    };
    let balls = spheres.iter().take(count).map(|sphere| Object { shape: Shape::Sphere(*sphere), ..*balls });
    let objects: Vec<_> = [*floor].into_iter().chain(balls).collect();
    work(&scenes::FLAKE.with_objects(&objects))
}

fn file<R>(name: &str, work: impl FnOnce(&Scene<'_, f32>) -> Result<R, String>) -> Result<R, String> {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/nff")).join(name);
    work(&files::read(&path)?.as_scene())
}

fn in_boxes<R>(scene: &Scene<'_, f32>, work: impl FnOnce(&Scene<'_, f32>) -> Result<R, String>) -> Result<R, String> {
    let (mut nodes, mut leaves) = memory(scene);
    let hierarchy = Hierarchy::build(scene, &mut nodes, &mut leaves).map_err(|full| full.to_string())?;
    work(&scene.with_hierarchy(hierarchy))
}

/// Counts the building of the hierarchy.
fn build(scene: &Scene<'_, f32>) -> Result<(), String> {
    let (mut nodes, mut leaves) = memory(scene);
    let mut built = Ok(());
    counted(black_box(&mut || {
        built = Hierarchy::build(scene, &mut nodes, &mut leaves).map(|built| _ = black_box(built))
    }));
    built.map_err(|full| full.to_string())
}

fn memory(scene: &Scene<'_, f32>) -> (Vec<Node>, Vec<Leaf>) {
    let parts = scene.parts();
    (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts])
}
