//! From what the library reads in a scene file to records.

use whit::scene::{Body, Emitter, Exponent, Full, Interface, SceneStore, Shape};
use whit::{Background, Camera, Light, Object, Pattern, Rgb, Vec3};

use crate::record::{CONE, LIGHT, LIGHTS, OBJECTS, RECORDS, Record, SMOOTH_TRIANGLE, SPHERE, TRIANGLE, VIEW};

/// Memory that the library fills while it reads.
pub struct Records {
    records: [Record; RECORDS],
    count: usize,
}

impl Records {
    pub const EMPTY: Self = Self { records: [Record::EMPTY; RECORDS], count: 0 };

    pub fn as_slice(&self) -> &[Record] {
        self.records.get(..self.count).unwrap_or_default()
    }

    fn add(&mut self, record: Record) -> Result<(), Full> {
        let place = self.records.get_mut(self.count).ok_or(Full { what: "object", capacity: OBJECTS })?;
        *place = record;
        self.count += 1;
        Ok(())
    }
}

impl SceneStore for Records {
    fn room(&self) -> (usize, usize) {
        (OBJECTS, LIGHTS)
    }

    fn restart(&mut self, camera: Camera<f32>, background: Background<f32>) {
        let mut view = Record { kind: VIEW, index: camera.half_height, ..Record::EMPTY };
        if let Background::Solid(color) = background {
            view.color = channels(color);
        }
        fill(&mut view.points, &[camera.eye, camera.target, camera.up]);
        self.count = 1;
        if let Some(first) = self.records.first_mut() {
            *first = view;
        }
    }

    fn add_light(&mut self, light: Light<f32>) -> Result<(), Full> {
        let mut record = Record { kind: LIGHT, color: channels(light.color), ..Record::EMPTY };
        if let Emitter::Point { position } = light.emitter {
            fill(&mut record.points, &[position]);
        }
        self.add(record)
    }

    fn add_object(&mut self, object: Object<'static, f32>) -> Result<(), Full> {
        let mut record = Record::EMPTY;
        surface(&mut record, &object);
        shape(&mut record, &object.shape);
        self.add(record)
    }
}

fn surface(record: &mut Record, object: &Object<'_, f32>) {
    if let Some(Body { color: Pattern::Solid(color), diffuse, .. }) = object.material.body {
        (record.color, record.diffuse) = (channels(color), diffuse);
    }
    if let Some(highlight) = object.material.highlight {
        record.specular = highlight.color.r;
        (record.exponent, record.is_integer) = match highlight.exponent {
            Exponent::Integer(n) => (n as f32, 1),
            Exponent::Real(x) => (x, 0),
        };
    }
    if let Interface::Constant { transmitted, medium, .. } = object.material.interface {
        (record.transmittance, record.index) = (transmitted.r, medium.index.at(None));
    }
}

fn shape(record: &mut Record, shape: &Shape<'_, f32>) {
    let points = &mut record.points;
    match shape {
        Shape::Sphere(sphere) => {
            record.kind = SPHERE;
            record.radii = [sphere.radius, 0.0];
            fill(points, &[sphere.center]);
        }
        Shape::Cone(cone) => {
            record.kind = CONE;
            record.radii = [cone.base_radius, cone.apex_radius];
            fill(points, &[cone.base, cone.apex]);
        }
        Shape::Triangle(triangle) => {
            record.kind = TRIANGLE;
            fill(points, &triangle.vertices);
        }
        Shape::SmoothTriangle(triangle) => {
            record.kind = SMOOTH_TRIANGLE;
            fill(points, &triangle.vertices);
            fill(&mut points[3..], &triangle.normals);
        }
        // No other is in a file.
        _ => {}
    }
}

fn fill(places: &mut [[f32; 3]], points: &[Vec3<f32>]) {
    for (place, point) in places.iter_mut().zip(points) {
        *place = [point.x, point.y, point.z];
    }
}

fn channels(color: Rgb<f32>) -> [f32; 3] {
    [color.r, color.g, color.b]
}
