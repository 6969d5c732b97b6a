//! The ray tree, walked without recursion.
//!
//! Light is gathered forwards: a branch carries the throughput of the whole path to the eye, so nothing has to be
//! returned. The walk keeps one current branch and puts only its sibling aside, so a tree of depth `DEPTH` needs a
//! stack of exactly `DEPTH` entries.

use heapless::{Vec, VecView};

use super::background::background;
use super::shade::{Samples, Shading};
use super::split::Split;
use super::{Budget, Cut, Observer, RayKind, Termination};
use crate::intersect::Ray;
use crate::math::{Real, Rgb};
use crate::path::next_surface;
use crate::scene::Scene;

/// A ray that is still to be followed.
#[derive(Clone, Copy, Debug)]
struct Branch<T> {
    ray: Ray<T>,
    throughput: Rgb<T>,
    depth: u8,
    kind: RayKind,
}

/// The state of one sample's ray tree: everything that a frame needs to stop at any ray and go on later.
#[derive(Clone, Debug)]
pub(crate) struct RayTree<'a, T, const DEPTH: usize> {
    walk: Walk<'a, T>,
    pending: Vec<Branch<T>, DEPTH>,
}

#[derive(Clone, Copy, Debug)]
struct Walk<'a, T> {
    gathered: Rgb<T>,
    current: Option<Branch<T>>,
    shading: Option<Shading<'a, T>>,
    /// What is left of the budget's rays.
    rays_left: u32,
}

/// What a walk reads and never changes.
pub(crate) struct Context<'c, 'a, T> {
    pub scene: &'c Scene<'a, T>,
    pub budget: &'c Budget<T>,
    pub samples: Samples,
}

impl<'a, T: Real, const DEPTH: usize> RayTree<'a, T, DEPTH> {
    /// A tree with nothing in it.
    pub(crate) const fn new() -> Self {
        let walk = Walk { gathered: Rgb::BLACK, current: None, shading: None, rays_left: 0 };
        Self { walk, pending: Vec::new() }
    }

    /// Follows the tree until it is done, which gives its light, or until `rays` is used up. What happens does not
    /// depend on where it stops.
    ///
    /// `start` starts it over with an eye ray that may cost so many rays. A tree that is done in one go is never
    /// written to memory.
    #[inline]
    pub(crate) fn advance<const EFFECTS: u64, O: Observer>(
        &mut self,
        start: Option<(Ray<T>, u32)>,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) -> Option<Rgb<T>> {
        let mut walk = match start {
            Some((ray, rays)) => {
                self.pending.clear();
                Walk::start(ray, rays)
            }
            None => self.walk,
        };
        if walk.advance::<EFFECTS, O>(self.pending.as_mut_view(), context, rays, observer) {
            return Some(walk.gathered);
        }
        self.walk = walk;
        None
    }
}

impl<'a, T: Real> Walk<'a, T> {
    #[inline(always)]
    fn start(ray: Ray<T>, rays: u32) -> Self {
        let eye = Branch { ray, throughput: Rgb::WHITE, depth: 0, kind: RayKind::Eye };
        Self { gathered: Rgb::BLACK, current: Some(eye), shading: None, rays_left: rays }
    }

    /// Goes on until the tree is done (`true`) or `rays` is used up; it sees the stack as a view, whatever its depth.
    #[inline(always)]
    fn advance<const EFFECTS: u64, O: Observer>(
        &mut self,
        pending: &mut VecView<Branch<T>>,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) -> bool {
        loop {
            if !self.light::<EFFECTS, O>(context, rays, observer) {
                return false;
            }
            let Some(branch) = self.current.take().or_else(|| pending.pop()) else { return true };
            if *rays == 0 {
                self.current = Some(branch);
                return false;
            }
            *rays -= 1;
            // The branch and a shadow ray to each light must be paid for, so that no point is left half lit.
            if self.rays_left as usize <= context.scene.lights.len() {
                self.cut::<EFFECTS, O>(context, &branch, Cut::Rays, observer);
                continue;
            }
            self.rays_left -= 1;
            observer.ray(branch.kind);
            self.follow::<EFFECTS, O>(&branch, pending, context, observer);
        }
    }

    /// Looks at the lights of the surface that was met last; `false` when `rays` is used up first.
    #[inline(always)]
    fn light<const EFFECTS: u64, O: Observer>(
        &mut self,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) -> bool {
        let Some(mut shading) = self.shading.take() else { return true };
        let before = *rays;
        let done = shading.advance::<EFFECTS, O>(context.scene, &context.samples, &mut self.gathered, rays, observer);
        self.rays_left = self.rays_left.saturating_sub(before - *rays);
        if !done {
            self.shading = Some(shading);
        }
        done
    }

    /// Follows a branch to the next surface: looks at its lights next, and spawns its children.
    #[inline(always)]
    fn follow<const EFFECTS: u64, O: Observer>(
        &mut self,
        branch: &Branch<T>,
        pending: &mut VecView<Branch<T>>,
        context: &Context<'_, 'a, T>,
        observer: &mut O,
    ) {
        let scene = context.scene;
        let Some(hit) = next_surface::<T, EFFECTS>(scene, &branch.ray) else {
            self.gathered += branch.throughput * background::<T, EFFECTS>(scene, branch.ray.direction);
            return;
        };
        let surface = hit.surface::<EFFECTS>(&branch.ray);
        let (front, incident) = (hit.contact.front(), branch.ray.direction);
        let material = &hit.object.material;
        self.shading = Shading::new::<EFFECTS>(material, &surface, front, incident, branch.throughput, branch.depth);
        if let Some(shading) = &self.shading {
            self.gathered += shading.emitted::<EFFECTS>();
        }
        let split = Split::new::<EFFECTS>(&material.interface, scene.index, &surface, front, incident);
        if split.is_total {
            observer.total_internal_reflection();
        }
        let children =
            [(split.reflected, RayKind::Reflected, front), (split.transmitted, RayKind::Transmitted, !front)];
        for (child, kind, outside) in children {
            let Some((direction, weight)) = child else { continue };
            let child = Branch {
                ray: surface.leave(direction, outside),
                throughput: branch.throughput * weight,
                depth: branch.depth.saturating_add(1),
                kind,
            };
            self.spawn::<EFFECTS, O>(child, pending, context, observer);
        }
    }

    /// Takes a branch into the walk, unless it weighs nothing or the budget cuts it.
    #[inline(always)]
    fn spawn<const EFFECTS: u64, O: Observer>(
        &mut self,
        branch: Branch<T>,
        pending: &mut VecView<Branch<T>>,
        context: &Context<'_, 'a, T>,
        observer: &mut O,
    ) {
        let weight = branch.throughput.max_channel();
        if weight <= T::ZERO {
            return;
        }
        let cut = if branch.depth > context.budget.depth {
            Some(Cut::Depth)
        } else if weight < context.budget.cutoff {
            Some(Cut::Cutoff)
        } else if self.current.is_none() {
            self.current = Some(branch);
            None
        } else {
            // There is room whenever the depth is within `DEPTH`.
            pending.push(branch).err().map(|_| Cut::Depth)
        };
        if let Some(reason) = cut {
            self.cut::<EFFECTS, O>(context, &branch, reason, observer);
        }
    }

    /// Puts the termination colour in the place of a branch.
    fn cut<const EFFECTS: u64, O: Observer>(
        &mut self,
        context: &Context<'_, 'a, T>,
        branch: &Branch<T>,
        reason: Cut,
        observer: &mut O,
    ) {
        observer.cut(reason, branch.throughput.map(T::to_f32));
        let color = match context.budget.termination {
            Termination::Background => background::<T, EFFECTS>(context.scene, branch.ray.direction),
            Termination::Black => return,
            Termination::Color(color) => color,
        };
        self.gathered += branch.throughput * color;
    }
}
