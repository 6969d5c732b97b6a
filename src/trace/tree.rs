//! The ray tree, walked without recursion.
//!
//! Light is gathered forwards: a branch carries the throughput of the whole path to the eye, so nothing has to be
//! returned. The walk keeps one current branch and puts only its sibling aside, so a tree of depth `DEPTH` needs a
//! stack of exactly `DEPTH` entries.

use heapless::{Vec, VecView};

use super::background::background;
use super::media::{Crossing, Media};
use super::meeting::{Meeting, reflected};
use super::shade::{Samples, Shading};
use super::{Budget, Cut, MOST_BOUNCES, MOST_PASSED, Observer, RayKind, Termination};
use crate::intersect::{Hit, Ray};
use crate::math::{Real, Rgb, Vec3};
use crate::path::{self, Arrival, Path, StepsLeft, next_surface};
use crate::scene::{Channel, Effects, Scene};

/// A ray that is still to be followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch<T, const MEDIA: usize> {
    pub ray: Ray<T>,
    pub throughput: Rgb<T>,
    /// What the ray's origin lies in.
    pub media: Media<MEDIA>,
    pub depth: u8,
    /// Surfaces that it went straight through since the last bounce.
    pub passed: u8,
    pub kind: RayKind,
    /// The only channel that is left, after dispersion.
    pub channel: Option<Channel>,
}

/// The state of one sample's ray tree: everything that a frame needs to stop at any ray and go on later.
///
/// The order of the fields is given: a compiler that moves a new tree then sees which of its bytes were never written, the
/// stack at the end most of all, and copies none of them.
#[derive(Clone, Debug)]
#[repr(C)]
pub(crate) struct RayTree<'a, T, const DEPTH: usize, const MEDIA: usize> {
    walk: Walk<'a, T, MEDIA>,
    pending: Vec<Branch<T, MEDIA>, DEPTH>,
}

#[derive(Clone, Copy, Debug)]
#[repr(C)]
struct Walk<'a, T, const MEDIA: usize> {
    gathered: Rgb<T>,
    /// What is left of the budget's rays.
    rays_left: u32,
    current: Option<Branch<T, MEDIA>>,
    shading: Option<Shading<'a, T, MEDIA>>,
}

/// What a walk reads and never changes.
pub(crate) struct Context<'c, 'a, T> {
    pub scene: &'c Scene<'a, T>,
    pub budget: &'c Budget<T>,
    pub samples: Samples,
}

/// A bent path, to a surface or away for ever.
struct Way<'a, T> {
    hit: Option<Hit<'a, T>>,
    /// Where it goes at its end.
    direction: Vec3<T>,
    distance: T,
}

impl<'a, T: Real, const DEPTH: usize, const MEDIA: usize> RayTree<'a, T, DEPTH, MEDIA> {
    /// A tree with nothing in it.
    pub(crate) const fn new() -> Self {
        let walk = Walk { gathered: Rgb::BLACK, current: None, shading: None, rays_left: 0 };
        Self { walk, pending: Vec::new() }
    }

    /// Starts the tree over with an eye ray that may cost so many rays.
    pub(crate) fn start<const EFFECTS: u64, O: Observer>(
        &mut self,
        ray: Ray<T>,
        rays: u32,
        scene: &Scene<'_, T>,
        observer: &mut O,
    ) {
        let (media, overflow) = Media::around::<T, EFFECTS>(scene, &ray);
        if overflow {
            observer.media_overflow();
        }
        let eye = Branch { ray, throughput: Rgb::WHITE, media, depth: 0, passed: 0, kind: RayKind::Eye, channel: None };
        self.pending.clear();
        self.walk.gathered = Rgb::BLACK;
        self.walk.current = Some(eye);
        self.walk.shading = None;
        self.walk.rays_left = rays;
    }

    /// Follows the tree until it is done, which gives its light, or until `rays` is used up. What happens does not
    /// depend on where it stops.
    pub(crate) fn advance<const EFFECTS: u64, O: Observer>(
        &mut self,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) -> Option<Rgb<T>> {
        let done = self.walk.advance::<EFFECTS, O>(self.pending.as_mut_view(), context, rays, observer);
        done.then_some(self.walk.gathered)
    }
}

impl<'a, T: Real, const MEDIA: usize> Walk<'a, T, MEDIA> {
    /// Goes on until the tree is done (`true`) or `rays` is used up; it sees the stack as a view, whatever its depth.
    fn advance<const EFFECTS: u64, O: Observer>(
        &mut self,
        pending: &mut VecView<Branch<T, MEDIA>>,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) -> bool {
        loop {
            // First the lights of the surface that was met last.
            if let Some(shading) = &mut self.shading {
                let (gathered, rays_left) = (&mut self.gathered, &mut self.rays_left);
                if !shading.advance::<EFFECTS, O>(context, gathered, rays, rays_left, observer) {
                    return false;
                }
                self.shading = None;
            }
            if self.current.is_none() {
                self.current = pending.pop();
            }
            let Some(mut branch) = self.current else { return true };
            if *rays == 0 {
                return false;
            }
            *rays -= 1;
            self.current = None;
            // The branch and a shadow ray to each light must be paid for, so that no point is left half lit.
            if self.rays_left as usize <= context.scene.lights.len() {
                self.cut::<EFFECTS, O>(context, &branch, Cut::Rays, observer);
                continue;
            }
            self.rays_left -= 1;
            observer.ray(branch.kind);
            self.follow::<EFFECTS, O>(&mut branch, pending, context, rays, observer);
        }
    }

    /// Follows a branch to the next surface: looks at its lights next, and spawns its children.
    fn follow<const EFFECTS: u64, O: Observer>(
        &mut self,
        branch: &mut Branch<T, MEDIA>,
        pending: &mut VecView<Branch<T, MEDIA>>,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) {
        let scene = context.scene;
        let mut bent = None;
        let hit = if path::is_bent::<EFFECTS>() {
            let Some(way) = self.bend::<EFFECTS, O>(branch, context, rays, observer) else { return };
            bent = Some((way.direction, way.distance));
            way.hit
        } else {
            next_surface::<T, EFFECTS>(scene, &branch.ray)
        };
        if Effects::from_bits(EFFECTS).has(Effects::ATTENUATION) {
            let straight = hit.as_ref().map_or(T::MAX, |hit| hit.contact.t);
            let distance = bent.map_or(straight, |(_, distance)| distance);
            branch.throughput = branch.throughput * branch.media.transmittance(scene, distance);
        }
        let Some(hit) = hit else {
            self.gathered.gather(branch.throughput, background::<T, EFFECTS>(scene, branch.ray.direction));
            return;
        };
        let surface = hit.surface::<EFFECTS>(&branch.ray, &scene.offset).facing(hit.contact.front());
        let reach = if MEDIA > 0 { surface.reach(branch.ray.direction, hit.contact.t) } else { T::ZERO };
        let border = branch.media.border::<T, EFFECTS>(scene, &Crossing { hit: &hit, ray: &branch.ray, reach });
        if border.overflow {
            observer.media_overflow();
        }
        // The chord that meets the surface is not quite the path: it says on which side it does.
        if let Some((direction, _)) = bent.filter(|(direction, _)| direction.dot(surface.normal) < T::ZERO) {
            branch.ray.direction = direction;
        }
        if !border.is_real {
            branch.ray = surface.leave(branch.ray.direction, false);
            branch.media = border.media;
            branch.kind = RayKind::Passed;
            branch.passed = branch.passed.saturating_add(1);
            if branch.passed < MOST_PASSED {
                self.current = Some(*branch);
            } else {
                self.cut::<EFFECTS, O>(context, branch, Cut::Passed, observer);
            }
            return;
        }
        let (material, fresnel) = (&hit.object.material, scene.fresnel);
        let meeting = Meeting { branch, material, surface: &surface, border: &border, fresnel };
        let body = if branch.channel.is_none() && border.is_dispersive::<EFFECTS>() {
            self.disperse::<EFFECTS, O>(&meeting, pending, context, observer);
            T::ONE
        } else {
            self.split::<EFFECTS, O>(&meeting, pending, context, observer)
        };
        let shading = Shading::new::<EFFECTS>(material, &surface, branch, body);
        if let Some(shading) = &shading {
            self.gathered += shading.emitted::<EFFECTS>();
        }
        self.shading = shading;
    }

    /// Takes a branch along its bent path; `None` where that ends the branch.
    ///
    /// The ray of the branch becomes the last chord of the path. Each step counts as a ray of those after which the walk
    /// stops, so that it stops for as long paths as it does for many rays.
    fn bend<const EFFECTS: u64, O: Observer>(
        &mut self,
        branch: &mut Branch<T, MEDIA>,
        context: &Context<'_, 'a, T>,
        rays: &mut u32,
        observer: &mut O,
    ) -> Option<Way<'a, T>> {
        let scene = context.scene;
        let mut left = StepsLeft::new(context.budget.steps_per_ray);
        let index = branch.media.medium(scene).index;
        let arrival = Path::new(scene, index).follow::<EFFECTS>(&branch.ray, &mut left);
        *rays = rays.saturating_sub(left.taken());
        observer.steps(left.taken());
        match arrival {
            Arrival::Surface(landing) => {
                branch.ray = landing.chord;
                Some(Way { hit: Some(landing.hit), direction: landing.direction, distance: landing.distance })
            }
            Arrival::Away(direction) | Arrival::Limit(Ray { direction, .. }) => {
                branch.ray.direction = direction;
                Some(Way { hit: None, direction, distance: T::MAX })
            }
            Arrival::Captured => {
                observer.captured();
                None
            }
            Arrival::OutOfSteps(direction) => {
                branch.ray.direction = direction;
                self.cut::<EFFECTS, O>(context, branch, Cut::Steps, observer);
                None
            }
        }
    }

    /// Spawns the children at a surface; gives the share of the light that gets through to the body.
    fn split<const EFFECTS: u64, O: Observer>(
        &mut self,
        meeting: &Meeting<'_, T, MEDIA>,
        pending: &mut VecView<Branch<T, MEDIA>>,
        context: &Context<'_, 'a, T>,
        observer: &mut O,
    ) -> T {
        let split = meeting.split::<EFFECTS>(meeting.branch.channel);
        if split.is_total {
            observer.total_internal_reflection();
        }
        if let Some((direction, weight)) = split.reflected {
            let child = meeting.child::<EFFECTS>(RayKind::Reflected, direction, weight);
            self.spawn::<EFFECTS, O>(child, pending, context, observer);
        }
        if let Some((direction, weight)) = split.transmitted {
            let child = meeting.child::<EFFECTS>(RayKind::Transmitted, direction, weight);
            self.spawn::<EFFECTS, O>(child, pending, context, observer);
        }
        split.body
    }

    /// Spawns the children of a branch of all channels at a dispersive border: one transmitted branch for each channel, and
    /// one reflected branch for all of them. This one, which can be dispersed again, is followed after the others: so there
    /// are never more than two branches for other channels aside.
    fn disperse<const EFFECTS: u64, O: Observer>(
        &mut self,
        meeting: &Meeting<'_, T, MEDIA>,
        pending: &mut VecView<Branch<T, MEDIA>>,
        context: &Context<'_, 'a, T>,
        observer: &mut O,
    ) {
        let splits = meeting.split_channels::<EFFECTS>();
        if splits.iter().all(|(_, split)| split.is_total) {
            observer.total_internal_reflection();
        }
        if let Some((direction, weight)) = reflected(&splits) {
            let child = meeting.child::<EFFECTS>(RayKind::Reflected, direction, weight);
            self.spawn::<EFFECTS, O>(child, pending, context, observer);
        }
        for (channel, split) in &splits {
            let Some((direction, weight)) = split.transmitted else { continue };
            let child = meeting.child::<EFFECTS>(RayKind::Transmitted, direction, channel.of(weight));
            // What was current so far waits below the new one.
            let before = self.current.take();
            self.spawn::<EFFECTS, O>(Branch { channel: Some(*channel), ..child }, pending, context, observer);
            if let Some(before) = before {
                match self.current {
                    Some(_) => self.put_aside::<EFFECTS, O>(before, pending, context, observer),
                    None => self.current = Some(before),
                }
            }
        }
    }

    /// Takes a branch into the walk, unless it weighs nothing or the budget cuts it.
    fn spawn<const EFFECTS: u64, O: Observer>(
        &mut self,
        branch: Branch<T, MEDIA>,
        pending: &mut VecView<Branch<T, MEDIA>>,
        context: &Context<'_, 'a, T>,
        observer: &mut O,
    ) {
        let weight = branch.throughput.max_channel();
        if weight <= T::ZERO {
            return;
        }
        let too_deep = branch.depth > context.budget.depth.min(MOST_BOUNCES);
        if too_deep || weight < context.budget.cutoff {
            let reason = if too_deep { Cut::Depth } else { Cut::Cutoff };
            self.cut::<EFFECTS, O>(context, &branch, reason, observer);
        } else if self.current.is_none() {
            self.current = Some(branch);
        } else {
            self.put_aside::<EFFECTS, O>(branch, pending, context, observer);
        }
    }

    /// There is room whenever the depth is within what the stack was made for.
    fn put_aside<const EFFECTS: u64, O: Observer>(
        &mut self,
        branch: Branch<T, MEDIA>,
        pending: &mut VecView<Branch<T, MEDIA>>,
        context: &Context<'_, 'a, T>,
        observer: &mut O,
    ) {
        if let Err(branch) = pending.push(branch) {
            self.cut::<EFFECTS, O>(context, &branch, Cut::Depth, observer);
        }
    }

    /// Puts the termination colour in the place of a branch.
    fn cut<const EFFECTS: u64, O: Observer>(
        &mut self,
        context: &Context<'_, 'a, T>,
        branch: &Branch<T, MEDIA>,
        reason: Cut,
        observer: &mut O,
    ) {
        observer.cut(reason, branch.throughput.map(T::to_f32));
        let color = match context.budget.termination {
            Termination::Background => background::<T, EFFECTS>(context.scene, branch.ray.direction),
            Termination::Black => return,
            Termination::Color(color) => color,
        };
        self.gathered.gather(branch.throughput, color);
    }
}
