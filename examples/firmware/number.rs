//! What is computed in: WHIT_NUMBER.
//!
//! This file is part of several programs, which have the constants `SCENE` and `DEPTH`.
#![allow(dead_code)] // Of the number types, one is chosen.

use core::hint::black_box;
use core::mem::MaybeUninit;

use whit::trace::TracerError;
use whit::{Effects, Frame, Real, Scene, SceneBuf, Shape, Tracer};

use crate::choice::same;
use crate::{DEPTH, SCENE};

/// The name of the number type: WHIT_NUMBER.
pub const NAME: &str = match option_env!("WHIT_NUMBER") {
    Some(name) => name,
    None => "f32",
};

/// The number type of that name, as the constants below count them.
pub type Chosen = Choice<WHICH>;
pub type Number = <Chosen as Computed>::Number;
/// What the scene takes of memory in that type: nothing as the constant that it is in `f32`.
pub type Memory = <Chosen as Computed>::Memory;

/// The state of a picture of the scene.
pub type Drawn = Frame<'static, Number, EFFECTS, STACK, (), MEDIA>;

/// A number type by its number in the list.
pub struct Choice<const PLACE: usize>;

pub trait Computed {
    type Number: Real;
    type Memory: 'static;
}

const STACK: usize = SCENE.stack(DEPTH as usize);
const MEDIA: usize = SCENE.media();
const EFFECTS: u64 = if WHICH == 0 { SCENE.effects().bits() } else { CONVERTED_EFFECTS };

impl Computed for Choice<0> {
    type Number = f32;
    type Memory = ();
}

impl Choice<0> {
    /// The tracer of the scene, checked by the compiler.
    pub fn tracer(
        _: &'static mut MaybeUninit<()>,
    ) -> Result<Tracer<'static, f32, { SCENE.effects().bits() }, STACK, MEDIA>, &'static str> {
        Ok(whit::tracer!(SCENE, DEPTH as usize))
    }
}

/// The types besides `f32`: their numbers, names, and themselves.
macro_rules! numbers {
    ($($(#[$available:meta])? $place:literal, $name:literal: $number:ty;)*) => {
        const WHICH: usize = {
            let mut which = if same(NAME.as_bytes(), b"f32") { Some(0) } else { None };
            $($(#[$available])? {
                if same(NAME.as_bytes(), $name.as_bytes()) {
                    which = Some($place);
                }
            })*
            which.expect("WHIT_NUMBER: there is no such number type, or not without its feature")
        };
        $($(#[$available])?
        impl Computed for Choice<$place> {
            type Number = $number;
            type Memory = Converted<$number>;
        }
        $(#[$available])?
        impl Choice<$place> {
            /// The tracer of the scene, converted when the program runs.
            pub fn tracer(
                memory: &'static mut MaybeUninit<Converted<$number>>,
            ) -> Result<Tracer<'static, $number, CONVERTED_EFFECTS, STACK, MEDIA>, &'static str> {
                converted(memory)
            }
        })*
    };
}

numbers! {
    1, "f64": f64;
    // As the other types are: what the conversion alone costs.
    2, "f32-converted": f32;
    #[cfg(feature = "micromath")]
    3, "fast": whit::Fast;
    #[cfg(feature = "micromath")]
    6, "micromath": whit::math::Micromath;
    #[cfg(feature = "fixed")]
    4, "q16": whit::math::Q16;
    #[cfg(feature = "fixed")]
    5, "q20": whit::math::Q20;
}

/// Primitives are objects of their own in a converted scene.
const CONVERTED_EFFECTS: u64 = apart(SCENE.effects(), Effects::SPHERES, Effects::SPHERE)
    .with(apart(SCENE.effects(), Effects::TRIANGLES, Effects::TRIANGLE))
    .without(Effects::SPHERES)
    .without(Effects::TRIANGLES)
    .bits();

const fn apart(effects: Effects, many: Effects, one: Effects) -> Effects {
    if effects.has(many) { effects.with(one) } else { effects }
}

/// Room for the scene's objects. How many spheres a list of them holds is not known to the compiler.
const OBJECTS: usize = {
    let (mut count, mut place) = (SCENE.objects.len(), 0);
    while place < SCENE.objects.len() {
        if matches!(SCENE.objects[place].shape, Shape::Spheres(_) | Shape::Triangles(_)) {
            count = 128;
        }
        place += 1;
    }
    count
};

type Buffer<T> = SceneBuf<T, OBJECTS, { SCENE.lights.len() }, { SCENE.profiles.len() }>;

/// A converted scene and the memory of what it names.
pub struct Converted<T: 'static> {
    buffer: Buffer<T>,
    scene: MaybeUninit<Scene<'static, T>>,
}

impl<T: Real> Converted<T> {
    const EMPTY: Self = Self { buffer: Buffer::EMPTY, scene: MaybeUninit::uninit() };
}

fn converted<T: Real>(
    memory: &'static mut MaybeUninit<Converted<T>>,
) -> Result<Tracer<'static, T, CONVERTED_EFFECTS, STACK, MEDIA>, &'static str> {
    // From a constant, and filled in place: a copy would need as much stack.
    let Converted { buffer, scene } = memory.write(Converted::EMPTY);
    // The compiler would write out the conversion of each object of a constant it sees, and take a minute for it.
    let scene_there = black_box::<&Scene<'_, f32>>(&SCENE);
    buffer.copy_from(scene_there, T::from_f32).map_err(|_| "the scene cannot be had in this number type")?;
    let buffer: &'static Buffer<T> = buffer;
    Tracer::try_new(scene.write(buffer.as_scene())).map_err(|error| match error {
        TracerError::Scene(error) => error.expected,
        TracerError::MissingEffects(_) | TracerError::NoMedia => "the scene calls for more than was compiled",
    })
}
