//! The search through a hierarchy of boxes.

use super::Ray;
use crate::math::{Real, Vec3};
use crate::scene::{Child, Hierarchy, LEVELS, Leaf, Node, WIDTH};

/// The most children that wait: of each level all but one, and the root.
const MOST_WAITING: usize = (WIDTH - 1) * LEVELS + 1;

/// How many roundings of the largest coordinate each box is wider on every side: more than all by which a primitive's own test,
/// the boxes' sides and the ray's conversion to `f32` can be off.
const SLACK: f32 = 64.0 / 16_777_216.0;

/// The shortest component of a direction, so that nothing is divided by 0. Over the farthest distance it moves nothing by more
/// than the slack.
const SHORTEST: f32 = 1e-18;

/// A ray in `f32`, with what the test of a box needs.
struct Line {
    origin: [f32; 3],
    /// 1 / direction.
    inverse: [f32; 3],
    /// By how much boxes are wider.
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
    let mut waiting = [(Child::NONE, 0.0_f32); MOST_WAITING];
    let mut count = 0;
    let mut next = if hierarchy.nodes.is_empty() { None } else { Some(Child::node(0)) };
    while let Some(child) = next.take() {
        if child.count() > 0 {
            for leaf in hierarchy.leaves.iter().skip(child.first()).take(child.count()) {
                match look(leaf) {
                    Some(shorter) => limit = after(shorter),
                    None => return,
                }
            }
        } else if let Some(node) = hierarchy.nodes.get(child.first()) {
            count = line.add(node, limit, &mut waiting, count);
        }
        while count > 0 && next.is_none() {
            count -= 1;
            next = waiting.get(count).filter(|(_, near)| *near <= limit).map(|(child, _)| *child);
        }
    }
}

/// The distance in `f32`, and a little more.
#[inline(always)]
fn after<T: Real>(limit: T) -> f32 {
    limit.to_f32() * (1.0 + 4.0 / 16_777_216.0)
}

impl Line {
    fn new<T: Real>(ray: &Ray<T>, extent: f32) -> Self {
        let [origin, direction] = [ray.origin, ray.direction].map(|v| {
            let Vec3 { x, y, z } = v.map(T::to_f32);
            [x, y, z]
        });
        let inverse = direction.map(|d| 1.0 / if d.abs() < SHORTEST { SHORTEST } else { d });
        let [x, y, z] = origin.map(f32::abs);
        let slack = (x.max(y).max(z) + extent) * SLACK;
        Self { origin, inverse, slack }
    }

    /// Adds the children of a node that are met to those that wait, the nearest last.
    #[inline(always)]
    fn add(&self, node: &Node, limit: f32, waiting: &mut [(Child, f32); MOST_WAITING], before: usize) -> usize {
        let near = self.meet(node, limit);
        let mut count = before;
        for (child, near) in node.children.iter().zip(near) {
            // Where there is no child, no more come; a box as wide as the slack would be met there.
            if *child == Child::NONE {
                break;
            }
            if near > limit {
                continue;
            }
            let Some(place) = waiting.get_mut(count) else { break };
            *place = (*child, near);
            let mut place = count;
            while place > before {
                let Some([nearer, farther]) = waiting.get_mut(place - 1..=place) else { break };
                if nearer.1 >= farther.1 {
                    break;
                }
                core::mem::swap(nearer, farther);
                place -= 1;
            }
            count += 1;
        }
        count
    }

    /// Where the ray enters each box of a node, at 0 if it starts inside; beyond any distance if it does not before the limit.
    ///
    /// Straight-line code for every lane is what compilers turn into vector instructions.
    #[inline(never)]
    fn meet(&self, node: &Node, limit: f32) -> [f32; WIDTH] {
        let (mut enter, mut leave) = ([0.0_f32; WIDTH], [limit; WIDTH]);
        let axes = self.origin.iter().zip(&self.inverse).zip(node.origin.iter().zip(&node.scale));
        let sides = node.low.iter().zip(&node.high);
        for (((origin, inverse), (grid, scale)), (low, high)) in axes.zip(sides) {
            let (first, last, slack) = if *inverse > 0.0 { (low, high, self.slack) } else { (high, low, -self.slack) };
            let (way, step) = (grid - origin, scale * inverse);
            let (to_first, to_last) = ((way - slack) * inverse, (way + slack) * inverse);
            for ((enter, leave), (first, last)) in enter.iter_mut().zip(&mut leave).zip(first.iter().zip(last)) {
                let (near, far) = (to_first + f32::from(*first) * step, to_last + f32::from(*last) * step);
                *enter = if near > *enter { near } else { *enter };
                *leave = if far < *leave { far } else { *leave };
            }
        }
        for (enter, leave) in enter.iter_mut().zip(leave) {
            *enter = if *enter > leave { f32::INFINITY } else { *enter };
        }
        enter
    }
}
