//! A hierarchy of boxes around a scene's primitives, so that a ray looks at few of them.

mod bounds;
mod build;
mod node;
mod split;

pub(crate) use build::LEVELS;
pub use node::Node;
pub(crate) use node::{Child, WIDTH};

use super::{Full, Object, Scene};
use crate::math::Real;
use bounds::Bounds;

/// A hierarchy of boxes around the primitives of a scene's objects, in memory that the caller owns.
///
/// A ray then takes a time that grows as the logarithm of the number of primitives. What it meets is what a search through the
/// list of objects finds; of a few objects, that is as fast.
///
/// Planes are in no box, and every ray looks at them. So do not put one huge ball among many small things without need: boxes are
/// wider than what they hold by 4·10⁻⁶ of the largest coordinate of all.
///
/// ```
/// use whit::scene::{Hierarchy, Leaf, Node};
/// let scene = whit::scenes::SPHERES;
/// let (mut nodes, mut leaves) = ([Node::EMPTY; 8], [Leaf::EMPTY; 16]);
/// let hierarchy = Hierarchy::build(&scene, &mut nodes, &mut leaves)?;
/// let scene = scene.with_hierarchy(hierarchy);
/// # Ok::<(), whit::scene::Full>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hierarchy<'a> {
    /// The first one is the root; those around others come before them.
    pub(crate) nodes: &'a [Node],
    /// First those that no box holds.
    pub(crate) leaves: &'a [Leaf],
    /// How many no box holds.
    pub(crate) unbounded: usize,
    /// The largest coordinate of all boxes.
    pub(crate) extent: f32,
    /// Whether there is an object that a place can be inside of.
    pub(crate) has_media: bool,
}

/// A primitive of an object, with a box around it: 32 bytes of a [`Hierarchy`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    bounds: Bounds,
    /// The object's number in the list.
    pub(crate) object: u32,
    /// Which part of the object it is, where it has parts: a triangle of a list, or eight packed spheres.
    pub(crate) part: u32,
}

/// The memory of a [`Hierarchy`] of a constant scene.
///
/// ```
/// use whit::scene::{Hierarchy, HierarchyBuf, Scene};
/// use whit::scenes::SPHERES;
/// const PARTS: usize = SPHERES.parts();
/// static MEMORY: HierarchyBuf<{ Hierarchy::nodes(PARTS) }, PARTS> = HierarchyBuf::of(&SPHERES);
/// static SCENE: Scene<'static, f32> = SPHERES.with_hierarchy(MEMORY.view());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HierarchyBuf<const NODES: usize, const LEAVES: usize> {
    nodes: [Node; NODES],
    leaves: [Leaf; LEAVES],
    used: usize,
    unbounded: usize,
    extent: f32,
    has_media: bool,
}

impl Leaf {
    /// Memory for one.
    pub const EMPTY: Self = Self { bounds: Bounds::NOTHING, object: 0, part: 0 };
}

/// A leaf by its number; there is always one.
#[allow(clippy::indexing_slicing)] // In range by the condition; `get` is not const.
const fn leaf(leaves: &[Leaf], number: usize) -> Leaf {
    if number < leaves.len() { leaves[number] } else { Leaf::EMPTY }
}

/// Changes the places of two leaves.
#[allow(clippy::indexing_slicing)] // As above.
const fn swap(leaves: &mut [Leaf], one: usize, other: usize) {
    if one < leaves.len() && other < leaves.len() {
        (leaves[one], leaves[other]) = (leaves[other], leaves[one]);
    }
}

impl<'a> Hierarchy<'a> {
    /// A number of nodes that is enough for so many parts ([`Scene::parts`]).
    ///
    /// A node is around five leaves at least, or it has eight children, some of them nodes: from that, n leaves have at most
    /// (n − 1) / 4.
    #[must_use]
    pub const fn nodes(parts: usize) -> usize {
        if parts < 9 { 1 } else { (parts - 1) / 4 }
    }

    /// Builds the hierarchy of a scene.
    ///
    /// # Errors
    /// [`Full`] when there are fewer leaves than [`Scene::parts`] or too few nodes; [`nodes`](Self::nodes) are enough.
    pub fn build<T: Real>(scene: &Scene<'_, T>, nodes: &'a mut [Node], leaves: &'a mut [Leaf]) -> Result<Self, Full> {
        let (mut count, mut has_media) = (0, false);
        for (number, object) in (0..).zip(scene.objects) {
            has_media |= object.material.interface.is_transparent();
            let mut part = 0;
            while let Some(bounds) = Bounds::of_part(&object.shape, part) {
                let place = leaves.get_mut(count).ok_or(Full { what: "leaf", capacity: count })?;
                *place = Leaf { bounds, object: number, part: part as u32 };
                (count, part) = (count + 1, part + 1);
            }
        }
        let leaves = leaves.get_mut(..count).unwrap_or_default();
        let built = build::build(nodes, leaves)?;
        let nodes = nodes.get(..built.nodes).unwrap_or_default();
        Ok(Self { nodes, leaves, unbounded: built.unbounded, extent: built.extent, has_media })
    }
}

impl<const NODES: usize, const LEAVES: usize> HierarchyBuf<NODES, LEAVES> {
    /// Builds the hierarchy of a constant scene.
    ///
    /// # Panics
    /// When `LEAVES` is not [`Scene::parts`], or `NODES` is too small; in constant evaluation, where this belongs, that is an
    /// error of compilation.
    #[must_use]
    #[allow(clippy::panic, clippy::indexing_slicing)] // The only way to stop a constant's evaluation; in range by the loops.
    pub const fn of(scene: &Scene<'_, f32>) -> Self {
        assert!(scene.parts() == LEAVES, "LEAVES must be the number of the scene's parts");
        let (mut nodes, mut leaves) = ([Node::EMPTY; NODES], [Leaf::EMPTY; LEAVES]);
        let (mut count, mut number, mut has_media) = (0, 0, false);
        while number < scene.objects.len() {
            has_media |= scene.objects[number].material.interface.is_transparent();
            let mut part = 0;
            while let Some(bounds) = Bounds::of_f32_part(&scene.objects[number].shape, part) {
                leaves[count] = Leaf { bounds, object: number as u32, part: part as u32 };
                (count, part) = (count + 1, part + 1);
            }
            number += 1;
        }
        match build::build(&mut nodes, &mut leaves) {
            Ok(built) => {
                Self { nodes, leaves, used: built.nodes, unbounded: built.unbounded, extent: built.extent, has_media }
            }
            Err(_) => panic!("NODES must be larger: Hierarchy::nodes says what is enough"),
        }
    }

    /// The hierarchy, as a scene wants it.
    #[must_use]
    pub const fn view(&self) -> Hierarchy<'_> {
        let (nodes, _) = self.nodes.split_at(self.used);
        let &Self { ref leaves, unbounded, extent, has_media, .. } = self;
        Hierarchy { nodes, leaves, unbounded, extent, has_media }
    }
}

impl<T> Object<'_, T> {
    /// How many parts it has in a hierarchy.
    pub(crate) const fn parts(&self) -> usize {
        use super::Shape;
        match &self.shape {
            Shape::Spheres(list) => list.clusters.len(),
            Shape::Triangles(list) => list.len(),
            _ => 1,
        }
    }
}
