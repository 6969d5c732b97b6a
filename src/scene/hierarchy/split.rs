//! Dividing leaves in two, so that a ray is likely to need only one side.

#![allow(clippy::indexing_slicing)] // In arrays, in range by the loops and by `bin`; `get` is not const.

use super::bounds::Bounds;
use super::{Leaf, leaf, swap};

/// How finely places to divide at are looked for.
const BINS: usize = 16;

/// Sorts the leaves from `first` to `end`, of which there are two at least, into those on the one and those on the other side of
/// a plane; where the others begin.
///
/// The plane is the one of the least surface-area cost (MacDonald and Booth, "Heuristics for Ray Tracing Using Space
/// Subdivision", The Visual Computer 1990), of those between bins of the leaves' middles (Wald, "On Fast Construction of
/// SAH-Based Bounding Volume Hierarchies", 2007).
pub(super) const fn split(leaves: &mut [Leaf], first: usize, end: usize) -> usize {
    let Some(Plane { axis, place, scale, low }) = best_plane(leaves, first, end) else {
        return first + (end - first) / 2;
    };
    let (mut left, mut right) = (first, end);
    while left < right {
        if bin(along(leaf(leaves, left).bounds.middle(), axis), low, scale) < place {
            left += 1;
        } else {
            right -= 1;
            swap(leaves, left, right);
        }
    }
    left
}

struct Plane {
    axis: usize,
    /// The first bin on the other side.
    place: usize,
    /// Bins for each unit of twice the middles, and where the first one begins.
    scale: f32,
    low: f32,
}

/// One of the coordinates.
const fn along([x, y, z]: [f32; 3], axis: usize) -> f32 {
    match axis {
        0 => x,
        1 => y,
        _ => z,
    }
}

const fn bin(middle: f32, low: f32, scale: f32) -> usize {
    let place = ((middle - low) * scale) as usize;
    if place < BINS { place } else { BINS - 1 }
}

/// `None` where all middles are in one place.
const fn best_plane(leaves: &[Leaf], first: usize, end: usize) -> Option<Plane> {
    let (low, high) = middles(leaves, first, end);
    let (mut best, mut least) = (None, f32::MAX);
    let mut axis = 0;
    while axis < 3 {
        let scale = BINS as f32 / (high[axis] - low[axis]);
        if high[axis] > low[axis] && scale < f32::MAX {
            let (bounds, counts) = bins(leaves, first, end, axis, low[axis], scale);
            let (place, cost) = cheapest(&bounds, &counts);
            if cost < least {
                least = cost;
                best = Some(Plane { axis, place, scale, low: low[axis] });
            }
        }
        axis += 1;
    }
    best
}

/// The ends of the middles along each axis.
const fn middles(leaves: &[Leaf], first: usize, end: usize) -> ([f32; 3], [f32; 3]) {
    let (mut bounds, mut i) = (Bounds::NOTHING, first);
    while i < end {
        let middle = leaf(leaves, i).bounds.middle();
        bounds = bounds.with(Bounds { low: middle, high: middle });
        i += 1;
    }
    (bounds.low, bounds.high)
}

/// What is in each bin: the box around it, and how many leaves.
const fn bins(
    leaves: &[Leaf],
    first: usize,
    end: usize,
    axis: usize,
    low: f32,
    scale: f32,
) -> ([Bounds; BINS], [u32; BINS]) {
    let (mut bounds, mut counts) = ([Bounds::NOTHING; BINS], [0; BINS]);
    let mut i = first;
    while i < end {
        let place = bin(along(leaf(leaves, i).bounds.middle(), axis), low, scale) % BINS;
        bounds[place] = bounds[place].with(leaf(leaves, i).bounds);
        counts[place] += 1;
        i += 1;
    }
    (bounds, counts)
}

/// The first bin of the other side, and the cost. The first bin and the last one are never empty.
const fn cheapest(bounds: &[Bounds; BINS], counts: &[u32; BINS]) -> (usize, f32) {
    let mut costs = [0.0; BINS];
    let (mut before, mut count, mut i) = (Bounds::NOTHING, 0, 0);
    while i + 1 < BINS {
        before = before.with(bounds[i]);
        count += counts[i];
        i += 1;
        costs[i] = before.area() * count as f32;
    }
    let (mut best, mut least) = (1, f32::MAX);
    let (mut behind, mut count) = (Bounds::NOTHING, 0);
    while i > 0 {
        behind = behind.with(bounds[i]);
        count += counts[i];
        let cost = costs[i] + behind.area() * count as f32;
        if cost < least {
            (best, least) = (i, cost);
        }
        i -= 1;
    }
    (best, least)
}
