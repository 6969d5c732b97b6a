//! What a scene must keep to, so that whatever is accepted renders finite pixels.
//!
//! The checks are `const fn`s over `f32`, so that a constant scene is checked by the compiler; scenes in other number
//! types are converted, primitive by primitive, and checked by the same code.

use core::fmt;

use super::{Aperture, Background, Camera, Emitter, Exponent, Interface, Light, Material, Object, Pattern, Scene};
use super::{Shape, Tone};
use crate::math::{Real, Rgb, Vec3};

/// The largest coordinate or length: its cube is still far from overflow in `f32`.
const FARTHEST: f32 = 1e12;
/// The largest factor or intensity.
const BRIGHTEST: f32 = 1e12;

const LENGTH: &str = "a finite number of at most 1e12";
const POSITIVE: &str = "a number from 1e-12 to 1e12";
const AMOUNT: &str = "a number from 0 to 1e12";
const SHARE: &str = "a number from 0 to 1";
const DIRECTION: &str = "finite numbers, not all zero";

/// What is wrong with a scene, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// Where.
    pub place: Place,
    /// Which field.
    pub field: &'static str,
    /// What it must be.
    pub expected: &'static str,
}

/// A part of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The camera.
    Camera,
    /// The scene itself: background, medium, tone.
    Scene,
    /// An object, by its place in the list.
    Object(usize),
    /// A light, by its place in the list.
    Light(usize),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Place::Camera => f.write_str("camera")?,
            Place::Scene => f.write_str("scene")?,
            Place::Object(i) => write!(f, "object {i}")?,
            Place::Light(i) => write!(f, "light {i}")?,
        }
        write!(f, ": {}: expected {}", self.field, self.expected)
    }
}

impl core::error::Error for SceneError {}

/// A field and what it must be.
type Fault = (&'static str, &'static str);

const fn check(ok: bool, field: &'static str, expected: &'static str) -> Result<(), Fault> {
    if ok { Ok(()) } else { Err((field, expected)) }
}

/// `?` for constant evaluation.
macro_rules! ensure {
    ($result:expr) => {
        if let Err(fault) = $result {
            return Err(fault);
        }
    };
}

const fn within(x: f32, low: f32, high: f32) -> bool {
    x >= low && x <= high
}

const fn length(x: f32, field: &'static str) -> Result<(), Fault> {
    check(within(x, -FARTHEST, FARTHEST), field, LENGTH)
}

const fn positive(x: f32, field: &'static str) -> Result<(), Fault> {
    check(within(x, 1e-12, FARTHEST), field, POSITIVE)
}

const fn amount(x: f32, field: &'static str) -> Result<(), Fault> {
    check(within(x, 0.0, BRIGHTEST), field, AMOUNT)
}

pub(super) const fn point(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    ensure!(length(v.x, field));
    ensure!(length(v.y, field));
    length(v.z, field)
}

pub(super) const fn color(c: Rgb<f32>, field: &'static str) -> Result<(), Fault> {
    ensure!(amount(c.r, field));
    ensure!(amount(c.g, field));
    amount(c.b, field)
}

const fn share(c: Rgb<f32>, field: &'static str) -> Result<(), Fault> {
    check(within(c.r, 0.0, 1.0) && within(c.g, 0.0, 1.0) && within(c.b, 0.0, 1.0), field, SHARE)
}

const fn dot(a: Vec3<f32>, b: Vec3<f32>) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

const fn minus(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    Vec3::new(a.x - b.x, a.y - b.y, a.z - b.z)
}

/// A direction whose square neither underflows nor overflows.
pub(super) const fn direction(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    ensure!(point(v, field));
    check(dot(v, v) > 1e-24, field, DIRECTION)
}

const fn unit(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    check(within(dot(v, v), 0.999, 1.001), field, "a vector of length 1")
}

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
        if let Err((field, expected)) = check_surroundings(&self.background, &self.tone, self.index) {
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

impl<T: Real> Scene<'_, T> {
    /// Checks every number of the scene.
    ///
    /// # Errors
    /// The first field that is out of its range.
    pub fn validate(&self) -> Result<(), SceneError> {
        let at = |place| move |(field, expected): Fault| SceneError { place, field, expected };
        self.camera.map(T::to_f32).check().map_err(at(Place::Camera))?;
        let (background, tone) = (self.background.map(T::to_f32), self.tone.map(T::to_f32));
        check_surroundings(&background, &tone, self.index.to_f32()).map_err(at(Place::Scene))?;
        for (i, object) in self.objects.iter().enumerate() {
            let mut index = 0;
            while let Some(part) = object.part(index, T::to_f32) {
                part.check().map_err(at(Place::Object(i)))?;
                index += 1;
            }
        }
        for (i, light) in self.lights.iter().enumerate() {
            light.map(T::to_f32).check().map_err(at(Place::Light(i)))?;
        }
        Ok(())
    }
}

const fn check_surroundings(background: &Background<f32>, tone: &Tone<f32>, index: f32) -> Result<(), Fault> {
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
    }
    if let Tone::Display { gain, lift } = *tone {
        ensure!(amount(gain, "tone.gain"));
        ensure!(length(lift, "tone.lift"));
    }
    refraction(index, "index")
}

const fn refraction(index: f32, field: &'static str) -> Result<(), Fault> {
    check(within(index, 1e-3, 1e3), field, "an index of refraction from 1e-3 to 1e3")
}

impl Camera<f32> {
    pub(super) const fn check(&self) -> Result<(), Fault> {
        ensure!(point(self.eye, "eye"));
        ensure!(point(self.target, "target"));
        ensure!(direction(self.up, "up"));
        let sight = minus(self.target, self.eye);
        ensure!(check(dot(sight, sight) > 1e-24, "target", "a point away from the eye"));
        let along = dot(sight, self.up);
        let parallel = along * along >= 0.999_999 * dot(sight, sight) * dot(self.up, self.up);
        ensure!(check(!parallel, "up", "a direction that is not the line of sight"));
        ensure!(check(within(self.half_height, 1e-6, 1e6), "half_height", "a tangent from 1e-6 to 1e6"));
        let Some(lens) = &self.lens else { return Ok(()) };
        ensure!(match lens.aperture {
            Aperture::Disc { radius } => amount(radius, "lens.aperture"),
            Aperture::Square { side } => amount(side, "lens.aperture"),
        });
        positive(lens.focus, "lens.focus")
    }
}

impl Object<'_, f32> {
    pub(super) const fn check(&self) -> Result<(), Fault> {
        ensure!(self.shape.check());
        self.material.check()
    }
}

const fn round(center: Vec3<f32>, radius: f32) -> Result<(), Fault> {
    ensure!(point(center, "center"));
    check(within(radius.abs(), 1e-12, FARTHEST), "radius", POSITIVE)
}

#[allow(clippy::indexing_slicing)] // Constant indices into arrays of three.
const fn corners(vertices: &[Vec3<f32>; 3]) -> Result<(), Fault> {
    ensure!(point(vertices[0], "vertices"));
    ensure!(point(vertices[1], "vertices"));
    point(vertices[2], "vertices")
}

impl Shape<'_, f32> {
    #[allow(clippy::indexing_slicing)] // In range by the loops' conditions; iterators are not const.
    const fn check(&self) -> Result<(), Fault> {
        match self {
            Shape::Sphere(sphere) => round(sphere.center, sphere.radius),
            Shape::Spheres(list) => {
                let mut i = 0;
                while let Some(sphere) = list.sphere(i) {
                    ensure!(round(sphere.center, sphere.radius));
                    i += 1;
                }
                Ok(())
            }
            Shape::Plane(plane) => {
                ensure!(point(plane.point, "point"));
                direction(plane.normal, "normal")
            }
            Shape::Disc(disc) => {
                ensure!(point(disc.center, "center"));
                ensure!(direction(disc.normal, "normal"));
                positive(disc.radius, "radius")
            }
            Shape::Box(b) => {
                ensure!(point(b.min, "min"));
                ensure!(point(b.max, "max"));
                let ordered = b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z;
                check(ordered, "max", "a corner not below `min` on any axis")
            }
            Shape::Triangle(triangle) => corners(&triangle.vertices),
            Shape::Triangles(list) => {
                let mut i = 0;
                while i < list.len() {
                    ensure!(corners(&list[i].vertices));
                    i += 1;
                }
                Ok(())
            }
            Shape::SmoothTriangle(triangle) => {
                ensure!(corners(&triangle.vertices));
                ensure!(direction(triangle.normals[0], "normals"));
                ensure!(direction(triangle.normals[1], "normals"));
                direction(triangle.normals[2], "normals")
            }
            Shape::Cone(cone) => {
                ensure!(point(cone.base, "base"));
                ensure!(point(cone.apex, "apex"));
                ensure!(direction(minus(cone.apex, cone.base), "apex"));
                ensure!(length(cone.base_radius, "base_radius"));
                ensure!(length(cone.apex_radius, "apex_radius"));
                let (base, apex) = (cone.base_radius, cone.apex_radius);
                let same_side = (base >= 0.0 && apex >= 0.0) || (base <= 0.0 && apex <= 0.0);
                ensure!(check(same_side, "apex_radius", "the sign of `base_radius`"));
                check(base.abs() + apex.abs() >= 1e-12, "base_radius", "a radius above 0 at one end")
            }
        }
    }
}

impl Material<f32> {
    pub(super) const fn check(&self) -> Result<(), Fault> {
        if let Some(body) = &self.body {
            ensure!(body.color.check());
            ensure!(amount(body.emission, "body.emission"));
            ensure!(amount(body.ambient, "body.ambient"));
            ensure!(amount(body.diffuse, "body.diffuse"));
        }
        if let Some(highlight) = &self.highlight {
            ensure!(color(highlight.color, "highlight.color"));
            if let Exponent::Real(s) = highlight.exponent {
                ensure!(amount(s, "highlight.exponent"));
            }
        }
        match self.interface {
            Interface::Opaque => Ok(()),
            Interface::Mirror { reflected } => share(reflected, "interface.reflected"),
            Interface::Metal { r0 } => share(r0, "interface.r0"),
            Interface::Constant { reflected, transmitted, index } => {
                ensure!(share(reflected, "interface.reflected"));
                ensure!(share(transmitted, "interface.transmitted"));
                refraction(index, "interface.index")
            }
            Interface::Dielectric { index } => refraction(index, "interface.index"),
        }
    }
}

impl Pattern<f32> {
    const fn check(&self) -> Result<(), Fault> {
        match *self {
            Pattern::Solid(c) => color(c, "body.color"),
            Pattern::Checker { even, odd, u, v } => {
                ensure!(color(even, "body.color.even"));
                ensure!(color(odd, "body.color.odd"));
                ensure!(point(u, "body.color.u"));
                point(v, "body.color.v")
            }
            Pattern::Gradient { from, to, origin, axis } => {
                ensure!(color(from, "body.color.from"));
                ensure!(color(to, "body.color.to"));
                ensure!(point(origin, "body.color.origin"));
                point(axis, "body.color.axis")
            }
        }
    }
}

impl Light<f32> {
    pub(super) const fn check(&self) -> Result<(), Fault> {
        ensure!(color(self.color, "color"));
        match self.emitter {
            Emitter::Point { position } => ensure!(point(position, "position")),
            Emitter::Directional { towards } => ensure!(direction(towards, "towards")),
            Emitter::Sphere { center, radius } => {
                ensure!(point(center, "center"));
                ensure!(positive(radius, "radius"));
            }
            Emitter::Parallelogram { corner, edge_u, edge_v } => {
                ensure!(point(corner, "corner"));
                ensure!(point(edge_u, "edge_u"));
                ensure!(point(edge_v, "edge_v"));
            }
        }
        let Some(falloff) = &self.falloff else { return Ok(()) };
        ensure!(check(within(falloff.constant, 1e-12, BRIGHTEST), "falloff.constant", POSITIVE));
        ensure!(amount(falloff.linear, "falloff.linear"));
        amount(falloff.quadratic, "falloff.quadratic")
    }
}
