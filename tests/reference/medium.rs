//! What fills the space on each side of a surface.

use whit::scene::{Channel, Index};

use super::complex::Complex;
use super::vector::Color;

/// A medium in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Index of refraction by channel.
    pub indices: [f64; 3],
    /// Whether the scene gives one for each channel, so that light is dispersed.
    pub dispersive: bool,
    /// Of Beer's law, per channel, in 1/scene unit.
    pub attenuation: Color,
}

impl Medium {
    /// A clear one of the same index for all light.
    pub const fn clear(index: f64) -> Self {
        Self { indices: [index; 3], dispersive: false, attenuation: Color::BLACK }
    }

    /// The index for light of one channel; for light of all of them that of green.
    pub fn index(&self, channel: Option<Channel>) -> f64 {
        self.indices[channel.map_or(1, place)]
    }

    /// The indices as what is behind a film.
    pub fn base(&self) -> [Complex; 3] {
        self.indices.map(Complex::from)
    }
}

impl From<whit::scene::Medium<f32>> for Medium {
    fn from(medium: whit::scene::Medium<f32>) -> Self {
        let Color(indices) = match medium.index {
            Index::Constant(n) => Color::grey(n.into()),
            Index::Dispersive(n) => n.into(),
            // Only its place tells.
            Index::Profile(_) => Color::grey(f64::NAN),
        };
        Self {
            indices,
            dispersive: matches!(medium.index, Index::Dispersive(_)),
            attenuation: medium.attenuation.map_or(Color::BLACK, Color::from),
        }
    }
}

/// The media in front of a surface and behind it, as the ray comes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border {
    pub front: Medium,
    pub behind: Medium,
}

impl Border {
    /// How a branch of light is divided here: into its channels where it is dispersed.
    pub fn channels(&self, channel: Option<Channel>) -> Vec<Option<Channel>> {
        if channel.is_none() && (self.front.dispersive || self.behind.dispersive) {
            Channel::ALL.map(Some).to_vec()
        } else {
            vec![channel]
        }
    }
}

/// White without the other channels; white for light of all of them.
pub fn mask(channel: Option<Channel>) -> Color {
    let Some(channel) = channel else { return Color::WHITE };
    let mut color = Color::BLACK;
    color.0[place(channel)] = 1.0;
    color
}

fn place(channel: Channel) -> usize {
    match channel {
        Channel::Red => 0,
        Channel::Green => 1,
        Channel::Blue => 2,
    }
}
