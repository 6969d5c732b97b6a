//! How far a picture is from another, as it is seen on a display.

use palette::color_difference::Ciede2000;
use palette::{IntoColor, Lab, LinSrgb, Srgb};
use whit::Rgb;
use whit::render::Encoding;

/// The difference of two pictures, in linear light from 0 to 1, which is all that a display shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Root of the mean square over all channels of all pixels.
    pub rmse: f64,
    /// The largest of any channel.
    pub max: f64,
    /// The share of pixels with a channel off by more than 1/255.
    pub share: f64,
    /// The mean colour difference by CIEDE2000.
    pub delta_e: f64,
    /// The largest one.
    pub delta_e_max: f64,
}

impl Difference {
    /// The difference of two pictures of one size in linear light ([`shown`]).
    pub fn between(picture: &[LinSrgb<f64>], reference: &[LinSrgb<f64>]) -> Self {
        let mut sum = Self::default();
        for (&a, &b) in picture.iter().zip(reference) {
            let off = [a.red - b.red, a.green - b.green, a.blue - b.blue].map(f64::abs);
            let largest = off.into_iter().fold(0.0, f64::max);
            let delta_e = if a == b { 0.0 } else { lab(a).difference(lab(b)) };
            sum.rmse += off.iter().map(|off| off * off).sum::<f64>();
            sum.max = sum.max.max(largest);
            sum.share += f64::from(u8::from(largest > 1.0 / 255.0));
            sum.delta_e += delta_e;
            sum.delta_e_max = sum.delta_e_max.max(delta_e);
        }
        let pixels = reference.len().max(1) as f64;
        Self {
            rmse: (sum.rmse / (3.0 * pixels)).sqrt(),
            share: sum.share / pixels,
            delta_e: sum.delta_e / pixels,
            ..sum
        }
    }
}

fn lab(color: LinSrgb<f64>) -> Lab<palette::white_point::D65, f64> {
    color.into_color()
}

/// The light that a display shows for a pixel.
pub fn shown(pixel: Rgb<f64>, encoding: Encoding) -> LinSrgb<f64> {
    let [r, g, b] = [pixel.r, pixel.g, pixel.b].map(|channel| channel.clamp(0.0, 1.0));
    match encoding {
        Encoding::Srgb => LinSrgb::new(r, g, b),
        Encoding::Display => Srgb::new(r, g, b).into_linear(),
    }
}
