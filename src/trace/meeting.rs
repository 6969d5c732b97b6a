//! A branch of light at a surface, and the branches that come of it.

use super::Branch;
use super::media::Border;
use super::observer::RayKind;
use super::split::{Facing, Split};
use crate::intersect::Surface;
use crate::math::{Real, Rgb, Vec3};
use crate::scene::{Channel, Effects, Fresnel, Material};

/// A branch of light at a surface.
pub(super) struct Meeting<'s, T, const MEDIA: usize> {
    pub branch: &'s Branch<T, MEDIA>,
    pub material: &'s Material<T>,
    pub surface: &'s Surface<T>,
    /// Whether the branch comes from outside.
    pub front: bool,
    pub border: &'s Border<T, MEDIA>,
    pub fresnel: Fresnel,
}

/// A branch that comes of another, where there is one.
type Child<T, const MEDIA: usize> = Option<Branch<T, MEDIA>>;

impl<T: Real, const MEDIA: usize> Meeting<'_, T, MEDIA> {
    /// Where light goes that has only this channel, or all of them.
    pub(super) fn split<const EFFECTS: u64>(&self, channel: Option<Channel>) -> Split<T> {
        let facing = Facing::new(self.surface, self.front, self.branch.ray.direction, self.branch.depth);
        let n1 = self.border.before.at(channel);
        let n2 = self.border.behind.map_or(n1, |behind| behind.at(channel));
        facing.split::<EFFECTS>(&self.material.interface, self.fresnel, n1, n2)
    }

    /// The reflected branch.
    pub(super) fn reflected<const EFFECTS: u64>(&self, branch: Option<(Vec3<T>, Rgb<T>)>) -> Child<T, MEDIA> {
        let child = self.child::<EFFECTS>(branch?, self.front);
        Some(Branch { kind: RayKind::Reflected, ..child })
    }

    /// The transmitted branch.
    pub(super) fn transmitted<const EFFECTS: u64>(&self, branch: Option<(Vec3<T>, Rgb<T>)>) -> Child<T, MEDIA> {
        let child = self.child::<EFFECTS>(branch?, !self.front);
        Some(Branch { kind: RayKind::Transmitted, media: self.border.media, ..child })
    }

    fn child<const EFFECTS: u64>(&self, (direction, weight): (Vec3<T>, Rgb<T>), outside: bool) -> Branch<T, MEDIA> {
        let weight = match &self.material.balance {
            Some(balance) if Effects::from_bits(EFFECTS).has(Effects::BALANCE) => {
                weight * (balance.brightness * balance.ratio)
            }
            _ => weight,
        };
        Branch {
            ray: self.surface.leave(direction, outside),
            throughput: self.branch.throughput * weight,
            depth: self.branch.depth.saturating_add(1),
            passed: 0,
            ..*self.branch
        }
    }

    /// The children of a branch of all channels at a dispersive border: one transmitted branch for each channel, after
    /// one reflected branch for all of them; and whether all of the light is reflected.
    pub(super) fn disperse<const EFFECTS: u64>(&self) -> ([Child<T, MEDIA>; 4], bool) {
        let splits = Channel::ALL.map(|channel| (channel, self.split::<EFFECTS>(Some(channel))));
        let reflected = splits.iter().fold(None, |sum: Option<(Vec3<T>, Rgb<T>)>, (channel, split)| {
            let (direction, weight) = split.reflected?;
            let before = sum.map_or(Rgb::BLACK, |(_, weight)| weight);
            Some((direction, before + channel.of(weight)))
        });
        let [red, green, blue] = splits.each_ref().map(|(channel, split)| {
            let (direction, weight) = split.transmitted?;
            let child = self.transmitted::<EFFECTS>(Some((direction, channel.of(weight))))?;
            Some(Branch { channel: Some(*channel), ..child })
        });
        let is_total = splits.iter().all(|(_, split)| split.is_total);
        ([self.reflected::<EFFECTS>(reflected), red, green, blue], is_total)
    }
}
