//! Surfaces: the line `f`.

use super::NffError;
use super::lines::Line;
use crate::math::{Real, Rgb};
use crate::scene::{Body, Exponent, Highlight, Interface, Lobe, Material, Medium, Object, Pattern, Shape};

/// The largest Shine that becomes an integer exponent; the files have 100000 for "no highlight".
const LARGEST_INTEGER: f32 = 1e6;

/// What the objects after a line `f` are made of.
#[derive(Clone, Copy)]
pub(super) struct Surface {
    material: Material<f32>,
    is_transparent: bool,
}

impl Surface {
    pub(super) fn read(mut line: Line<'_>) -> Result<Self, NffError> {
        let number = line.number;
        let color = line.color()?;
        let diffuse = line.number("Kd")?;
        let specular = share(&mut line, "Ks")?;
        let shine = line.number("Shine")?;
        let transmittance = share(&mut line, "T")?;
        let is_transparent = transmittance > 0.0;
        let index = line.number_within("ior", "a finite number, above 0 where T is", |index| {
            index.is_finite() && (index > 0.0 || !is_transparent)
        })?;
        line.end()?;
        let material = Material {
            body: body(color, diffuse),
            highlight: highlight(specular, shine),
            interface: interface(specular, transmittance, index),
            balance: None,
        };
        material.check().map_err(NffError::out_of_range(number))?;
        Ok(Self { material, is_transparent })
    }

    /// A shape with this surface.
    pub(super) fn object(&self, shape: Shape<'static, f32>) -> Object<'static, f32> {
        let object = Object::new(shape, self.material);
        if self.is_transparent { object } else { object.one_sided() }
    }
}

fn share(line: &mut Line<'_>, field: &'static str) -> Result<f32, NffError> {
    line.number_within(field, "a number from 0 to 1", |share| (0.0..=1.0).contains(&share))
}

fn body(color: Rgb<f32>, diffuse: f32) -> Option<Body<f32>> {
    let body = Body { color: Pattern::Solid(color), emission: 0.0, ambient: 0.0, diffuse };
    (diffuse != 0.0).then_some(body)
}

fn highlight(specular: f32, shine: f32) -> Option<Highlight<f32>> {
    let is_whole = (0.0..=LARGEST_INTEGER).contains(&shine) && shine == Real::floor(shine);
    let exponent = if is_whole { Exponent::Integer(shine as u32) } else { Exponent::Real(shine) };
    (specular > 0.0).then_some(Highlight { color: Rgb::grey(specular), lobe: Lobe::Blinn, exponent })
}

/// Ks is the share of the reflected branch too.
fn interface(specular: f32, transmittance: f32, index: f32) -> Interface<f32> {
    let reflected = Rgb::grey(specular);
    if transmittance > 0.0 {
        Interface::Constant { reflected, transmitted: Rgb::grey(transmittance), medium: Medium::new(index) }
    } else if specular > 0.0 {
        Interface::Mirror { reflected }
    } else {
        Interface::Opaque
    }
}
