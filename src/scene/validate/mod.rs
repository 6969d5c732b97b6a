//! What a scene must keep to, so that whatever is accepted renders finite pixels.
//!
//! The checks are `const fn`s over `f32`, so that a constant scene is checked by the compiler; scenes in other number
//! types are converted, primitive by primitive, and checked by the same code.

mod camera;
mod error;
mod fixed_point;
mod material;
mod number;
mod profile;
mod shape;

pub use error::{Place, SceneError};

use super::{Background, Hierarchy, Index, Material, Medium, Object, Offset, Scene, Shadow, Tone};
use crate::math::{Range, Real};
use material::attenuation;
pub(super) use number::color;
use number::{Fault, amount, check, ensure, length, positive, refraction, unit, within};
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
        if let Err((field, expected)) = check_surroundings(&self.background, &self.tone, &self.medium) {
            return Err(SceneError { place: Place::Scene, field, expected });
        }
        if let Offset::Fixed(distance) = self.offset {
            if let Err((field, expected)) = positive(distance, "offset") {
                return Err(SceneError { place: Place::Scene, field, expected });
            }
        }
        if let Err((field, expected)) = check_count(self.objects.len()) {
            return Err(SceneError { place: Place::Scene, field, expected });
        }
        if let Err((field, expected)) = check_hierarchy(&self.hierarchy, self.parts()) {
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
        self.check_bending()
    }

    /// Checks what bends light, and that each profile that a medium names is there.
    #[allow(clippy::indexing_slicing)] // In range by the loops' conditions; iterators are not const.
    const fn check_bending(&self) -> Result<(), SceneError> {
        if let Err(error) = self.check_names() {
            return Err(error);
        }
        if let Some(hole) = &self.black_hole {
            if let Err((field, expected)) = hole.check(self.camera.eye) {
                return Err(SceneError { place: Place::Scene, field, expected });
            }
        }
        let mut i = 0;
        while i < self.profiles.len() {
            if let Err((field, expected)) = self.profiles[i].check() {
                return Err(SceneError { place: Place::Profile(i), field, expected });
            }
            i += 1;
        }
        Ok(())
    }
}

impl<T> Scene<'_, T> {
    /// Checks that each profile that a medium names is there, and that there is none around a black hole.
    #[allow(clippy::indexing_slicing)] // In range by the loop's condition; iterators are not const.
    const fn check_names(&self) -> Result<(), SceneError> {
        let count = self.profiles.len();
        if let (Some(_), true) = (&self.black_hole, count > 0) {
            let expected = "no profile where there is a black hole";
            return Err(SceneError { place: Place::Scene, field: "profiles", expected });
        }
        let expected = "the number of one of the scene's profiles";
        if !is_there(&self.medium.index, count) {
            return Err(SceneError { place: Place::Scene, field: "medium.index", expected });
        }
        let mut i = 0;
        while i < self.objects.len() {
            if let Some(medium) = self.objects[i].material.interface.inside() {
                if !is_there(&medium.index, count) {
                    return Err(SceneError { place: Place::Object(i), field: "interface.medium.index", expected });
                }
            }
            i += 1;
        }
        Ok(())
    }
}

const fn is_there<T>(index: &Index<T>, profiles: usize) -> bool {
    match index {
        Index::Profile(number) => (*number as usize) < profiles,
        Index::Constant(_) | Index::Dispersive(_) => true,
    }
}

impl<T: Real> Scene<'_, T> {
    /// Checks every number of the scene.
    ///
    /// # Errors
    /// The first field that is out of its range.
    pub fn validate(&self) -> Result<(), SceneError> {
        let at = |place| move |(field, expected): Fault| SceneError { place, field, expected };
        if T::IS_FIXED {
            let expected = "nothing that bends light, in fixed point";
            check(self.black_hole.is_none(), "black_hole", expected).map_err(at(Place::Scene))?;
            check(self.profiles.is_empty(), "profiles", expected).map_err(at(Place::Scene))?;
        }
        self.camera.map(T::to_f32).check().map_err(at(Place::Camera))?;
        let (background, tone) = (self.background.map(T::to_f32), self.tone.map(T::to_f32));
        check_surroundings(&background, &tone, &self.medium.map(T::to_f32)).map_err(at(Place::Scene))?;
        if let Offset::Fixed(distance) = self.offset {
            positive(distance.to_f32(), "offset").map_err(at(Place::Scene))?;
        }
        check_count(self.objects.len()).map_err(at(Place::Scene))?;
        check_hierarchy(&self.hierarchy, self.parts()).map_err(at(Place::Scene))?;
        for (i, object) in self.objects.iter().enumerate() {
            let mut index = 0;
            while let Some(part) = object.shape.part(index, T::to_f32) {
                part.check().map_err(at(Place::Object(i)))?;
                index += 1;
            }
            check_looks(&object.material.map(T::to_f32), object.shadow).map_err(at(Place::Object(i)))?;
        }
        for (i, light) in self.lights.iter().enumerate() {
            light.map(T::to_f32).check().map_err(at(Place::Light(i)))?;
        }
        self.check_names()?;
        if let Some(hole) = &self.black_hole {
            hole.map(T::to_f32).check(self.camera.eye.map(T::to_f32)).map_err(at(Place::Scene))?;
        }
        for (i, profile) in self.profiles.iter().enumerate() {
            profile.check_any().map_err(at(Place::Profile(i)))?;
        }
        match &T::RANGE {
            Some(range) => self.check_range(range),
            None => Ok(()),
        }
    }

    /// Checks that the scene has room in fixed point.
    fn check_range(&self, range: &Range) -> Result<(), SceneError> {
        let at = |place| move |(field, expected): Fault| SceneError { place, field, expected };
        range.camera(&self.camera.map(T::to_f32)).map_err(at(Place::Camera))?;
        let (background, tone) = (self.background.map(T::to_f32), self.tone.map(T::to_f32));
        range.surroundings(&background, &tone).map_err(at(Place::Scene))?;
        if let Offset::Fixed(distance) = self.offset {
            range.length(distance.to_f32(), "offset").map_err(at(Place::Scene))?;
        }
        range.medium(&self.medium.map(T::to_f32), ["medium.index", "medium.attenuation"]).map_err(at(Place::Scene))?;
        for (i, object) in self.objects.iter().enumerate() {
            let mut index = 0;
            while let Some(part) = object.shape.part(index, T::to_f32) {
                range.shape(&part).map_err(at(Place::Object(i)))?;
                index += 1;
            }
            range.material(&object.material.map(T::to_f32)).map_err(at(Place::Object(i)))?;
        }
        for (i, light) in self.lights.iter().enumerate() {
            range.light(&light.map(T::to_f32)).map_err(at(Place::Light(i)))?;
        }
        Ok(())
    }
}

/// Objects are remembered by 16-bit numbers.
const fn check_count(objects: usize) -> Result<(), Fault> {
    check(objects < u16::MAX as usize, "objects", "at most 65534 objects")
}

const fn check_hierarchy(hierarchy: &Option<Hierarchy<'_>>, parts: usize) -> Result<(), Fault> {
    let is_of_these = match hierarchy {
        Some(hierarchy) => hierarchy.leaves.len() == parts,
        None => true,
    };
    check(is_of_these, "hierarchy", "one that was built of these objects")
}

const fn check_surroundings(background: &Background<f32>, tone: &Tone<f32>, medium: &Medium<f32>) -> Result<(), Fault> {
    match *background {
        Background::Solid(c) => ensure!(color(c, "background")),
        Background::Gradient { below, above, up } => {
            ensure!(color(below, "background.below"));
            ensure!(color(above, "background.above"));
            ensure!(unit(up, "background.up"));
        }
        Background::Sky { horizon, up } => {
            ensure!(color(horizon, "background.horizon"));
            ensure!(unit(up, "background.up"));
        }
        Background::Stars { sky, brightness, cells, radius } => {
            ensure!(color(sky, "background.sky"));
            ensure!(amount(brightness, "background.brightness"));
            ensure!(check(cells >= 1, "background.cells", "at least 1"));
            ensure!(check(within(radius, 1e-3, 0.5), "background.radius", "a share of a cell from 1e-3 to 0.5"));
        }
    }
    if let Tone::Display { gain, lift } = *tone {
        ensure!(amount(gain, "tone.gain"));
        ensure!(length(lift, "tone.lift"));
    }
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
