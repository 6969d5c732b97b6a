//! From records to a scene, as the library's reader makes them of a file.

use whit::scene::{Exponent, Extent, Highlight, Interface, Lobe, Medium, Shape, SmoothTriangle};
use whit::{Background, Camera, Light, Material, Object, Real, Rgb, Scene, Vec3};

use crate::Number;
use crate::memory::empty_scene;
use crate::record::{CONE, LIGHT, Record, SMOOTH_TRIANGLE, SPHERE, TRIANGLE};

/// The scene that a list of records describes; `None` when it is empty or too long.
pub fn scene(records: &[Record]) -> Option<Scene<'static, Number>> {
    let (view, rest) = records.split_first()?;
    let [eye, target, up, ..] = points(view);
    let camera = Camera::with_half_height(eye, target, up, Number::from_f32(view.index));
    let camera = Camera { extent: Extent::PixelCentres, ..camera };
    let scene = empty_scene(camera, Background::Solid(color(view.color)));
    for record in rest {
        if record.kind == LIGHT {
            let [position, ..] = points(record);
            scene.add_light(Light::point(position, color(record.color))).ok()?;
        } else {
            scene.add_object(object(record)?).ok()?;
        }
    }
    Some(scene.as_scene())
}

fn object(record: &Record) -> Option<Object<'static, Number>> {
    let [a, b, c, normal_a, normal_b, normal_c] = points(record);
    let [base, apex] = record.radii.map(Number::from_f32);
    let shape = match record.kind {
        SPHERE => Shape::sphere(a, base),
        CONE => Shape::cone(a, base, b, apex),
        TRIANGLE => Shape::triangle(a, b, c),
        SMOOTH_TRIANGLE => {
            Shape::SmoothTriangle(SmoothTriangle { vertices: [a, b, c], normals: [normal_a, normal_b, normal_c] })
        }
        _ => return None,
    };
    let object = Object::new(shape, material(record));
    Some(if record.transmittance > 0.0 { object } else { object.one_sided() })
}

fn material(record: &Record) -> Material<Number> {
    let number = Number::from_f32;
    let mut material =
        Material::matte(color(record.color)).with_shares(Number::ZERO, Number::ZERO, number(record.diffuse));
    if record.diffuse == 0.0 {
        material.body = None;
    }
    let reflected = Rgb::grey(number(record.specular));
    if record.specular > 0.0 {
        let exponent = match record.is_integer {
            0 => Exponent::Real(number(record.exponent)),
            _ => Exponent::Integer(record.exponent as u32),
        };
        material.highlight = Some(Highlight { color: reflected, lobe: Lobe::Blinn, exponent });
        material.interface = Interface::Mirror { reflected };
    }
    if record.transmittance > 0.0 {
        let transmitted = Rgb::grey(number(record.transmittance));
        material.interface = Interface::Constant { reflected, transmitted, medium: Medium::new(number(record.index)) };
    }
    material
}

fn points(record: &Record) -> [Vec3<Number>; 6] {
    record.points.map(|point| {
        let [x, y, z] = point.map(Number::from_f32);
        Vec3::new(x, y, z)
    })
}

fn color(channels: [f32; 3]) -> Rgb<Number> {
    let [r, g, b] = channels.map(Number::from_f32);
    Rgb::new(r, g, b)
}
