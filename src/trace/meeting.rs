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
    /// Seen from where the branch comes from.
    pub surface: &'s Surface<T>,
    pub border: &'s Border<T, MEDIA>,
    pub fresnel: Fresnel,
}

impl<T: Real, const MEDIA: usize> Meeting<'_, T, MEDIA> {
    /// Where light goes that has only this channel, or all of them.
    pub(super) fn split<const EFFECTS: u64>(&self, channel: Option<Channel>) -> Split<T> {
        let facing = Facing { surface: self.surface, incident: self.branch.ray.direction, depth: self.branch.depth };
        let n1 = self.border.before.at(channel);
        let n2 = self.border.behind.map_or(n1, |behind| behind.at(channel));
        facing.split::<EFFECTS>(&self.material.interface, self.fresnel, n1, n2)
    }

    /// The reflected or the transmitted branch.
    pub(super) fn child<const EFFECTS: u64>(
        &self,
        kind: RayKind,
        direction: Vec3<T>,
        weight: Rgb<T>,
    ) -> Branch<T, MEDIA> {
        let weight = match &self.material.balance {
            Some(balance) if Effects::from_bits(EFFECTS).has(Effects::BALANCE) => {
                weight * (balance.brightness * balance.ratio)
            }
            _ => weight,
        };
        let reflected = kind == RayKind::Reflected;
        Branch {
            ray: self.surface.leave(direction, reflected),
            throughput: self.branch.throughput * weight,
            media: if reflected { self.branch.media } else { self.border.media },
            depth: self.branch.depth.saturating_add(1),
            passed: 0,
            kind,
            channel: self.branch.channel,
        }
    }

    /// Where light of each channel goes.
    pub(super) fn split_channels<const EFFECTS: u64>(&self) -> [(Channel, Split<T>); 3] {
        Channel::ALL.map(|channel| (channel, self.split::<EFFECTS>(Some(channel))))
    }
}

/// The direction and weight of the reflected branches of all channels, which go the same way.
pub(super) fn reflected<T: Real>(splits: &[(Channel, Split<T>); 3]) -> Option<(Vec3<T>, Rgb<T>)> {
    splits.iter().fold(None, |sum: Option<(Vec3<T>, Rgb<T>)>, (channel, split)| {
        let (direction, weight) = split.reflected?;
        let before = sum.map_or(Rgb::BLACK, |(_, weight)| weight);
        Some((direction, before + channel.of(weight)))
    })
}
