//! What bends light, and what is seen of it. It is chosen last, and changes what was chosen before.

use whit::scene::{BlackHole, Index, Medium, Profile, ShadowRays, Steps};
use whit::{Background, Interface, Pattern, Settings};

use super::Source;
use super::objects::Thing;
use super::span::{AMOUNT, MASS, POSITIVE, SHARE_OF_WAY, STAR, TOLERANCE};

/// What bends light.
#[derive(Clone, Debug)]
pub struct Bending {
    pub profiles: Vec<Profile<'static, f32>>,
    pub black_hole: Option<BlackHole<f32>>,
    pub shadow_rays: ShadowRays,
}

impl Bending {
    pub fn random(source: &mut Source<'_>, settings: &mut Settings<f32>) -> Self {
        let profiles = source.profiles();
        let black_hole = if source.is_wild || profiles.is_empty() { source.black_hole() } else { None };
        if !profiles.is_empty() || black_hole.is_some() {
            settings.budget.steps_per_ray = source.pick(&[200, 1000, 50, 1, 0, 7, 3000], 200);
        }
        Self {
            profiles,
            black_hole,
            shadow_rays: source.pick(&[ShadowRays::Straight, ShadowRays::Bent], ShadowRays::Bent),
        }
    }

    /// Makes a medium name a profile, perhaps.
    pub fn medium(&self, source: &mut Source<'_>, medium: &mut Medium<f32>) {
        let count = self.profiles.len() + usize::from(source.is_wild);
        if count > 0 && source.once_in(2) {
            medium.index = Index::Profile(source.below(count) as u8);
        }
    }

    pub fn thing(&self, source: &mut Source<'_>, thing: &mut Thing) {
        if let Interface::Constant { medium, .. } | Interface::Dielectric { medium, .. } = &mut thing.material.interface
        {
            self.medium(source, medium);
        }
        if source.once_in(6) {
            thing.form = source.annulus();
        }
        if let (Some(body), true) = (&mut thing.material.body, source.once_in(4)) {
            let (even, odd) = (source.color(), source.color());
            body.color = Pattern::Rings { even, odd, center: source.point(), width: source.size(POSITIVE) };
        }
    }
}

impl Source<'_> {
    fn black_hole(&mut self) -> Option<BlackHole<f32>> {
        if !self.once_in(4) {
            return None;
        }
        let steps = match self.below(2) {
            0 => Steps::Fixed { length: self.number(SHARE_OF_WAY) },
            _ => Steps::Controlled { tolerance: self.number(TOLERANCE) },
        };
        let mass = self.size(MASS) * 0.125;
        Some(BlackHole { center: self.point(), mass: if self.is_wild { mass } else { MASS.fit(mass) }, steps })
    }

    pub fn stars(&mut self, otherwise: Background<f32>) -> Background<f32> {
        if !self.once_in(4) {
            return otherwise;
        }
        Background::Stars {
            sky: self.color(),
            brightness: self.number(AMOUNT),
            cells: self.pick(&[1, 2, 20, 1000, u16::MAX, if self.is_wild { 0 } else { 3 }], 1),
            radius: self.number(STAR),
        }
    }
}
