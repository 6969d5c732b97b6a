//! Scenes that other ray tracers for microcontrollers are measured by.

mod ftb;
mod raystones;

use whit::render::Settings;
use whit::trace::{Budget, Termination};
use whit::{Material, Rgb, Scene, scenes};

/// A scene and how its own program renders it.
#[derive(Clone, Copy)]
pub struct Peer {
    pub name: &'static str,
    pub scene: Scene<'static, f32>,
    /// Width and height.
    pub size: [u32; 2],
    /// Bounces.
    pub depth: u8,
    /// What a branch is that would go deeper.
    pub termination: Termination<f32>,
}

/// All of them.
pub const ALL: [Peer; 3] = [
    // The original goes as deep as it takes, which is 15 bounces at its own size.
    Peer { name: "card", scene: scenes::CARD, size: [64, 64], depth: 15, termination: Termination::Background },
    raystones::RAYSTONES,
    ftb::FTB,
];

impl Peer {
    /// One sample a pixel, of branches that weigh no less than the cutoff.
    pub fn settings(&self, cutoff: f32) -> Settings<f32> {
        let budget = Budget { cutoff, termination: self.termination, ..Budget::with_depth(self.depth) };
        Settings { budget, ..Settings::new(self.size[0], self.size[1]) }
    }
}

/// The same material with a highlight around the mirrored direction of view.
const fn with_phong(material: Material<f32>, strength: f32, exponent: u32) -> Material<f32> {
    let highlight = whit::scene::Highlight {
        color: Rgb::grey(strength),
        lobe: whit::scene::Lobe::Phong,
        exponent: whit::scene::Exponent::Integer(exponent),
    };
    Material { highlight: Some(highlight), ..material }
}
