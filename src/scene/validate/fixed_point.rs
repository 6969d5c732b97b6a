//! What a scene must keep to besides in fixed point, so that nothing overflows.

use super::number::{Fault, check, dot, minus, within};
use crate::math::{Range, Rgb, Vec3};
use crate::scene::{
    Aperture, Background, Camera, Emitter, Exponent, Film, Index, Interface, Light, Material, Medium, Pattern, Shape,
    Thickness, Tone,
};

/// The largest index of refraction of a dielectric: its square times a cosine is within any range.
const DENSEST: f32 = 4.0;
/// The smallest one.
const THINNEST: f32 = 0.5;
/// The largest part of a complex index of refraction: twice its square, relative to the thinnest medium, is within any range.
const MOST_CONDUCTING: f32 = 12.0;
/// The largest slope of a cone.
const FLATTEST: f32 = 4.0;
/// Of a direction, so that what it is multiplied with does not grow by more.
const LONGEST: f32 = 1.5;
/// Of a direction, so that it is more than its rounding.
const SHORTEST: f32 = 1.0 / 64.0;

impl Range {
    pub(super) fn length(&self, x: f32, field: &'static str) -> Result<(), Fault> {
        check(within(x, -self.coordinate, self.coordinate), field, self.coordinate_text)
    }

    fn point(&self, Vec3 { x, y, z }: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
        [x, y, z].into_iter().try_for_each(|x| self.length(x, field))
    }

    fn points(&self, points: &[Vec3<f32>], field: &'static str) -> Result<(), Fault> {
        points.iter().try_for_each(|point| self.point(*point, field))
    }

    /// A direction that nothing is multiplied with until its length is 1.
    fn course(&self, v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
        self.point(v, field)?;
        check(dot(v, v) >= SHORTEST * SHORTEST, field, "a direction of length 1/64 or more")
    }

    fn amount(&self, x: f32, field: &'static str) -> Result<(), Fault> {
        check(within(x, 0.0, self.amount), field, self.amount_text)
    }

    fn color(&self, Rgb { r, g, b }: Rgb<f32>, field: &'static str) -> Result<(), Fault> {
        [r, g, b].into_iter().try_for_each(|x| self.amount(x, field))
    }

    pub(super) fn camera(&self, camera: &Camera<f32>) -> Result<(), Fault> {
        self.point(camera.eye, "eye")?;
        self.point(camera.target, "target")?;
        self.course(camera.up, "up")?;
        check(within(camera.half_height, 1e-3, 8.0), "half_height", "a tangent from 1e-3 to 8")?;
        let Some(lens) = &camera.lens else { return Ok(()) };
        let (Aperture::Disc { radius: size } | Aperture::Square { side: size }) = lens.aperture;
        self.length(size, "lens.aperture")?;
        self.length(lens.focus, "lens.focus")
    }

    pub(super) fn surroundings(&self, background: &Background<f32>, tone: &Tone<f32>) -> Result<(), Fault> {
        match *background {
            Background::Solid(color) => self.color(color, "background")?,
            Background::Gradient { below, above, .. } => {
                self.color(below, "background.below")?;
                self.color(above, "background.above")?;
            }
            Background::Sky { horizon, .. } => self.color(horizon, "background.horizon")?,
            Background::Stars { sky, brightness, cells, radius } => {
                self.color(sky, "background.sky")?;
                self.amount(brightness, "background.brightness")?;
                self.length(f32::from(cells), "background.cells")?;
                check(radius >= SHORTEST, "background.radius", "a share of a cell from 1/64 to 0.5")?;
            }
        }
        if let Tone::Display { gain, lift } = *tone {
            self.length(gain, "tone.gain")?;
            self.length(lift, "tone.lift")?;
        }
        Ok(())
    }

    pub(super) fn shape(&self, shape: &Shape<'_, f32>) -> Result<(), Fault> {
        match shape {
            Shape::Sphere(s) => {
                self.point(s.center, "center")?;
                self.length(s.radius, "radius")
            }
            Shape::Plane(p) => {
                self.point(p.point, "point")?;
                direction(p.normal, "normal")
            }
            Shape::Disc(d) => {
                self.point(d.center, "center")?;
                direction(d.normal, "normal")?;
                self.length(d.radius, "radius")
            }
            Shape::Annulus(a) => {
                self.point(a.center, "center")?;
                direction(a.normal, "normal")?;
                self.length(a.outer, "outer")
            }
            Shape::Box(b) => self.point(b.min, "min").and(self.point(b.max, "max")),
            Shape::Triangle(t) => self.points(&t.vertices, "vertices"),
            Shape::SmoothTriangle(t) => {
                self.points(&t.vertices, "vertices")?;
                t.normals.iter().try_for_each(|normal| self.course(*normal, "normals"))
            }
            Shape::Cone(c) => {
                self.point(c.base, "base")?;
                self.point(c.apex, "apex")?;
                self.length(c.base_radius, "base_radius")?;
                self.length(c.apex_radius, "apex_radius")?;
                let (axis, taper) = (minus(c.apex, c.base), c.apex_radius - c.base_radius);
                let is_steep = taper * taper <= FLATTEST * FLATTEST * dot(axis, axis);
                check(is_steep, "apex_radius", "a radius that differs from the other by at most 4 times the height")
            }
            // These come one by one.
            Shape::Spheres(_) | Shape::Triangles(_) => Ok(()),
        }
    }

    pub(super) fn material(&self, material: &Material<f32>) -> Result<(), Fault> {
        if let Some(body) = &material.body {
            self.pattern(&body.color)?;
            self.amount(body.emission, "body.emission")?;
            self.amount(body.ambient, "body.ambient")?;
            self.amount(body.diffuse, "body.diffuse")?;
            let sent = brightest(&body.color) * (body.ambient + body.diffuse);
            let expected = "a colour whose product with `ambient` + `diffuse` is in range";
            check(sent <= self.amount, "body.color", expected)?;
        }
        if let Some(highlight) = &material.highlight {
            self.color(highlight.color, "highlight.color")?;
            if let Exponent::Real(s) = highlight.exponent {
                self.length(s, "highlight.exponent")?;
            }
        }
        if let Some(balance) = &material.balance {
            self.amount(balance.brightness, "balance.brightness")?;
        }
        self.interface(&material.interface)
    }

    fn interface(&self, interface: &Interface<f32>) -> Result<(), Fault> {
        match interface {
            Interface::Opaque | Interface::Mirror { .. } | Interface::Metal { .. } => Ok(()),
            Interface::Coat { index } => refraction(*index, "interface.index"),
            Interface::Constant { reflected, transmitted, medium } => {
                let sum = reflected.zip(*transmitted, |r, t| r + t).max_channel();
                check(sum <= 1.0, "interface.transmitted", "at most what is not reflected")?;
                self.medium(medium, ["interface.medium.index", "interface.medium.attenuation"])
            }
            Interface::Dielectric { medium, film } => {
                self.medium(medium, ["interface.medium.index", "interface.medium.attenuation"])?;
                self.film(film)
            }
            Interface::Conductor { index, extinction, film } => {
                conducting(*index, *extinction)?;
                self.film(film)
            }
        }
    }

    /// The fields are those of its index and its attenuation.
    pub(super) fn medium(&self, medium: &Medium<f32>, [field, other]: [&'static str; 2]) -> Result<(), Fault> {
        match medium.index {
            Index::Constant(n) => refraction(n, field)?,
            Index::Dispersive(n) => [n.r, n.g, n.b].into_iter().try_for_each(|n| refraction(n, field))?,
            Index::Profile(_) => return Err((field, "no profile in fixed point")),
        }
        let Some(Rgb { r, g, b }) = medium.attenuation else { return Ok(()) };
        [r, g, b].into_iter().try_for_each(|c| self.length(c, other))
    }

    fn film(&self, film: &Option<Film<f32>>) -> Result<(), Fault> {
        let Some(film) = film else { return Ok(()) };
        refraction(film.index, "interface.film.index")?;
        let field = "interface.film.thickness";
        let nanometres = |x: f32| check(x <= self.thickness, field, self.thickness_text);
        match film.thickness {
            Thickness::Uniform(thickness) => nanometres(thickness),
            Thickness::Gradient { from, to, origin, axis } => {
                nanometres(from).and(nanometres(to))?;
                self.points(&[origin, axis], field)
            }
            Thickness::Radial { from, to, center, radius } => {
                nanometres(from).and(nanometres(to))?;
                self.point(center, field)?;
                self.length(radius, field)
            }
        }
    }

    fn pattern(&self, pattern: &Pattern<f32>) -> Result<(), Fault> {
        let (colors, places) = parts(pattern);
        colors.into_iter().try_for_each(|color| self.color(color, "body.color"))?;
        self.points(&places, "body.color")
    }

    pub(super) fn light(&self, light: &Light<f32>) -> Result<(), Fault> {
        self.color(light.color, "color")?;
        match light.emitter {
            Emitter::Point { position } => self.point(position, "position")?,
            Emitter::Directional { towards } => self.course(towards, "towards")?,
            Emitter::Sphere { center, radius } => {
                self.point(center, "center")?;
                self.length(radius, "radius")?;
            }
            Emitter::Parallelogram { corner, edge_u, edge_v } => {
                self.point(corner, "corner")?;
                self.point(edge_u, "edge_u")?;
                self.point(edge_v, "edge_v")?;
            }
        }
        let Some(falloff) = &light.falloff else { return Ok(()) };
        check(within(falloff.constant, SHORTEST, self.coordinate), "falloff.constant", "a number of at least 1/64")?;
        self.length(falloff.linear, "falloff.linear")?;
        self.length(falloff.quadratic, "falloff.quadratic")
    }
}

/// The colours of a pattern, and its coordinates.
fn parts(pattern: &Pattern<f32>) -> ([Rgb<f32>; 2], [Vec3<f32>; 2]) {
    match *pattern {
        Pattern::Solid(color) => ([color, color], [Vec3::ZERO; 2]),
        Pattern::Checker { even, odd, u, v } => ([even, odd], [u, v]),
        Pattern::Gradient { from, to, origin, axis } => ([from, to], [origin, axis]),
        Pattern::Rings { even, odd, center, width } => ([even, odd], [center, Vec3::splat(width)]),
    }
}

fn brightest(pattern: &Pattern<f32>) -> f32 {
    let ([one, other], _) = parts(pattern);
    one.max(other).max_channel()
}

fn direction(v: Vec3<f32>, field: &'static str) -> Result<(), Fault> {
    check(within(dot(v, v), SHORTEST * SHORTEST, LONGEST * LONGEST), field, "a direction of length 1/64 to 1.5")
}

fn refraction(index: f32, field: &'static str) -> Result<(), Fault> {
    check(within(index, THINNEST, DENSEST), field, "an index of refraction from 1/2 to 4")
}

fn conducting(index: Rgb<f32>, extinction: Rgb<f32>) -> Result<(), Fault> {
    let is_held = |c: Rgb<f32>| [c.r, c.g, c.b].into_iter().all(|x| within(x, 0.0, MOST_CONDUCTING));
    check(is_held(index), "interface.index", "a number from 0 to 12")?;
    check(is_held(extinction), "interface.extinction", "a number from 0 to 12")?;
    // What divides by its square.
    let Rgb { r, g, b } = index.zip(extinction, |n, k| n * n + k * k);
    let is_large = [r, g, b].into_iter().all(|square| square >= THINNEST * THINNEST);
    check(is_large, "interface.extinction", "with `interface.index`, a complex number of size 1/2 or more")
}
