//! Entities: what one or several lines of a file say.

use super::lines::{Line, Lines};
use super::polygon::{Polygon, Vertex};
use super::surface::Surface;
use super::view::View;
use super::{Found, MAX_VERTICES, NffError};
use crate::math::{Rgb, Vec3};
use crate::scene::{Light, Object, Shape, SmoothTriangle, validate};

/// A part of a scene.
#[allow(clippy::large_enum_variant)] // There is no heap, and an item is used at once.
pub(super) enum Item {
    View(View),
    Background(Rgb<f32>),
    /// A light without a colour of its own is as bright as the number of lights asks for.
    Light {
        position: Vec3<f32>,
        color: Option<Rgb<f32>>,
    },
    Object(Object<'static, f32>),
}

/// Reads a file item by item, in the memory of one polygon.
pub(super) struct Reader<'t> {
    lines: Lines<'t>,
    /// Where the last item began.
    line: usize,
    surface: Option<Surface>,
    /// The polygon whose triangles are the next items.
    polygon: Polygon,
    /// Whether it has normals.
    is_patch: bool,
}

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { lines: Lines::new(text), line: 1, surface: None, polygon: Polygon::EMPTY, is_patch: false }
    }

    /// Goes back to the beginning, from the end of the text.
    pub(super) fn start_again(&mut self, text: &'t str) {
        (self.lines, self.line, self.surface) = (Lines::new(text), 1, None);
    }

    /// The line where the last item began.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// An error at the end of the file.
    pub(super) fn missing(&self, expected: &'static str) -> NffError {
        NffError::unexpected(self.lines.last_number(), expected, Found::EndOfFile)
    }

    /// The next item; `None` at the end of the file.
    pub(super) fn next_item(&mut self) -> Result<Option<Item>, NffError> {
        loop {
            if let Some(object) = self.next_triangle() {
                return Ok(Some(Item::Object(object)));
            }
            let Some(line) = self.lines.next() else { return Ok(None) };
            self.line = line.number;
            if let Some(item) = self.entity(line)? {
                return Ok(Some(item));
            }
        }
    }

    /// The next triangle of the polygon.
    fn next_triangle(&mut self) -> Option<Object<'static, f32>> {
        let surface = self.surface.as_ref()?;
        let corner = self.polygon.next_triangle()?;
        let vertices = corner.map(|vertex| vertex.position);
        Some(surface.object(if self.is_patch {
            Shape::SmoothTriangle(SmoothTriangle { vertices, normals: corner.map(|vertex| vertex.normal) })
        } else {
            let [a, b, c] = vertices;
            Shape::triangle(a, b, c)
        }))
    }

    /// The entity that starts with `line`: its item, if it is one at once.
    fn entity(&mut self, mut line: Line<'t>) -> Result<Option<Item>, NffError> {
        let number = line.number;
        let word = line.word().unwrap_or_default();
        match word {
            "v" => {
                line.end()?;
                Ok(Some(Item::View(View::read(&mut self.lines, number)?)))
            }
            "b" => Ok(Some(Item::Background(background(line)?))),
            "l" => Ok(Some(light(line)?)),
            "f" => {
                self.surface = Some(Surface::read(line)?);
                Ok(None)
            }
            "s" | "c" | "p" | "pp" => self.object(word, line),
            _ => Err(NffError::unexpected(number, "one of b, v, l, f, s, c, p, pp", Found::Word(word.into()))),
        }
    }

    fn object(&mut self, word: &str, line: Line<'t>) -> Result<Option<Item>, NffError> {
        let number = line.number;
        let Some(surface) = self.surface else {
            let expected = "a surface `f` before the first object";
            return Err(NffError::unexpected(number, expected, Found::Word(word.into())));
        };
        let shape = match word {
            "s" => sphere(line)?,
            "c" => self.cone(line)?,
            _ => {
                self.polygon(word == "pp", line)?;
                return Ok(None);
            }
        };
        let object = surface.object(shape);
        object.check().map_err(NffError::out_of_range(number))?;
        Ok(Some(Item::Object(object)))
    }

    /// Its circles are on lines of their own or, as the programs of the Standard Procedural Databases write them, on
    /// the line of the `c`.
    fn cone(&mut self, mut line: Line<'t>) -> Result<Shape<'static, f32>, NffError> {
        let ((base, base_radius), (apex, apex_radius)) = if line.is_at_end() {
            (self.circle()?, self.circle()?)
        } else {
            let circles = ((line.point()?, line.number("radius")?), (line.point()?, line.number("radius")?));
            line.end()?;
            circles
        };
        Ok(Shape::cone(base, base_radius, apex, apex_radius))
    }

    fn circle(&mut self) -> Result<(Vec3<f32>, f32), NffError> {
        let mut line = self.lines.expect("a line `x y z radius` of a cone")?;
        let circle = (line.point()?, line.number("radius")?);
        line.end()?;
        Ok(circle)
    }

    fn polygon(&mut self, is_patch: bool, mut line: Line<'t>) -> Result<(), NffError> {
        let number = line.number;
        let count = line.whole("number of vertices", "a whole number of at least 3", 3)?;
        line.end()?;
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        if count > MAX_VERTICES {
            return Err(NffError::no_room(number, "vertices", count, MAX_VERTICES));
        }
        self.is_patch = is_patch;
        self.polygon.clear();
        for _ in 0..count {
            let vertex = self.vertex()?;
            self.polygon.push(vertex);
        }
        self.polygon.close();
        Ok(())
    }

    fn vertex(&mut self) -> Result<Vertex, NffError> {
        let expected = if self.is_patch { "a vertex `x y z nx ny nz`" } else { "a vertex `x y z`" };
        let mut line = self.lines.expect(expected)?;
        let number = line.number;
        let position = line.point()?;
        validate::point(position, "vertex").map_err(NffError::out_of_range(number))?;
        let normal = if self.is_patch { line.vector(["nx", "ny", "nz"])? } else { Vec3::ZERO };
        if self.is_patch {
            validate::direction(normal, "normal").map_err(NffError::out_of_range(number))?;
        }
        line.end()?;
        Ok(Vertex { position, normal })
    }
}

fn background(mut line: Line<'_>) -> Result<Rgb<f32>, NffError> {
    let number = line.number;
    let color = line.color()?;
    line.end()?;
    validate::color(color, "background").map_err(NffError::out_of_range(number))?;
    Ok(color)
}

fn light(mut line: Line<'_>) -> Result<Item, NffError> {
    let number = line.number;
    let position = line.point()?;
    let color = if line.is_at_end() { None } else { Some(line.color()?) };
    line.end()?;
    let light = Light::point(position, color.unwrap_or(Rgb::WHITE));
    light.check().map_err(NffError::out_of_range(number))?;
    Ok(Item::Light { position, color })
}

fn sphere(mut line: Line<'_>) -> Result<Shape<'static, f32>, NffError> {
    let (center, radius) = (line.point()?, line.number("radius")?);
    line.end()?;
    Ok(Shape::sphere(center, radius))
}
