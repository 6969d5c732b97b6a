//! From the value of a pixel to the 8 bits that a display takes.

use crate::math::Rgb;
use crate::scene::{Scene, Tone};

/// How the value of a pixel becomes the value that a display takes.
///
/// ```
/// use whit::Rgb;
/// use whit::render::Encoding;
/// // Half of the light is far above half of the scale: the eye tells dark greys apart better than light ones.
/// assert_eq!(Encoding::Srgb.encode8(Rgb::grey(0.5)), [188, 188, 188]);
/// assert_eq!(Encoding::Display.encode8(Rgb::new(0.0, 0.5, 2.0)), [0, 128, 255]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Pixels hold linear light; it is encoded by the transfer function of sRGB (IEC 61966-2-1).
    Srgb,
    /// Pixels hold what the display shows, from 0 to 1; it is only rounded.
    Display,
}

impl Encoding {
    /// The encoding that the scene's [`Tone`] asks for.
    #[must_use]
    pub fn of<T>(scene: &Scene<'_, T>) -> Self {
        Self::from(&scene.tone)
    }

    /// The nearest 8-bit value of each channel. Below 0 and NaN is 0, above 1 is 255.
    #[inline]
    #[must_use]
    pub fn encode8(self, color: Rgb<f32>) -> [u8; 3] {
        let Rgb { r, g, b } = color;
        match self {
            Self::Srgb => [srgb8(r), srgb8(g), srgb8(b)],
            Self::Display => [display8(r), display8(g), display8(b)],
        }
    }

    /// The nearest 8-bit grey: with [`Srgb`](Self::Srgb), the encoded luminance of the light; with
    /// [`Display`](Self::Display), the luma of the encoded values. Both have the weights of Rec. 709.
    #[inline]
    #[must_use]
    pub fn grey8(self, color: Rgb<f32>) -> u8 {
        match self {
            Self::Srgb => srgb8(color.luminance()),
            Self::Display => display8(color.luminance()),
        }
    }
}

fn srgb8(light: f32) -> u8 {
    // There are 255 thresholds, so the count fits. No comparison with NaN holds: it passes none.
    SRGB_THRESHOLDS.partition_point(|&threshold| threshold <= light) as u8
}

#[inline]
fn display8(value: f32) -> u8 {
    // A cast from float to integer limits the value and makes NaN 0; to the larger integer it takes fewer instructions.
    ((value * 255.0 + 0.5) as u32).min(255) as u8
}

impl<T> From<&Tone<T>> for Encoding {
    fn from(tone: &Tone<T>) -> Self {
        match tone {
            Tone::Linear => Self::Srgb,
            Tone::Display { .. } => Self::Display,
        }
    }
}

/// Entry k is the least light whose encoded value is nearer to k + 1 than to k. Counting the thresholds that a value
/// has passed rounds correctly, and takes no power function at run time.
static SRGB_THRESHOLDS: [f32; 255] = srgb_thresholds();

#[allow(clippy::indexing_slicing)] // Runs in the compiler only, where a panic is an error message.
const fn srgb_thresholds() -> [f32; 255] {
    let mut thresholds = [0.0; 255];
    let mut k = 0;
    while k < thresholds.len() {
        thresholds[k] = rounded_up(srgb_decoded((k as f64 + 0.5) / 255.0));
        k += 1;
    }
    thresholds
}

/// The light of an encoded value from 0 to 1: the inverse of the transfer function in IEC 61966-2-1.
const fn srgb_decoded(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        return encoded / 12.92;
    }
    let base = (encoded + 0.055) / 1.055;
    // base^2.4
    base * base * fifth_root(base * base)
}

/// Newton's method for x⁵ = a, 0.008 < a <= 1. From 1 it approaches the root from above; 8 steps reach 0.38, the
/// least root, and some more do no harm.
const fn fifth_root(a: f64) -> f64 {
    let mut x = 1.0;
    let mut step = 0;
    while step < 16 {
        x = (4.0 * x + a / (x * x * x * x)) / 5.0;
        step += 1;
    }
    x
}

/// The least `f32` that is not below `x`, so that a comparison with it is a comparison with `x`.
const fn rounded_up(x: f64) -> f32 {
    let nearest = x as f32;
    if (nearest as f64) < x { nearest.next_up() } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::scene::{Background, Camera};

    /// The forward formula of IEC 61966-2-1 with libm's power function, which the table does not use.
    fn reference(light: f32) -> u8 {
        let light = f64::from(light);
        let encoded = if light <= 0.0031308 { 12.92 * light } else { 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055 };
        libm::round(encoded * 255.0) as u8
    }

    #[test]
    fn each_threshold_is_where_the_formula_steps() {
        for (threshold, k) in SRGB_THRESHOLDS.into_iter().zip(0u8..) {
            assert_eq!(reference(threshold.next_down()), k);
            assert_eq!(reference(threshold), k + 1);
        }
    }

    #[test]
    fn srgb_steps_at_each_threshold() {
        for (threshold, k) in SRGB_THRESHOLDS.into_iter().zip(0u8..) {
            assert_eq!(srgb8(threshold.next_down()), k);
            assert_eq!(srgb8(threshold), k + 1);
        }
    }

    #[test]
    fn values_out_of_range_are_limited() {
        for encoding in [Encoding::Srgb, Encoding::Display] {
            assert_eq!(encoding.encode8(Rgb::new(-0.0, -1.0, f32::NEG_INFINITY)), [0; 3], "{encoding:?}");
            assert_eq!(encoding.encode8(Rgb::new(1.0, 1.5, f32::INFINITY)), [255; 3], "{encoding:?}");
            assert_eq!(encoding.encode8(Rgb::new(f32::NAN, -f32::NAN, 1e-9)), [0; 3], "{encoding:?}");
            assert_eq!(encoding.grey8(Rgb::grey(f32::NAN)), 0, "{encoding:?}");
        }
    }

    #[test]
    fn display_values_are_rounded_to_nearest() {
        for k in 0..=255u8 {
            for offset in [-0.49, 0.0, 0.49] {
                assert_eq!(display8((f32::from(k) + offset) / 255.0), k);
            }
        }
    }

    /// 0.7152 of light is 0.8620 encoded (219.8 of 255); as luma it is 182.4 of 255.
    #[test]
    fn grey_is_luminance_in_the_space_of_the_pixels() {
        let green = Rgb::new(0.0, 1.0, 0.0);
        assert_eq!(Encoding::Srgb.grey8(green), 220);
        assert_eq!(Encoding::Display.grey8(green), 182);
    }

    #[test]
    fn white_is_white_in_grey() {
        assert_eq!(Encoding::Srgb.grey8(Rgb::WHITE), 255);
        assert_eq!(Encoding::Display.grey8(Rgb::WHITE), 255);
    }

    #[test]
    fn the_scene_says_which_encoding() {
        let camera = Camera::look_at(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0_f32);
        let mut scene = Scene::new(camera, Background::Solid(Rgb::BLACK));
        assert_eq!(Encoding::of(&scene), Encoding::Srgb);
        scene.tone = Tone::Display { gain: 0.8, lift: 0.1 };
        assert_eq!(Encoding::of(&scene), Encoding::Display);
    }
}
