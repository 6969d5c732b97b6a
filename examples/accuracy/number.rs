//! The number types that are compared, as types. Their names are a list of their own.

use whit::math::{Fast, Micromath, Q16, Q20};
use whit::{Real, Scene};

use crate::conversion;
use crate::dispatch::{Kind, Picture, finest, packed, unpacked};
use crate::number_name::with_numbers;

/// A number type that scenes can be traced in.
pub trait Number: Real + Send + Sync {
    /// A scene in it, or why it refuses the scene.
    fn scene(scene: &Scene<'static, f32>) -> Result<Scene<'static, Self>, String> {
        conversion::converted(scene).map_err(|full| full.to_string())
    }

    /// Traces a variant of a built-in scene by code for just its own effects.
    fn trace(name: &str, kind: Kind, scene: &Scene<'static, Self>, picture: &mut Picture<'_>) -> Result<(), String> {
        unpacked::trace(name, kind, scene, picture)
    }
}

impl Number for f32 {
    fn scene(scene: &Scene<'static, f32>) -> Result<Scene<'static, Self>, String> {
        Ok(*scene)
    }

    fn trace(name: &str, kind: Kind, scene: &Scene<'static, Self>, picture: &mut Picture<'_>) -> Result<(), String> {
        packed::trace(name, kind, scene, picture)
    }
}

impl Number for f64 {
    fn trace(name: &str, kind: Kind, scene: &Scene<'static, Self>, picture: &mut Picture<'_>) -> Result<(), String> {
        finest::trace(name, kind, scene, picture)
    }
}

impl Number for Fast {}
impl Number for Micromath {}
impl Number for Q16 {}
impl Number for Q20 {}

macro_rules! define_with_number {
    ($($variant:ident, $name:literal, $type:ty;)*) => {
        /// Calls a generic function with the type of a number.
        macro_rules! with_number {
            ($number:expr, $function:ident($argument:expr)) => {
                match $number {
                    $($crate::number_name::NumberName::$variant => $function::<$type>($argument),)*
                }
            };
        }
        pub(crate) use with_number;
    };
}

with_numbers!(define_with_number!());
