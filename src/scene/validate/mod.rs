//! What a scene must keep to, so that whatever is accepted renders finite pixels.
//!
//! The checks are `const fn`s over `f32`, so that a constant scene is checked by the compiler; scenes in other number
//! types are converted, primitive by primitive, and checked by the same code.

use core::any::Any;

mod camera;
mod error;
mod material;
mod number;
mod shape;

pub use error::{Place, SceneError};

use super::{Background, Camera, Light, Material, Medium, Object, Scene, Shadow, Tone};
use crate::math::Real;
use material::attenuation;
pub(super) use number::color;
use number::{Fault, amount, check, ensure, length, refraction, unit};
#[cfg(feature = "nff")]
pub(super) use number::{direction, point};

impl Scene<'_, f32> {
    /// Checks every number of the scene, in constant evaluation if asked there.
    ///
    /// # Errors
    /// The first field that is out of its range.
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    pub const fn check(&self) -> Result<(), SceneError> {
        if let Err((field, expected)) = self.camera.check() {
            return Err(SceneError { place: Place::Camera, field, expected });
        }
        if let Err((field, expected)) = self.check_whole() {
            return Err(SceneError { place: Place::Scene, field, expected });
        }
        let mut i = 0;
        while i < self.objects.len() {
            if let Err((field, expected)) = self.objects[i].check() {
                return Err(SceneError { place: Place::Object(i), field, expected });
            }
            i += 1;
        }
        let mut i = 0;
        while i < self.lights.len() {
            if let Err((field, expected)) = self.lights[i].check() {
                return Err(SceneError { place: Place::Light(i), field, expected });
            }
            i += 1;
        }
        Ok(())
    }
}

impl Scene<'_, f32> {
    /// What belongs to no object and no light, nor to the camera.
    const fn check_whole(&self) -> Result<(), Fault> {
        ensure!(check_background(&self.background));
        ensure!(check_tone(&self.tone));
        ensure!(check_surrounding(&self.medium));
        check_count(self.objects.len())
    }
}

impl<T: Real> Scene<'_, T> {
    /// Checks every number of the scene.
    ///
    /// # Errors
    /// The first field that is out of its range.
    pub fn validate(&self) -> Result<(), SceneError> {
        let at = |place| move |(field, expected): Fault| SceneError { place, field, expected };
        in_f32(&self.camera, |camera| camera.map(T::to_f32), Camera::check).map_err(at(Place::Camera))?;
        in_f32(&self.background, |background| background.map(T::to_f32), check_background).map_err(at(Place::Scene))?;
        in_f32(&self.tone, |tone| tone.map(T::to_f32), check_tone).map_err(at(Place::Scene))?;
        in_f32(&self.medium, |medium| medium.map(T::to_f32), check_surrounding).map_err(at(Place::Scene))?;
        check_count(self.objects.len()).map_err(at(Place::Scene))?;
        for (i, object) in self.objects.iter().enumerate() {
            let mut index = 0;
            while let Some(part) = object.shape.part(index, T::to_f32) {
                part.check().map_err(at(Place::Object(i)))?;
                index += 1;
            }
            let looks = |material: &_| check_looks(material, object.shadow);
            in_f32(&object.material, |material| material.map(T::to_f32), looks).map_err(at(Place::Object(i)))?;
        }
        for (i, light) in self.lights.iter().enumerate() {
            in_f32(light, |light| light.map(T::to_f32), Light::check).map_err(at(Place::Light(i)))?;
        }
        Ok(())
    }
}

/// Checks a value in `f32`: itself where it is one, so that a program that has no other number type holds no conversion.
#[inline]
fn in_f32<A: Any, B: Any>(
    value: &A,
    convert: impl Fn(&A) -> B,
    check: impl Fn(&B) -> Result<(), Fault>,
) -> Result<(), Fault> {
    match (value as &dyn Any).downcast_ref() {
        Some(value) => check(value),
        None => check(&convert(value)),
    }
}

/// Objects are remembered by 16-bit numbers.
const fn check_count(objects: usize) -> Result<(), Fault> {
    check(objects < u16::MAX as usize, "objects", "at most 65534 objects")
}

const fn check_background(background: &Background<f32>) -> Result<(), Fault> {
    match *background {
        Background::Solid(c) => color(c, "background"),
        Background::Gradient { below, above, up } => {
            ensure!(color(below, "background.below"));
            ensure!(color(above, "background.above"));
            unit(up, "background.up")
        }
        Background::Sky { horizon, up } => {
            ensure!(color(horizon, "background.horizon"));
            unit(up, "background.up")
        }
    }
}

const fn check_tone(tone: &Tone<f32>) -> Result<(), Fault> {
    if let Tone::Display { gain, lift } = *tone {
        ensure!(amount(gain, "tone.gain"));
        ensure!(length(lift, "tone.lift"));
    }
    Ok(())
}

/// The medium around the objects.
const fn check_surrounding(medium: &Medium<f32>) -> Result<(), Fault> {
    ensure!(refraction(&medium.index, "medium.index"));
    attenuation(&medium.attenuation, "medium.attenuation")
}

impl Object<'_, f32> {
    pub(in crate::scene) const fn check(&self) -> Result<(), Fault> {
        ensure!(self.shape.check());
        check_looks(&self.material, self.shadow)
    }
}

const fn check_looks(material: &Material<f32>, shadow: Shadow) -> Result<(), Fault> {
    ensure!(material.check());
    let tinted = matches!(shadow, Shadow::Tinted) && !material.interface.is_transparent();
    check(!tinted, "shadow", "a tinted shadow only under a transparent interface")
}
