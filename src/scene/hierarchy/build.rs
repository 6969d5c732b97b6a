//! Building the nodes over leaves.

#![allow(clippy::indexing_slicing)] // In range by the conditions beside; `get` is not const.

use super::bounds::Bounds;
use super::node::{Child, Node, WIDTH};
use super::split::split;
use super::{Leaf, leaf, swap};
use crate::scene::Full;

/// The most leaves in a box that is not divided further.
const MOST_LEAVES: usize = 4;

/// From this level on, boxes are divided into equal numbers of leaves, so that there are at most [`LEVELS`].
const BALANCED: usize = 6;

/// The most nodes around each other.
pub(crate) const LEVELS: usize = 14;

/// The most leaves: 8 to the power of [`LEVELS`] − [`BALANCED`].
const CAPACITY: usize = 1 << (3 * (LEVELS - BALANCED));

/// What was built.
pub(super) struct Built {
    pub nodes: usize,
    pub unbounded: usize,
    pub extent: f32,
}

/// The leaves from `first` to `end`.
#[derive(Clone, Copy)]
struct Range {
    first: usize,
    end: usize,
    bounds: Bounds,
}

/// Builds the nodes level by level. A node that is yet to be divided keeps its leaves' numbers in its first two children.
pub(super) const fn build(nodes: &mut [Node], leaves: &mut [Leaf]) -> Result<Built, Full> {
    if leaves.len() > CAPACITY {
        return Err(Full { what: "leaf", capacity: CAPACITY });
    }
    let unbounded = unbounded_first(leaves);
    let whole = Range::of(leaves, unbounded, leaves.len());
    if whole.count() == 0 {
        return Ok(Built { nodes: 0, unbounded, extent: 0.0 });
    }
    if nodes.is_empty() {
        return Err(Full { what: "node", capacity: 0 });
    }
    nodes[0] = whole.waiting();
    let (mut used, mut level, mut end_of_level, mut number) = (1, 0, 1, 0);
    while number < used && number < nodes.len() {
        if number == end_of_level {
            (level, end_of_level) = (level + 1, used);
        }
        let range = Range::of(leaves, nodes[number].children[0].first(), nodes[number].children[1].first());
        let (ranges, count) = divide(leaves, range, level >= BALANCED);
        let mut node = Node::over(&range.bounds);
        let mut place = 0;
        while place < count && place < WIDTH {
            let part = ranges[place];
            let child = if part.count() > MOST_LEAVES {
                if used >= nodes.len() {
                    return Err(Full { what: "node", capacity: used });
                }
                nodes[used] = part.waiting();
                used += 1;
                Child::node(used - 1)
            } else {
                Child::leaves(part.first, part.count())
            };
            node.put(place, &part.bounds, child);
            place += 1;
        }
        nodes[number] = node;
        number += 1;
    }
    Ok(Built { nodes: used, unbounded, extent: whole.bounds.largest() })
}

/// Sorts the leaves that no box holds to the front; how many there are.
const fn unbounded_first(leaves: &mut [Leaf]) -> usize {
    let (mut count, mut i) = (0, 0);
    while i < leaves.len() {
        if !leaf(leaves, i).bounds.is_finite() {
            swap(leaves, i, count);
            count += 1;
        }
        i += 1;
    }
    count
}

/// Divides a range into up to eight, the one that costs most first: those that are too large for leaves, and then all others, for
/// which there is room in the node anyway.
const fn divide(leaves: &mut [Leaf], whole: Range, is_balanced: bool) -> ([Range; WIDTH], usize) {
    let (mut ranges, mut count) = ([whole; WIDTH], 1);
    while count < WIDTH {
        let large = costliest(&ranges, count, MOST_LEAVES, is_balanced);
        let widest = if large.is_some() { large } else { costliest(&ranges, count, 1, is_balanced) };
        let Some(widest) = widest else { break };
        let widest = widest % WIDTH;
        let Range { first, end, .. } = ranges[widest];
        let middle = if is_balanced { first + (end - first) / 2 } else { split(leaves, first, end) };
        ranges[widest] = Range::of(leaves, first, middle);
        ranges[count] = Range::of(leaves, middle, end);
        count += 1;
    }
    (ranges, count)
}

/// Of the ranges of more than so many leaves, the one of the largest surface, or of the most leaves.
const fn costliest(ranges: &[Range; WIDTH], count: usize, leaves: usize, by_count: bool) -> Option<usize> {
    let (mut found, mut most, mut i) = (None, -1.0, 0);
    while i < count && i < WIDTH {
        let cost = if by_count { ranges[i].count() as f32 } else { ranges[i].bounds.area() };
        if ranges[i].count() > leaves && cost > most {
            (found, most) = (Some(i), cost);
        }
        i += 1;
    }
    found
}

impl Range {
    const fn of(leaves: &[Leaf], first: usize, end: usize) -> Self {
        let (mut bounds, mut i) = (Bounds::NOTHING, first);
        while i < end {
            bounds = bounds.with(leaf(leaves, i).bounds);
            i += 1;
        }
        Self { first, end, bounds }
    }

    const fn count(&self) -> usize {
        self.end - self.first
    }

    const fn waiting(&self) -> Node {
        let mut node = Node::EMPTY;
        node.children[0] = Child::node(self.first);
        node.children[1] = Child::node(self.end);
        node
    }
}
