//! How far a picture is from the reference, in linear values.

use std::fmt;

/// The difference between two pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Root of the mean square over all channels of all pixels.
    pub rmse: f64,
    /// The same without the pixels that are off by more than 1/255: edges, which `f32` and `f64` see on different sides
    /// of a pixel's middle.
    pub rmse_without_edges: f64,
    /// The largest one of any channel; infinite where a value is not a number.
    pub max: f64,
    /// The share of pixels with a channel off by more than 1/255.
    pub share_over_1_255: f64,
    /// The place of the pixel with the largest one.
    pub worst: usize,
}

impl Difference {
    /// # Panics
    /// When the pictures do not have the same number of pixels.
    pub fn between<A: Into<f64> + Copy>(picture: &[[A; 3]], reference: &[[f64; 3]]) -> Self {
        assert_eq!(picture.len(), reference.len(), "pictures of different sizes");
        let mut difference = Self { rmse: 0.0, rmse_without_edges: 0.0, max: 0.0, share_over_1_255: 0.0, worst: 0 };
        for (i, off) in differences(picture, reference).enumerate() {
            let squares = off.iter().map(|off| off * off).sum::<f64>();
            difference.rmse += squares;
            let largest = off.iter().copied().fold(0.0, f64::max);
            if largest > difference.max {
                difference.max = largest;
                difference.worst = i;
            }
            if largest > 1.0 / 255.0 {
                difference.share_over_1_255 += 1.0;
            } else {
                difference.rmse_without_edges += squares;
            }
        }
        let pixels = reference.len().max(1) as f64;
        difference.rmse = (difference.rmse / (3.0 * pixels)).sqrt();
        let kept = (pixels - difference.share_over_1_255).max(1.0);
        difference.rmse_without_edges = (difference.rmse_without_edges / (3.0 * kept)).sqrt();
        difference.share_over_1_255 /= pixels;
        difference
    }
}

/// The share of pixels with a channel off by more than `tolerance`.
pub fn share_over<A: Into<f64> + Copy>(tolerance: f64, picture: &[[A; 3]], reference: &[[f64; 3]]) -> f64 {
    let over = differences(picture, reference).filter(|off| off.iter().any(|off| *off > tolerance)).count();
    over as f64 / reference.len().max(1) as f64
}

/// Per pixel and channel, without sign; infinite where a value is not a number.
fn differences<A: Into<f64> + Copy>(picture: &[[A; 3]], reference: &[[f64; 3]]) -> impl Iterator<Item = [f64; 3]> {
    picture.iter().zip(reference).map(|(&[r, g, b], &[s, h, c])| {
        [r.into() - s, g.into() - h, b.into() - c].map(|off: f64| if off.is_nan() { f64::INFINITY } else { off.abs() })
    })
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "RMSE {:.3e}, without edges {:.3e}, maximum {:.3e} at pixel {}, {:.3} % of the pixels off by more than 1/255",
            self.rmse,
            self.rmse_without_edges,
            self.max,
            self.worst,
            100.0 * self.share_over_1_255
        )
    }
}
