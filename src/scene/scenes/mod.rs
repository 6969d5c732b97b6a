//! Built-in scenes: constants that fit into flash. One that is not used is not in the binary.

mod bubble;
mod card;
mod deep;
mod flake;
mod glass;
mod hole;
mod lenses;
mod metals;
mod mirage;
mod mirrors;
mod oil;
mod prism;
mod ship;
mod showcase;
mod spheres;
mod sunset;
mod tints;
mod titanium;
mod window;

pub use bubble::BUBBLE;
pub use card::CARD;
pub use deep::DEEP;
pub use flake::{FLAKE, flake_spheres};
pub use glass::GLASS;
pub use hole::HOLE;
pub use lenses::LENSES;
pub use metals::METALS;
pub use mirage::MIRAGE;
pub use mirrors::MIRRORS;
pub use oil::OIL;
pub use prism::PRISM;
pub use ship::SHIP;
pub use showcase::SHOWCASE;
pub use spheres::SPHERES;
pub use sunset::SUNSET;
pub use tints::TINTS;
pub use titanium::TITANIUM;
pub use window::WINDOW;

use super::{Pattern, Scene};
use crate::math::{Rgb, Vec3};

/// All built-in scenes by name.
pub const ALL: [(&str, Scene<'static, f32>); 19] = [
    ("showcase", SHOWCASE),
    ("spheres", SPHERES),
    ("mirrors", MIRRORS),
    ("flake", FLAKE),
    ("card", CARD),
    ("metals", METALS),
    ("window", WINDOW),
    ("glass", GLASS),
    ("deep", DEEP),
    ("tints", TINTS),
    ("bubble", BUBBLE),
    ("oil", OIL),
    ("titanium", TITANIUM),
    ("prism", PRISM),
    ("mirage", MIRAGE),
    ("ship", SHIP),
    ("sunset", SUNSET),
    ("lenses", LENSES),
    ("hole", HOLE),
];

/// Upwards in the scenes of this crate's own; y is up.
const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);

/// A horizontal floor of squares.
const fn checker(even: Rgb<f32>, odd: Rgb<f32>, side: f32) -> Pattern<f32> {
    Pattern::Checker { even, odd, u: Vec3::new(1.0 / side, 0.0, 0.0), v: Vec3::new(0.0, 0.0, 1.0 / side) }
}
