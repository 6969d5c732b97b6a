//! How the objects of a scene lie in memory.

use std::path::Path;

use whit::scene::nff::EFFECTS;
use whit::scene::{Hierarchy, Leaf, Node, PackedSpheres, Sphere};
use whit::{Effects, Object, Scene, Shape, Tracer, scenes};

use crate::clock::timed;
use crate::crowd::Crowd;
use crate::nff;

/// Something to be done with a tracer.
pub trait Visitor {
    /// `build` is the nanoseconds that it took to pack the scene's primitives and to put them into boxes.
    fn visit<const EFFECTS: u64>(self, tracer: &Tracer<'_, f32, EFFECTS, DEPTH>, build: f64) -> Result<(), String>;
}

pub const DEPTH: usize = 5;

const SURROUNDINGS: Effects = scenes::FLAKE.effects().without(Effects::SPHERES);
const SPHERES: Effects = SURROUNDINGS.with(Effects::SPHERE);
const PACKED: Effects = SURROUNDINGS.with(Effects::SPHERES);
const TRIANGLES: Effects = SURROUNDINGS.with(Effects::TRIANGLES);

/// The scene of the built-in flake with other objects than its balls, all of their material.
pub fn with_scene(crowd: &Crowd, layout: &str, visitor: impl Visitor) -> Result<(), String> {
    let (boxes, packed) = match layout {
        "list" => (false, false),
        "boxes" => (true, false),
        "packed" => (false, true),
        "packed-boxes" => (true, true),
        _ => return Err(format!("{layout}: expected list, boxes, packed or packed-boxes")),
    };
    match crowd {
        Crowd::Spheres(spheres) if packed => with_packed(spheres, boxes, visitor),
        Crowd::Spheres(spheres) => {
            let shapes: Vec<_> = spheres.iter().map(|sphere| Shape::Sphere(*sphere)).collect();
            with_shapes::<{ SPHERES.bits() }, { boxed(SPHERES) }>(&shapes, boxes, 0.0, visitor)
        }
        Crowd::Triangles(triangles) => {
            let shapes = [Shape::Triangles(triangles)];
            with_shapes::<{ TRIANGLES.bits() }, { boxed(TRIANGLES) }>(&shapes, boxes, 0.0, visitor)
        }
    }
}

const fn boxed(effects: Effects) -> u64 {
    effects.with(Effects::HIERARCHY).bits()
}

/// The numbers of spheres that there is packing for.
fn with_packed(spheres: &[Sphere<f32>], boxes: bool, visitor: impl Visitor) -> Result<(), String> {
    macro_rules! pack {
        ($($count:literal)*) => {
            match spheres.len() {
                $($count => {
                    const CLUSTERS: usize = ($count as usize).div_ceil(8);
                    let spheres: &[_; $count] = spheres.try_into().map_err(|_| "spheres got lost")?;
                    let pack = || Box::new(PackedSpheres::<f32, { CLUSTERS.div_ceil(8) }, CLUSTERS>::new(spheres));
                    let (packed, time) = timed(pack);
                    let shapes = [Shape::Spheres(packed.view())];
                    with_shapes::<{ PACKED.bits() }, { boxed(PACKED) }>(&shapes, boxes, time, visitor)
                })*
                count => Err(format!("{count} spheres: there is no packing for them")),
            }
        };
    }
    pack!(1 10 20 50 91 100 200 500 820 1000 2000 5000 7381 10_000 20_000 50_000 100_000)
}

fn with_shapes<const LIST: u64, const BOXED: u64>(
    shapes: &[Shape<'_, f32>],
    boxes: bool,
    packing: f64,
    visitor: impl Visitor,
) -> Result<(), String> {
    let [floor, ball] = scenes::FLAKE.objects else { return Err("the flake has other objects now".to_owned()) };
    let balls = shapes.iter().map(|&shape| Object::new(shape, ball.material));
    let objects: Vec<_> = std::iter::once(*floor).chain(balls).collect();
    let scene = Scene { objects: &objects, ..scenes::FLAKE };
    with_tracer::<LIST, BOXED>(&scene, boxes, packing, visitor)
}

/// The scene of a file, by a tracer for all that a file can call for.
pub fn with_file(path: &Path, layout: &str, visitor: impl Visitor) -> Result<(), String> {
    let boxes = match layout {
        "list" => false,
        "boxes" => true,
        _ => return Err(format!("{layout}: expected list or boxes")),
    };
    let stored = nff::read(path)?;
    with_tracer::<{ EFFECTS.bits() }, { boxed(EFFECTS) }>(&stored.as_scene(), boxes, 0.0, visitor)
}

fn with_tracer<const LIST: u64, const BOXED: u64>(
    scene: &Scene<'_, f32>,
    boxes: bool,
    packing: f64,
    visitor: impl Visitor,
) -> Result<(), String> {
    if !boxes {
        let tracer = Tracer::<f32, LIST, DEPTH>::try_new(scene).map_err(|error| error.to_string())?;
        return visitor.visit(&tracer, packing);
    }
    let parts = scene.parts();
    let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts]);
    let (hierarchy, building) = timed(|| Hierarchy::build(scene, &mut nodes, &mut leaves));
    let scene = scene.with_hierarchy(hierarchy.map_err(|full| full.to_string())?);
    let tracer = Tracer::<f32, BOXED, DEPTH>::try_new(&scene).map_err(|error| error.to_string())?;
    visitor.visit(&tracer, packing + building)
}
