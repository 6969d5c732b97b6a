//! The order of spheres in which neighbours are together.

use super::Sphere;
use crate::math::{LANES, Vec3};

/// Halves of halves, each cut across its longest side, until eight or fewer are left together.
#[allow(clippy::indexing_slicing)] // In range by the loop's condition: at most one cut a bit of `N`.
pub(super) const fn sort_into_neighbours<const N: usize>(spheres: &[Sphere<f32>; N]) -> [Sphere<f32>; N] {
    let (mut sorted, mut spare) = (*spheres, *spheres);
    let (mut first, mut ends, mut depth) = (0, [N; usize::BITS as usize + 1], 1);
    while depth > 0 {
        let end = ends[depth - 1];
        let count = end - first;
        if count <= LANES {
            (first, depth) = (end, depth - 1);
            continue;
        }
        let part = sorted.split_at_mut(first).1.split_at_mut(count).0;
        sort(part, spare.split_at_mut(count).0, longest_side(part));
        ends[depth] = first + count.div_ceil(LANES).div_ceil(2) * LANES;
        depth += 1;
    }
    sorted
}

/// The axis along which the centres are spread most.
#[allow(clippy::indexing_slicing)] // In range by the loops' conditions.
const fn longest_side(spheres: &[Sphere<f32>]) -> u8 {
    let (mut best, mut widest) = (0, -1.0);
    let mut axis = 0;
    while axis < 3 {
        let (mut low, mut high) = (f32::MAX, f32::MIN);
        let mut i = 0;
        while i < spheres.len() {
            low = low.min(coordinate(spheres[i].center, axis));
            high = high.max(coordinate(spheres[i].center, axis));
            i += 1;
        }
        if high - low > widest {
            (best, widest) = (axis, high - low);
        }
        axis += 1;
    }
    best
}

/// Sorts spheres by a coordinate of their centres, equal ones in their order: runs of one are merged to runs of two, these to
/// runs of four, and so on. `spare` is memory for as many.
const fn sort(spheres: &mut [Sphere<f32>], spare: &mut [Sphere<f32>], axis: u8) {
    let (end, mut run) = (spheres.len(), 1);
    while run < end {
        let mut start = 0;
        while start < end {
            let (middle, stop) = (min(start + run, end), min(start + 2 * run, end));
            merge(spheres, spare, [start, middle, stop], axis);
            start = stop;
        }
        spheres.copy_from_slice(spare);
        run *= 2;
    }
}

/// Merges two sorted runs, which end at `middle` and at `stop`, into the same place of `merged`.
#[allow(clippy::indexing_slicing)] // In range by the conditions.
const fn merge(spheres: &[Sphere<f32>], merged: &mut [Sphere<f32>], [start, middle, stop]: [usize; 3], axis: u8) {
    let (mut left, mut right, mut place) = (start, middle, start);
    while place < stop {
        let is_right_first = left == middle
            || (right < stop && coordinate(spheres[right].center, axis) < coordinate(spheres[left].center, axis));
        let from = if is_right_first { &mut right } else { &mut left };
        merged[place] = spheres[*from];
        (*from, place) = (*from + 1, place + 1);
    }
}

/// `Ord::min` is not const.
const fn min(a: usize, b: usize) -> usize {
    if a < b { a } else { b }
}

const fn coordinate(v: Vec3<f32>, axis: u8) -> f32 {
    match axis {
        0 => v.x,
        1 => v.y,
        _ => v.z,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::scenes::flake_spheres;

    #[test]
    fn spheres_are_sorted_as_by_std_and_equal_ones_keep_their_order() {
        let mut spheres = flake_spheres::<91>();
        // Few coordinates, so that many are equal.
        spheres.iter_mut().for_each(|s| s.center.x = (s.center.x * 4.0).round());
        for (axis, first, end) in [(0, 0, 91), (1, 3, 90), (2, 5, 6), (0, 40, 40), (0, 11, 28)] {
            let (mut sorted, mut spare, mut expected) = (spheres, spheres, spheres);
            sort(&mut sorted[first..end], &mut spare[first..end], axis);
            let coordinate = |s: &Sphere<f32>| coordinate(s.center, axis);
            let by = |a: &_, b: &_| coordinate(a).partial_cmp(&coordinate(b)).unwrap();
            expected[first..end].sort_by(by);
            assert_eq!(sorted, expected, "{axis} {first} {end}");
        }
    }
}
