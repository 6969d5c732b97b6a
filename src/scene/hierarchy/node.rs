//! A node: eight boxes in a grid.

use super::bounds::Bounds;

/// How many children a node has at most.
pub(crate) const WIDTH: usize = 8;

/// A node of a [`Hierarchy`](super::Hierarchy): up to eight boxes, each around primitives or around another node, in 104 bytes.
///
/// The boxes have their sides at places of a grid of 256 by 256 by 256, which is laid over all of them, so that a side is a byte
/// (Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The lower corner of the grid.
    pub(crate) origin: [f32; 3],
    /// The distance of its lines, powers of two.
    pub(crate) scale: [f32; 3],
    /// The lower sides, axis by axis.
    pub(crate) low: [[u8; WIDTH]; 3],
    /// The upper sides.
    pub(crate) high: [[u8; WIDTH]; 3],
    pub(crate) children: [Child; WIDTH],
}

/// What is in a box: another node, or leaves that lie side by side. In one word: how many leaves in the highest bits, and the
/// number of the node or of the first leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Child(u32);

impl Child {
    pub(crate) const NONE: Self = Self(u32::MAX);
    const SHIFT: u32 = 28;

    pub(crate) const fn node(number: usize) -> Self {
        Self(number as u32)
    }

    pub(super) const fn leaves(first: usize, count: usize) -> Self {
        Self(first as u32 | ((count as u32) << Self::SHIFT))
    }

    /// How many leaves; 0 for a node.
    #[inline(always)]
    pub(crate) const fn count(self) -> usize {
        (self.0 >> Self::SHIFT) as usize
    }

    /// The number of the node or of the first leaf.
    #[inline(always)]
    pub(crate) const fn first(self) -> usize {
        (self.0 & !(u32::MAX << Self::SHIFT)) as usize
    }
}

impl Node {
    /// Memory for one.
    pub const EMPTY: Self = Self {
        origin: [0.0; 3],
        scale: [1.0; 3],
        low: [[0; WIDTH]; 3],
        high: [[0; WIDTH]; 3],
        children: [Child::NONE; WIDTH],
    };

    /// A node with a grid over a box.
    pub(super) const fn over(bounds: &Bounds) -> Self {
        let ([a, b, c], [x, y, z]) = (bounds.low, bounds.high);
        Self { origin: bounds.low, scale: [spacing(a, x), spacing(b, y), spacing(c, z)], ..Self::EMPTY }
    }

    /// Puts a child into its place, in a box.
    #[allow(clippy::indexing_slicing)] // Places are below WIDTH.
    pub(super) const fn put(&mut self, place: usize, bounds: &Bounds, child: Child) {
        let (place, mut axis) = (place % WIDTH, 0);
        while axis < 3 {
            let (origin, scale) = (self.origin[axis], self.scale[axis]);
            // Conversions to a byte round down and stop at its ends.
            self.low[axis][place] = ((bounds.low[axis] - origin) / scale) as u8;
            let high = (bounds.high[axis] - origin) / scale;
            let floor = high as u8;
            self.high[axis][place] = if (floor as f32) < high { floor.saturating_add(1) } else { floor };
            axis += 1;
        }
        self.children[place] = child;
    }
}

/// The smallest power of two of which 255 reach from the one to the other; it is never too small to be divided by.
const fn spacing(low: f32, high: f32) -> f32 {
    let least = (high - low) / 255.0;
    let floor = f32::from_bits(least.to_bits() & 0x7F80_0000);
    let power = if floor < least { floor * 2.0 } else { floor };
    if power > f32::MIN_POSITIVE { power } else { f32::MIN_POSITIVE }
}
