//! The search through a hierarchy of boxes.

use heapless::Vec;
use wide::CmpLe;

use super::{Bits, Ray};
use crate::math::{HAS_VECTORS, Lanes, Real, Vec3};
use crate::scene::{Child, Hierarchy, LEVELS, Leaf, Node, WIDTH};

/// The most children that wait: of each level all but one, and the root.
const MOST_WAITING: usize = (WIDTH - 1) * LEVELS + 1;

/// How many roundings of the largest coordinate each box is wider on every side: more than all by which a primitive's own test,
/// the boxes' sides and the ray's conversion to `f32` can be off.
const SLACK: f32 = 64.0 / 16_777_216.0;

/// The shortest component of a direction, so that nothing is divided by 0. Over the farthest distance it moves nothing by more
/// than the slack.
const SHORTEST: f32 = 1e-18;

/// The children that wait, and where the ray enters their boxes.
type Waiting = Vec<(Child, f32), MOST_WAITING>;

/// A ray in `f32`, with what the test of a box needs to know of it along each axis.
struct Line([Along; 3]);

/// Along one of the axes.
#[derive(Clone, Copy)]
struct Along {
    origin: f32,
    /// 1 / direction.
    inverse: f32,
    /// How far along the ray it is across the slack.
    slack: f32,
}

/// Looks at all leaves that a ray may meet before a limit, mostly the near ones first.
///
/// `look` says where the search goes on to from now on, as a distance that is never larger than before; `None` ends it. All
/// leaves of which no point is farther are looked at, so what is found does not depend on the boxes.
pub(super) fn walk<T: Real>(
    hierarchy: &Hierarchy<'_>,
    ray: &Ray<T>,
    limit: T,
    mut look: impl FnMut(&Leaf) -> Option<T>,
) {
    let line = Line::new(ray, hierarchy.extent);
    let mut limit = after(limit);
    let mut waiting = Waiting::new();
    let mut next = if hierarchy.nodes.is_empty() { None } else { Some(Child::node(0)) };
    while let Some(child) = next {
        if child.count() > 0 {
            for leaf in hierarchy.leaves.iter().skip(child.first()).take(child.count()) {
                match look(leaf) {
                    Some(shorter) => limit = after(shorter),
                    None => return,
                }
            }
        } else if let Some(node) = hierarchy.nodes.get(child.first()) {
            let (child, near) = line.add(node, limit, &mut waiting);
            if near < f32::INFINITY {
                next = Some(child);
                continue;
            }
        }
        next = loop {
            match waiting.pop() {
                Some((child, near)) if near <= limit => break Some(child),
                Some(_) => {}
                None => break None,
            }
        };
    }
}

/// The distance in `f32`, and a little more.
#[inline(always)]
fn after<T: Real>(limit: T) -> f32 {
    limit.to_f32() * (1.0 + 4.0 / 16_777_216.0)
}

impl Line {
    fn new<T: Real>(ray: &Ray<T>, extent: f32) -> Self {
        let Vec3 { x, y, z } = ray.origin.map(T::to_f32);
        let slack = (x.abs().max(y.abs()).max(z.abs()) + extent) * SLACK;
        let along = |origin: f32, direction: T| {
            let direction = direction.to_f32();
            let inverse = 1.0 / if direction.abs() < SHORTEST { SHORTEST } else { direction };
            Along { origin, inverse, slack: slack * inverse.abs() }
        };
        Self([along(x, ray.direction.x), along(y, ray.direction.y), along(z, ray.direction.z)])
    }

    /// Adds the children of a node that are met to those that wait, the nearest last.
    #[inline(always)]
    fn add(&self, node: &Node, limit: f32, waiting: &mut Waiting) -> (Child, f32) {
        let (near, met) = self.meet(node, limit);
        let mut nearest = (Child::NONE, f32::INFINITY);
        for lane in Bits(met) {
            let (Some(child), Some(near)) = (node.children.get(lane), near.get(lane)) else { break };
            // Where there is no child, a box as wide as the slack would be met.
            if *child == Child::NONE {
                break;
            }
            let (farther, nearer) =
                if *near < nearest.1 { (nearest, (*child, *near)) } else { ((*child, *near), nearest) };
            nearest = nearer;
            if farther.0 != Child::NONE && waiting.push(farther).is_err() {
                break;
            }
        }
        nearest
    }

    /// Where the ray enters each box of a node, at 0 if it starts inside, and a bit for each that it enters before the limit.
    #[inline(always)]
    fn meet(&self, node: &Node, limit: f32) -> ([f32; WIDTH], u32) {
        let [x, y, z] = &self.0;
        let axes = [x.axis(node, 0), y.axis(node, 1), z.axis(node, 2)];
        if HAS_VECTORS { meet_side_by_side(&axes, limit) } else { meet_one_by_one(&axes, &node.children, limit) }
    }
}

impl Along {
    /// What is known of the boxes of a node along this axis.
    #[inline(always)]
    #[allow(clippy::indexing_slicing)] // Axes are below 3.
    fn axis<'n>(&self, node: &'n Node, axis: usize) -> Axis<'n> {
        let (low, high) = (&node.low[axis], &node.high[axis]);
        let (first, last) = if self.inverse > 0.0 { (low, high) } else { (high, low) };
        let to_line_0 = (node.origin[axis] - self.origin) * self.inverse;
        let (to_first, to_last) = (to_line_0 - self.slack, to_line_0 + self.slack);
        Axis { first, last, to_first, to_last, step: node.scale[axis] * self.inverse }
    }
}

/// The boxes of a node along an axis.
struct Axis<'n> {
    /// The sides that the ray comes to first, as numbers of lines of the grid, and last.
    first: &'n [u8; WIDTH],
    last: &'n [u8; WIDTH],
    /// How far it is to line 0, less and more the slack.
    to_first: f32,
    to_last: f32,
    /// How far it is from line to line.
    step: f32,
}

#[inline(always)]
fn meet_side_by_side(axes: &[Axis<'_>; 3], limit: f32) -> ([f32; WIDTH], u32) {
    let all = Lanes::splat;
    let (mut enter, mut leave) = (Lanes::ZERO, all(limit));
    for Axis { first, last, to_first, to_last, step } in axes {
        let near = all(*to_first) + Lanes::new(first.map(f32::from)) * all(*step);
        let far = all(*to_last) + Lanes::new(last.map(f32::from)) * all(*step);
        (enter, leave) = (enter.fast_max(near), leave.fast_min(far));
    }
    (enter.to_array(), enter.cmp_le(leave).move_mask().cast_unsigned())
}

/// The same for one box after the other, of which most are done with after an axis or two.
#[inline(never)]
fn meet_one_by_one(axes: &[Axis<'_>; 3], children: &[Child; WIDTH], limit: f32) -> ([f32; WIDTH], u32) {
    let (mut nears, mut met) = ([0.0; WIDTH], 0);
    let [x, y, z] = axes;
    let sides = x.first.iter().zip(x.last).zip(y.first.iter().zip(y.last)).zip(z.first.iter().zip(z.last));
    for ((lane, place), (((sides_x, sides_y), sides_z), child)) in (0..).zip(&mut nears).zip(sides.zip(children)) {
        if *child == Child::NONE {
            break;
        }
        let span =
            x.cut(sides_x, (0.0, limit)).and_then(|span| y.cut(sides_y, span)).and_then(|span| z.cut(sides_z, span));
        if let Some((enter, _)) = span {
            *place = enter;
            met |= 1 << lane;
        }
    }
    (nears, met)
}

impl Axis<'_> {
    /// What is left of a span of the ray between two sides of a box.
    #[inline(always)]
    fn cut(&self, (first, last): (&u8, &u8), (enter, leave): (f32, f32)) -> Option<(f32, f32)> {
        let (near, far) = (self.to_first + f32::from(*first) * self.step, self.to_last + f32::from(*last) * self.step);
        let enter = if near > enter { near } else { enter };
        let leave = if far < leave { far } else { leave };
        if enter <= leave { Some((enter, leave)) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::Sequence;

    #[test]
    fn boxes_are_met_alike_side_by_side_and_one_by_one() {
        let mut count = 0;
        for round in 0..2000_u32 {
            let bytes = |i: u32| -> [u8; WIDTH] {
                core::array::from_fn(|lane| Sequence::new(round, i).bits(lane as u32, 0)[0].to_le_bytes()[3])
            };
            let number = |i: u32| Sequence::new(round, i).point::<f32>(0, 1)[0] * 2.0 - 1.0;
            let sides: [[[u8; WIDTH]; 2]; 3] = core::array::from_fn(|axis| {
                let (a, b) = (bytes(2 * axis as u32), bytes(2 * axis as u32 + 1));
                let order: [(u8, u8); WIDTH] =
                    core::array::from_fn(|lane| (a[lane].min(b[lane]), a[lane].max(b[lane])));
                [order.map(|(low, _)| low), order.map(|(_, high)| high)]
            });
            let axes: [Axis<'_>; 3] = core::array::from_fn(|axis| {
                let (step, start) = (number(10 + axis as u32), number(20 + axis as u32) * 256.0);
                let [low, high] = &sides[axis];
                let (first, last) = if step > 0.0 { (low, high) } else { (high, low) };
                let to_line_0 = start * step;
                Axis { first, last, to_first: to_line_0 - 0.01, to_last: to_line_0 + 0.01, step }
            });
            for limit in [50.0, f32::MAX, f32::INFINITY] {
                let (nears, met) = meet_side_by_side(&axes, limit);
                let (scalar_nears, scalar_met) = meet_one_by_one(&axes, &[Child::node(1); WIDTH], limit);
                assert_eq!(met, scalar_met);
                assert!(Bits(met).all(|lane| nears[lane].to_bits() == scalar_nears[lane].to_bits()));
                count += met.count_ones();
            }
        }
        assert!(count > 500, "{count}");
    }
}
