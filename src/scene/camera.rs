//! The eye of a picture.

use crate::math::{Real, Vec3, tangent_of_degrees};

/// A look-at camera: a pinhole, or a thin lens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<T> {
    /// Where it is.
    pub eye: Vec3<T>,
    /// What it looks at: the middle of the picture.
    pub target: Vec3<T>,
    /// Which way is up in the picture: any direction that is not the line of sight.
    pub up: Vec3<T>,
    /// The tangent of half the vertical field of view.
    pub half_height: T,
    /// What the field of view reaches to.
    pub extent: Extent,
    /// Depth of field; without a lens everything is sharp.
    pub lens: Option<Lens<T>>,
}

/// What the vertical field of view reaches to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// From the upper edge of the first row of pixels to the lower edge of the last.
    PixelEdges,
    /// From the centres of the first row to the centres of the last, as in Neutral File Format.
    PixelCentres,
}

/// A thin lens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens<T> {
    /// Its opening.
    pub aperture: Aperture<T>,
    /// Distance of the plane in focus, along the line of sight.
    pub focus: T,
}

/// The opening of a lens, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aperture<T> {
    /// A disc.
    Disc {
        /// Its radius.
        radius: T,
    },
    /// A square, upright in the picture.
    Square {
        /// Its side.
        side: T,
    },
}

impl<T: Real> Camera<T> {
    /// A pinhole camera with the tangent of half its vertical field of view.
    pub const fn with_half_height(eye: Vec3<T>, target: Vec3<T>, up: Vec3<T>, half_height: T) -> Self {
        Self { eye, target, up, half_height, extent: Extent::PixelEdges, lens: None }
    }

    /// The same camera with a lens.
    #[must_use]
    pub const fn with_lens(self, lens: Lens<T>) -> Self {
        Self { lens: Some(lens), ..self }
    }

    /// The same camera in another number type.
    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U) -> Camera<U> {
        Camera {
            eye: self.eye.map(&f),
            target: self.target.map(&f),
            up: self.up.map(&f),
            half_height: f(self.half_height),
            extent: self.extent,
            lens: self.lens.map(|lens| Lens {
                aperture: match lens.aperture {
                    Aperture::Disc { radius } => Aperture::Disc { radius: f(radius) },
                    Aperture::Square { side } => Aperture::Square { side: f(side) },
                },
                focus: f(lens.focus),
            }),
        }
    }
}

impl Camera<f32> {
    /// A pinhole camera with a vertical field of view in degrees, between 0 and 180.
    pub const fn look_at(eye: Vec3<f32>, target: Vec3<f32>, up: Vec3<f32>, field_of_view: f32) -> Self {
        Self::with_half_height(eye, target, up, tangent_of_degrees(field_of_view as f64 / 2.0) as f32)
    }
}
