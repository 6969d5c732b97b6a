//! The scene of the flake, for POV-Ray.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use whit::scene::{Emitter, Exponent, Extent, Interface};
use whit::{Background, Pattern, Rgb, Shape, Vec3, scenes};

/// POV-Ray counts the eye's ray as the first level.
const LEVELS: u8 = 6;

/// Writes the scene of the built-in flake around other spheres, of four numbers each.
pub fn write(path: &Path, spheres: &[[f32; 4]]) -> Result<(), String> {
    let text = text(spheres).ok_or("the flake has other things in it now than are written for POV-Ray")?;
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

fn text(spheres: &[[f32; 4]]) -> Option<String> {
    let scene = scenes::FLAKE;
    let [floor, ball] = scene.objects else { return None };
    let Shape::Plane(plane) = floor.shape else { return None };
    let (Background::Solid(sky), Extent::PixelCentres) = (scene.background, scene.camera.extent) else { return None };
    let (ground, skin) = (floor.material.body?, ball.material.body?);
    let (Pattern::Solid(of_ground), Pattern::Solid(of_skin)) = (ground.color, skin.color) else { return None };
    let (highlight, Interface::Mirror { reflected }) = (ball.material.highlight?, ball.material.interface) else {
        return None;
    };
    let Exponent::Real(exponent) = highlight.exponent else { return None };
    let camera = scene.camera;
    let mut text = format!(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {LEVELS} }}\nbackground {{ rgb {} }}\n",
        rgb(sky)
    );
    // A right-handed camera whose field reaches to the middles of the outer pixels.
    let _ = writeln!(
        text,
        "#declare Half = {} * image_height / (image_height - 1);\ncamera {{ location {} sky {} up z right -x \
         angle 2 * degrees(atan2(Half, 1)) look_at {} }}",
        camera.half_height,
        vector(camera.eye),
        vector(camera.up),
        vector(camera.target)
    );
    for light in scene.lights {
        let Emitter::Point { position } = light.emitter else { return None };
        let _ = writeln!(text, "light_source {{ {} rgb {} }}", vector(position), rgb(light.color));
    }
    let _ = writeln!(
        text,
        "plane {{ {}, {} pigment {{ rgb {} }} finish {{ ambient 0 diffuse {} }} }}",
        vector(plane.normal),
        plane.point.dot(plane.normal),
        rgb(of_ground),
        ground.diffuse
    );
    let _ = writeln!(
        text,
        "#declare Skin = texture {{ pigment {{ rgb {} }} finish {{ ambient 0 diffuse {} specular {} roughness \
         1/{exponent} reflection {} }} }}",
        rgb(of_skin),
        skin.diffuse,
        highlight.color.r,
        reflected.r
    );
    for [x, y, z, radius] in spheres {
        let _ = writeln!(text, "sphere {{ <{x},{y},{z}>, {radius} texture {{ Skin }} }}");
    }
    Some(text)
}

fn vector(v: Vec3<f32>) -> String {
    format!("<{},{},{}>", v.x, v.y, v.z)
}

fn rgb(color: Rgb<f32>) -> String {
    format!("<{},{},{}>", color.r, color.g, color.b)
}
