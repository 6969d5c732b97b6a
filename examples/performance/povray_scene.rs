//! Scenes of whit, for POV-Ray.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use whit::scene::{Emitter, Exponent, Extent, Index, Interface, Object};
use whit::{Background, Light, Material, Pattern, Rgb, Scene, Shape, Vec3};

/// POV-Ray counts the eye's ray as the first level.
const LEVELS: u8 = 6;

/// Writes a scene of what has its like in POV-Ray. There, both sides of a surface are seen, and light gets through what is
/// transparent.
pub fn write(path: &Path, scene: &Scene<'_, f32>) -> Result<(), String> {
    let text = text(scene).ok_or("the scene has things in it that are not written for POV-Ray")?;
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

fn text(scene: &Scene<'_, f32>) -> Option<String> {
    let mut text = view(scene)?;
    scene.lights.iter().try_for_each(|light| writeln!(text, "{}", lamp(light)?).ok())?;
    let mut skins = Vec::new();
    for group in scene.objects.chunk_by(are_of_one_mesh) {
        let [first, ..] = group else { continue };
        let number = match skins.iter().position(|skin| *skin == first.material) {
            Some(number) => number,
            None => {
                writeln!(text, "{}", skin(skins.len(), &first.material)?).ok()?;
                skins.push(first.material);
                skins.len() - 1
            }
        };
        let wear = format!("texture {{ Skin{number} }} interior {{ Inside{number} }}");
        let shapes = group.iter().map(|object| shape(&object.shape)).collect::<Option<Vec<_>>>()?;
        match &shapes[..] {
            [(kind, numbers)] if !is_triangle(first) => writeln!(text, "{kind} {{ {numbers} {wear} }}").ok()?,
            triangles => {
                text += "mesh {\n";
                triangles.iter().try_for_each(|(kind, numbers)| writeln!(text, "{kind} {{ {numbers} }}").ok())?;
                writeln!(text, "{wear} }}").ok()?;
            }
        }
    }
    Some(text)
}

fn is_triangle(object: &Object<'_, f32>) -> bool {
    matches!(object.shape, Shape::Triangle(_) | Shape::SmoothTriangle(_))
}

fn are_of_one_mesh(one: &Object<'_, f32>, next: &Object<'_, f32>) -> bool {
    is_triangle(one) && is_triangle(next) && one.material == next.material
}

/// The settings, the background, and a right-handed camera whose field reaches to the middles of the outer pixels.
fn view(scene: &Scene<'_, f32>) -> Option<String> {
    let camera = scene.camera;
    let (Background::Solid(sky), Extent::PixelCentres) = (scene.background, camera.extent) else { return None };
    Some(format!(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {LEVELS} }}\nbackground {{ rgb {} }}\n\
         #declare Half = {} * image_height / (image_height - 1);\ncamera {{ location {} sky {} up z right -x \
         angle 2 * degrees(atan2(Half, 1)) look_at {} }}\n",
        rgb(sky),
        camera.half_height,
        vector(camera.eye),
        vector(camera.up),
        vector(camera.target)
    ))
}

fn lamp(light: &Light<f32>) -> Option<String> {
    let (Emitter::Point { position }, None) = (light.emitter, light.falloff) else { return None };
    Some(format!("light_source {{ {} rgb {} }}", vector(position), rgb(light.color)))
}

/// Declares a material.
fn skin(number: usize, material: &Material<f32>) -> Option<String> {
    let (color, diffuse) = match material.body {
        Some(body) if body.emission == 0.0 && body.ambient == 0.0 => {
            let Pattern::Solid(color) = body.color else { return None };
            (color, body.diffuse)
        }
        None => (Rgb::BLACK, 0.0),
        Some(_) => return None,
    };
    let (reflected, transmitted, index) = match material.interface {
        Interface::Opaque => (Rgb::BLACK, Rgb::BLACK, 1.0),
        Interface::Mirror { reflected } => (reflected, Rgb::BLACK, 1.0),
        Interface::Constant { reflected, transmitted, medium } => {
            let (Index::Constant(index), None) = (medium.index, medium.attenuation) else { return None };
            (reflected, transmitted, index)
        }
        _ => return None,
    };
    let highlight = match material.highlight.map(|highlight| (highlight.color.r, highlight.exponent)) {
        Some((share, Exponent::Real(exponent))) => format!("specular {share} roughness 1/{exponent}"),
        Some((share, Exponent::Integer(exponent))) => format!("specular {share} roughness 1/{exponent}"),
        None => String::new(),
    };
    // There, what is transmitted is taken from the body's light.
    let (transmitted, left) = (transmitted.r, 1.0 - transmitted.r);
    let diffuse = if left > 0.0 { diffuse / left } else { 0.0 };
    Some(format!(
        "#declare Skin{number} = texture {{ pigment {{ rgb {} transmit {transmitted} }} finish {{ ambient 0 diffuse \
         {diffuse} {highlight} reflection {} }} }}\n#declare Inside{number} = interior {{ ior {index} }}",
        rgb(color),
        reflected.r
    ))
}

/// What a shape is called, and its numbers.
fn shape(shape: &Shape<'_, f32>) -> Option<(&'static str, String)> {
    let list = |vectors: &[Vec3<f32>]| vectors.iter().map(|v| vector(*v)).collect::<Vec<_>>().join(", ");
    Some(match shape {
        Shape::Sphere(s) => ("sphere", format!("{}, {}", vector(s.center), s.radius.abs())),
        Shape::Plane(p) => ("plane", format!("{}, {}", vector(p.normal), p.point.dot(p.normal))),
        Shape::Cone(c) if !c.capped => {
            let (base, apex) = (vector(c.base), vector(c.apex));
            ("cone", format!("{base}, {}, {apex}, {} open", c.base_radius.abs(), c.apex_radius.abs()))
        }
        Shape::Triangle(t) => ("triangle", list(&t.vertices)),
        Shape::SmoothTriangle(t) => {
            let pairs: Vec<_> = t.vertices.into_iter().zip(t.normals).flat_map(|(v, n)| [v, n]).collect();
            ("smooth_triangle", list(&pairs))
        }
        _ => return None,
    })
}

fn vector(v: Vec3<f32>) -> String {
    format!("<{},{},{}>", v.x, v.y, v.z)
}

fn rgb(color: Rgb<f32>) -> String {
    format!("<{},{},{}>", color.r, color.g, color.b)
}
