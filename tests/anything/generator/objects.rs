//! Objects.

use whit::scene::{Shadow, Sides};
use whit::{Interface, Material, Object};

use super::Source;
use super::shapes::Form;

/// An object with the memory that it borrows from.
#[derive(Clone, Debug)]
pub struct Thing {
    pub form: Form,
    pub material: Material<f32>,
    sides: Sides,
    shadow: Shadow,
}

impl Thing {
    pub fn random(source: &mut Source<'_>) -> Self {
        let (form, material) = (Form::random(source), source.material());
        let sides = if source.once_in(4) { Sides::Outside } else { Sides::Both };
        let is_transparent = matches!(material.interface, Interface::Constant { .. } | Interface::Dielectric { .. });
        let shadow = match source.below(6) {
            5 => Shadow::None,
            2..=4 if is_transparent || source.is_wild => Shadow::Tinted,
            _ => Shadow::Full,
        };
        Self { form, material, sides, shadow }
    }

    pub fn object(&self) -> Object<'_, f32> {
        Object { shape: self.form.shape(), material: self.material, sides: self.sides, shadow: self.shadow }
    }
}
