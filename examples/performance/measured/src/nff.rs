//! Scenes from files in the Neutral File Format.

use std::path::Path;

use whit::scene::{Hierarchy, Leaf, Node, nff};
use whit::{Effects, SceneBuf, Tracer};

use crate::clock::timed;
use crate::layout::{DEPTH, Visitor};

/// A file's scene in a layout.
pub fn with_file(path: &Path, layout: &str, visitor: impl Visitor) -> Result<(), String> {
    const BOXED: Effects = nff::EFFECTS.with(Effects::HIERARCHY);
    let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = std::fs::read(path).map_err(|error| failed(&error))?;
    let mut stored = Box::new(SceneBuf::<f32, 2048, 8>::EMPTY);
    nff::read_bytes(&text, &mut *stored).map_err(|error| failed(&error))?;
    let scene = stored.as_scene();
    if layout != "boxes" {
        let tracer = Tracer::<f32, { nff::EFFECTS.bits() }, DEPTH>::try_new(&scene).map_err(|error| failed(&error))?;
        return visitor.visit(&tracer, 0.0);
    }
    let parts = scene.parts();
    let (mut nodes, mut leaves) = (vec![Node::EMPTY; Hierarchy::nodes(parts)], vec![Leaf::EMPTY; parts]);
    let (hierarchy, building) = timed(|| Hierarchy::build(&scene, &mut nodes, &mut leaves));
    let scene = scene.with_hierarchy(hierarchy.map_err(|error| failed(&error))?);
    let tracer = Tracer::<f32, { BOXED.bits() }, DEPTH>::try_new(&scene).map_err(|error| failed(&error))?;
    visitor.visit(&tracer, building)
}
