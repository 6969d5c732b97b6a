//! Eye rays.

use crate::intersect::Ray;
use crate::math::{Real, Vec3};
use crate::render::Size;
use crate::scene::{Aperture, Camera, Effects, Extent, Lens};
use crate::trace::concentric;

/// A camera in front of a picture of a given size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View<T: Real> {
    eye: Vec3<T>,
    forward: Vec3<T>,
    /// Unit vectors in the picture.
    right: Vec3<T>,
    up: Vec3<T>,
    /// Half the size of the picture in pixels.
    center: (T, T),
    /// The side of a pixel, at distance 1.
    scale: T::Wide,
    lens: Option<Lens<T>>,
}

impl<T: Real> View<T> {
    pub(crate) fn new(camera: &Camera<T>, size: Size) -> Self {
        let forward = (camera.target - camera.eye).normalized();
        let right = T::unit_of_sums(forward.cross_products(camera.up)).unwrap_or(Vec3::ZERO);
        let spanned = match camera.extent {
            Extent::PixelEdges => size.height,
            Extent::PixelCentres => (size.height.saturating_sub(1)).max(1),
        };
        Self {
            eye: camera.eye,
            forward,
            right,
            up: right.cross(forward),
            center: (T::from_u32(size.width) * T::HALF, T::from_u32(size.height) * T::HALF),
            scale: T::factor(camera.half_height + camera.half_height, spanned),
            lens: camera.lens,
        }
    }

    /// The ray through a point of the picture, in pixels from its upper left corner.
    #[inline]
    pub(crate) fn ray<const EFFECTS: u64>(&self, x: T, y: T, lens_sample: impl FnOnce() -> [T; 2]) -> Ray<T> {
        let right = (x - self.center.0).scaled(self.scale);
        let up = (self.center.1 - y).scaled(self.scale);
        let (mut origin, mut towards) = (self.eye, self.forward + self.right * right + self.up * up);
        if let (Some(lens), true) = (&self.lens, Effects::from_bits(EFFECTS).has(Effects::LENS)) {
            let (a, b) = aperture_point::<T, EFFECTS>(&lens.aperture, lens_sample());
            let offset = self.right * a + self.up * b;
            // To the point in focus, in units in which neither part of the way is long.
            let longest = lens.focus.max(a.abs()).max(b.abs());
            towards = if T::IS_FIXED {
                // The inverse of what is long has no digits.
                towards * (lens.focus / longest) - offset.map(|x| x / longest)
            } else {
                let unit = T::ONE / longest;
                towards * (lens.focus * unit) - offset * unit
            };
            origin += offset;
        }
        Ray { origin, direction: towards.normalized() }
    }
}

/// A disc that the tracer leaves out is a point.
fn aperture_point<T: Real, const EFFECTS: u64>(aperture: &Aperture<T>, [s, t]: [T; 2]) -> (T, T) {
    match *aperture {
        Aperture::Disc { radius } if Effects::from_bits(EFFECTS).has(Effects::DISC_APERTURE) => {
            let (x, y) = concentric([s, t]);
            (x * radius, y * radius)
        }
        Aperture::Disc { .. } => (T::ZERO, T::ZERO),
        Aperture::Square { side } => ((s - T::HALF) * side, (t - T::HALF) * side),
    }
}
