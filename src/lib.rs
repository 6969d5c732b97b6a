//! A Whitted ray tracer with a fixed budget: every byte of memory is known when it compiles, and every ray is counted
//! while it runs.
//!
//! The library needs no standard library, no allocator and no recursion. It renders on a microcontroller, in a web
//! page or on a workstation, with the same bits: its arithmetic leaves nothing to the target, with operations in a written
//! order, none fused, and functions of `libm`.
//!
//! ```
//! use whit::render::{Encoding, Rgb888, Size};
//! use whit::{Frame, Settings};
//!
//! let mut bytes = [0; 64 * 48 * 3]; // The memory is the caller's.
//! let mut target = Rgb888::new(Size::new(64, 48), &mut bytes, Encoding::Srgb).unwrap();
//! let tracer = whit::tracer!(whit::scenes::SHOWCASE); // Code for what the scene calls for, and no more.
//! let mut frame = Frame::new(&tracer, Settings::new(64, 48)).unwrap();
//! frame.render(&mut target).unwrap();
//! assert!(bytes.iter().any(|&byte| byte > 200));
//! ```
//!
//! # The walk of a pixel
//!
//! ```text
//! Camera ──ray──▶ RayTree ──ray──▶ path ──ray──▶ intersect ──hit──▶ shade ──▶ pixel += throughput × light
//!                   ▲                                                 │
//!                   └────────── reflected / transmitted branch ───────┘
//! pixels ──▶ mean of the samples ──▶ Framebuffer (RGB888, RGB565, grey, 1 bit, linear, draw target, closure)
//! ```
//!
//! Light is gathered forwards: a branch of the ray tree carries the throughput of its whole path to the eye. The walk
//! keeps one current branch and puts only its sibling aside, so a tree of depth `DEPTH` needs a stack of exactly
//! `DEPTH` entries. A [`Frame`] holds all of its state, so it can stop at any ray and go on later.
//!
//! # The rooms
//!
//! | module | what lives there |
//! |---|---|
//! | [`math`] | the scalar trait [`Real`], vectors, colours |
//! | [`optics`] | pure functions: reflection, refraction, Fresnel, attenuation, thin films, dispersion; [`materials`](optics::materials) |
//! | [`scene`] | what a user describes: camera, shapes, materials, media and their profiles, lights, background; [`Effects`]; files |
//! | `intersect` | rays against shapes, error-bounded surface points |
//! | `path` | how light gets to the next surface: straight, bent by a medium, bent by a black hole |
//! | [`trace`] | the ray tree, its [`Budget`], shading, observers |
//! | [`render`] | camera samples, scanlines, the resumable [`Frame`], framebuffers |
//!
//! Each knows only those above it.
//!
//! # Conventions
//!
//! - Space is right-handed. A picture's rows are counted from the top and its columns from the left.
//! - Lengths are in scene units, as the user chooses them; there is no fixed epsilon unless a scene asks for one
//!   ([`Offset`](scene::Offset)). Coordinates go up to 1e12.
//! - Angles are in degrees where a name says so ([`Camera::look_at`]), and else come as their tangent or cosine.
//! - Colours are linear light in the primaries of Rec. 709; the framebuffer encodes them ([`render::Encoding`]).
//! - The outside of a shape is where its normal points. Where a ray goes in, the medium changes from what is outside to
//!   the material's; where transparent objects overlap, to the one of the highest [priority](scene::Medium::priority).
//! - Thicknesses of films and wavelengths are in nanometres, whatever the scene unit; attenuation is in 1/scene unit.
//! - Light is bent where a medium names a [`Profile`](scene::Profile), or around a [`BlackHole`](scene::BlackHole); all rays
//!   but those to lights are, and these too if the scene says so ([`ShadowRays`](scene::ShadowRays)).
//! - Every random-looking number is a function of pixel, sample and dimension ([`trace::Sequence`]); nothing depends on
//!   the order of work.
//!
//! # Memory
//!
//! A [`Frame`] is all the state there is. In bytes, on a 64-bit machine, for scenes whose media need not be remembered
//! and, in the second line, for ones in which a branch remembers up to 8 ([`Scene::media`]):
//!
//! | `DEPTH` | 0 | 1 | 2 | 3 | 4 | 5 | 8 | 16 | 64 |
//! |---|---|---|---|---|---|---|---|---|---|
//! | `f32` | 384 | 424 | 464 | 504 | 544 | 584 | 704 | 1024 | 2944 |
//! | `f32`, 8 media | 416 | 472 | 528 | 584 | 640 | 696 | 864 | 1312 | 4000 |
//! | `f64` | 656 | 736 | 816 | 896 | 976 | 1056 | 1296 | 1936 | 5776 |
//!
//! A scene with dispersion needs two entries more than bounces ([`Scene::stack`]). A test asserts these numbers. The
//! picture's memory is the caller's.
//!
//! # Features
//!
//! - `nff` (default): the reader of Neutral File Format scenes, [`scene::nff`].
//! - `embedded-graphics`: framebuffers over any `embedded_graphics` draw target.
//! - `micromath`: the number type [`Fast`], an `f32` with approximate functions, and
//!   [`Micromath`](math::Micromath), which has those of the crate `micromath`.
//! - `fixed`: the number types [`Q16`] and [`Q20`], fixed point over the crate `fixed`.
//!
//! A feature only makes a type available; it never changes a picture.
//!
//! # Number types
//!
//! Everything is generic over [`Real`]. What each type costs in accuracy and in time, with all other choices that trade the
//! one for the other, is measured in `docs/accuracy.md`.
//!
//! | type | for |
//! |---|---|
//! | `f32` | the default; processors with an FPU |
//! | `f64` | a reference |
//! | [`Fast`] | processors without an FPU, in scenes with films, attenuation or real exponents of highlights |
//! | [`Q16`], [`Q20`] | processors without an FPU: 0.14 to 0.5 of the instructions of `f32`, in scenes that fit and bend no light |
//!
//! A constant `f32` scene gets into another type by [`SceneBuf::from_scene`] or, in place, [`SceneBuf::copy_from`].
#![cfg_attr(not(test), no_std)]

/// The README's programs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

mod intersect;
pub mod math;
pub mod optics;
mod path;
pub mod render;
pub mod scene;
pub mod trace;

pub use intersect::{Destination, Intersection, Ray};
#[cfg(feature = "micromath")]
pub use math::Fast;
#[cfg(feature = "fixed")]
pub use math::{Q16, Q20};
pub use math::{Real, Rgb, Vec3};
pub use render::{Frame, Framebuffer, Settings};
pub use scene::{
    Background, Camera, Effects, Fresnel, Interface, Light, Material, Medium, Object, Pattern, Scene, SceneBuf, Shape,
    Tone, scenes,
};
pub use trace::{Budget, Observer, Stats, Termination, Tracer};
