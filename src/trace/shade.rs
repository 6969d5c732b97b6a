//! The light that a surface point sends towards the eye by itself: Blinn-Phong over the visible lights.

use super::bent_light::BentLight;
use super::illumination::illuminate;
use super::media::Media;
use super::shadow::{Share, light_share};
use super::{Branch, Context, Observer, RayKind, Sequence};
use crate::intersect::Surface;
use crate::math::{Real, Rgb, Vec3};
use crate::optics::reflect;
use crate::path::has_bent_shadows;
use crate::scene::{Body, Effects, Exponent, Highlight, Lobe, Material, Pattern};

/// A surface point whose lights are being looked at. It can be left between two shadow rays and taken up again.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shading<'a, T, const MEDIA: usize> {
    material: &'a Material<T>,
    /// Where shadow rays start, on the viewer's side.
    origin: Vec3<T>,
    /// Geometric and shading normal on the viewer's side.
    geometric: Vec3<T>,
    normal: Vec3<T>,
    /// Direction of the ray that came.
    incident: Vec3<T>,
    /// Colour of the body at the point.
    color: Rgb<T>,
    throughput: Rgb<T>,
    /// What the viewer's side of the point lies in.
    media: Media<MEDIA>,
    /// Depth of the branch.
    depth: u8,
    /// The light that is next.
    light: usize,
}

impl<'a, T: Real, const MEDIA: usize> Shading<'a, T, MEDIA> {
    /// `branch` met the surface from outside; `body` is the share of the light that gets through to the body. `None`
    /// when the material has nothing to be lit.
    pub(super) fn new<const EFFECTS: u64>(
        material: &'a Material<T>,
        surface: &Surface<T>,
        branch: &Branch<T, MEDIA>,
        body: T,
    ) -> Option<Self> {
        let effects = const { Effects::from_bits(EFFECTS) };
        let lit = (effects.has(Effects::BODY) && material.body.is_some())
            || (effects.has(HIGHLIGHTS) && material.highlight.is_some());
        if !lit {
            return None;
        }
        let color = match &material.body {
            Some(Body { color, .. }) if effects.has(Effects::BODY) => {
                let color = color_at::<T, EFFECTS>(color, surface.point);
                if effects.has(Effects::COAT) { color * body } else { color }
            }
            _ => Rgb::BLACK,
        };
        let throughput = match &material.balance {
            Some(balance) if effects.has(Effects::BALANCE) => {
                branch.throughput * (balance.brightness * (T::ONE - balance.ratio).max(T::ZERO))
            }
            _ => branch.throughput,
        };
        Some(Self {
            material,
            origin: surface.point + surface.offset,
            geometric: surface.normal,
            normal: surface.shading::<EFFECTS>(),
            incident: branch.ray.direction,
            color,
            throughput,
            media: branch.media,
            depth: branch.depth,
            light: 0,
        })
    }

    /// The light the body gives off without any light.
    pub(crate) fn emitted<const EFFECTS: u64>(&self) -> Rgb<T> {
        match &self.material.body {
            Some(body) if Effects::from_bits(EFFECTS).has(Effects::BODY) => {
                (self.throughput * self.color).held_product(Rgb::grey(body.emission))
            }
            _ => Rgb::BLACK,
        }
    }

    /// Looks at the lights, one shadow ray each, until all are done or `rays` is used up; `true` when all are done.
    ///
    /// `rays_left` is what is left of the budget. It pays for a shadow ray to each light; what it has beyond that pays for
    /// the surfaces that shadow rays go straight through.
    pub(crate) fn advance<const EFFECTS: u64, O: Observer>(
        &mut self,
        &Context { scene, samples, budget }: &Context<'_, 'a, T>,
        gathered: &mut Rgb<T>,
        rays: &mut u32,
        rays_left: &mut u32,
        observer: &mut O,
    ) -> bool {
        let is_bent = has_bent_shadows::<T, EFFECTS>(scene);
        for light in scene.lights.iter().skip(self.light) {
            // A bent path is not looked for only to be looked for again.
            if is_bent && *rays == 0 {
                return false;
            }
            let sample = || {
                let count = scene.lights.len() as u32;
                samples.point(Sequence::light(u32::from(self.depth), self.light as u32, count))
            };
            // Bent light may come from the other side.
            let normal = if is_bent { None } else { Some(self.normal) };
            let straight = illuminate::<T, EFFECTS>(light, self.origin, normal, sample);
            let mut bent = BentLight::new(budget);
            let arriving = if is_bent {
                straight.and_then(|light| bent.aim::<EFFECTS>(scene, self.media.medium(scene).index, light))
            } else {
                straight
            };
            if let Some(arriving) = arriving {
                let sent = arriving.color.held_product(self.response::<EFFECTS>(arriving.ray.direction));
                let sum = sent.r.plus(sent.g).plus(sent.b);
                if sum > T::ZERO {
                    // Huge lights may overflow, and what nothing of them gets through must still be black.
                    let sent = if sum > T::MAX { sent.min(Rgb::grey(T::MAX)) } else { sent };
                    if *rays == 0 {
                        return false;
                    }
                    observer.ray(RayKind::Shadow);
                    let lights_left = scene.lights.len().saturating_sub(self.light) as u32;
                    let most = rays_left.saturating_sub(lights_left);
                    let Share { light, passed } = if bent.is_hidden::<EFFECTS>(scene) {
                        Share::NOTHING
                    } else {
                        light_share::<T, EFFECTS, MEDIA, O>(scene, &self.media, &arriving, most, observer)
                    };
                    *rays = rays.saturating_sub(1 + passed);
                    *rays_left = rays_left.saturating_sub(1 + passed);
                    if let Some(share) = light {
                        *gathered += self.throughput.held_product(sent * share);
                    }
                }
            }
            if is_bent {
                *rays = rays.saturating_sub(
                    bent.report(self.throughput * (T::ONE / T::from_u32(scene.lights.len() as u32)), observer),
                );
            }
            self.light += 1;
        }
        true
    }

    /// The share of the light from direction `towards` that goes back along the incident ray.
    fn response<const EFFECTS: u64>(&self, towards: Vec3<T>) -> Rgb<T> {
        let effects = const { Effects::from_bits(EFFECTS) };
        let cosine = self.normal.dot(towards);
        let behind = effects.has(Effects::SMOOTH_TRIANGLE) && self.geometric.dot(towards) <= T::ZERO;
        if cosine <= T::ZERO || behind {
            return Rgb::BLACK;
        }
        let mut response = Rgb::BLACK;
        if let (Some(body), true) = (&self.material.body, effects.has(Effects::BODY)) {
            response = self.color * (body.ambient + body.diffuse * cosine);
        }
        if let (Some(highlight), true) = (&self.material.highlight, effects.has(HIGHLIGHTS)) {
            response += highlight.color * self.highlight::<EFFECTS>(highlight, towards);
        }
        response
    }

    fn highlight<const EFFECTS: u64>(&self, highlight: &Highlight<T>, towards: Vec3<T>) -> T {
        let effects = const { Effects::from_bits(EFFECTS) };
        let blinn = !effects.has(Effects::PHONG) || (highlight.lobe == Lobe::Blinn && effects.has(Effects::BLINN));
        let cosine = if blinn {
            self.normal.dot((towards - self.incident).normalized())
        } else {
            reflect(self.incident, self.normal, -self.incident.dot(self.normal)).dot(towards)
        };
        // Rounding can take a cosine past 1, where a high power would blow it up.
        let cosine = cosine.min(T::ONE);
        if cosine <= T::ZERO {
            return T::ZERO;
        }
        match highlight.exponent {
            Exponent::Integer(n) if effects.has(Effects::INTEGER_EXPONENT) => cosine.powi(n),
            Exponent::Real(s) if effects.has(Effects::REAL_EXPONENT) => cosine.powf(s),
            _ => T::ZERO,
        }
    }
}

const HIGHLIGHTS: Effects = Effects::BLINN.with(Effects::PHONG);

/// The colour of a pattern at a point.
fn color_at<T: Real, const EFFECTS: u64>(pattern: &Pattern<T>, point: Vec3<T>) -> Rgb<T> {
    let effects = const { Effects::from_bits(EFFECTS) };
    match *pattern {
        Pattern::Solid(color) => color,
        Pattern::Checker { even, odd, u, v } if effects.has(Effects::CHECKER) => {
            let cell = |axis: Vec3<T>| T::held(point.products(axis)).floor();
            if cell(u).plus(cell(v)).is_even() { even } else { odd }
        }
        Pattern::Gradient { from, to, origin, axis } if effects.has(Effects::GRADIENT) => {
            from.mix(to, T::held((point - origin).products(axis)).max(T::ZERO).min(T::ONE))
        }
        Pattern::Rings { even, odd, center, width } if effects.has(Effects::RINGS) => {
            if ((point - center).length() / width).floor().is_even() { even } else { odd }
        }
        _ => Rgb::BLACK,
    }
}

/// Where a sample's random numbers come from: the pixel's sequence and the number of the sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Samples {
    pub sequence: Sequence,
    pub index: u32,
}

impl Samples {
    pub(crate) fn point<T: Real>(&self, dimension: u32) -> [T; 2] {
        self.sequence.point(self.index, dimension)
    }
}
