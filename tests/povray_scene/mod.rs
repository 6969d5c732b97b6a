//! Scenes that POV-Ray has rendered, with its pictures.
//!
//! POV-Ray's coordinates are left-handed: z is turned over. Its `ambient` is `emission` here, its `specular` with a
//! roughness of 1/s a Blinn highlight to the power s, its `phong` a Phong highlight; neither takes the surface's colour.
//! It ends branches in black, and its `max_trace_level` counts eye rays too: it is one more than the depth here. A
//! `fade_power` of 1001 leaves e^(−(1 − fade_color)·x/fade_distance) of the light after a distance x.
#![allow(dead_code, unreachable_pub, missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![allow(clippy::indexing_slicing)]

use whit::scene::{
    Background, Camera, Exponent, Highlight, Interface, Light, Lobe, Material, Medium, Object, Scene, Shape,
};
use whit::{Rgb, Vec3};

/// `direction` of length 1, `up` of length 1: half the height of the picture is 0.5 at distance 1.
const CAMERA: Camera<f32> =
    Camera::with_half_height(Vec3::new(0.0, 1.0, 6.0), Vec3::new(0.0, 1.0, 5.0), Vec3::new(0.0, 1.0, 0.0), 0.5);

const FLOOR: Object<'static, f32> = Object::new(
    Shape::plane(Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0)),
    Material::matte(Rgb::new(0.8, 0.8, 0.7)).with_shares(0.1, 0.0, 0.7),
);

const A_DIRECT_OBJECTS: &[Object<'static, f32>] = &[
    FLOOR,
    Object::new(
        Shape::sphere(Vec3::new(-0.8, 1.0, 0.0), 1.0),
        Material::matte(Rgb::new(0.9, 0.2, 0.1)).with_shares(0.1, 0.0, 0.6).with_highlight(Rgb::grey(0.4), 50),
    ),
    Object::new(
        Shape::sphere(Vec3::new(1.1, 0.7, 1.0), 0.7),
        Material {
            highlight: Some(Highlight { color: Rgb::grey(0.5), lobe: Lobe::Phong, exponent: Exponent::Integer(40) }),
            ..Material::matte(Rgb::new(0.1, 0.5, 0.9)).with_shares(0.05, 0.0, 0.5)
        },
    ),
];

const SUN: Light<f32> = Light::point(Vec3::new(5.0, 8.0, 6.0), Rgb::new(0.8, 0.7, 0.6));

const A_DIRECT_LIGHTS: &[Light<f32>] = &[SUN, Light::point(Vec3::new(-6.0, 4.0, 3.0), Rgb::new(0.2, 0.3, 0.4))];

/// Two spheres on a plane with two lights, without branches: diffuse light, highlights and shadows. 160 × 120 pixels.
pub const A_DIRECT: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(Rgb::new(0.2, 0.3, 0.5)))
    .with_objects(A_DIRECT_OBJECTS)
    .with_lights(A_DIRECT_LIGHTS);

const BALL: Shape<'static, f32> = Shape::sphere(Vec3::new(-0.8, 1.0, 0.0), 1.0);
const BOX: Shape<'static, f32> = Shape::axis_box(Vec3::new(0.613, 0.107, -0.013), Vec3::new(1.807, 1.317, 1.211));

const C_GLASS_OBJECTS: &[Object<'static, f32>] = &[
    FLOOR,
    Object::new(
        Shape::sphere(Vec3::new(0.4, 0.8, -3.0), 0.8),
        Material::matte(Rgb::new(0.9, 0.2, 0.1)).with_shares(0.2, 0.0, 0.6),
    ),
    Object::new(BALL, Material::dielectric(1.5)).without_shadow(),
    Object::new(BOX, Material::dielectric(1.33)).without_shadow(),
];

/// A ball and a box of clear glass with Fresnel reflection, and what is seen through them. 160 × 120 pixels.
pub const C_GLASS: Scene<'static, f32> =
    Scene::new(CAMERA, Background::Solid(Rgb::new(0.2, 0.3, 0.5))).with_objects(C_GLASS_OBJECTS).with_lights(&[SUN]);

/// Glass that reflects only what cannot leave it.
const fn tinted(index: f32, attenuation: Rgb<f32>) -> Material<f32> {
    Material::dielectric(1.0).with_interface(Interface::Constant {
        reflected: Rgb::BLACK,
        transmitted: Rgb::WHITE,
        medium: Medium::new(index).with_attenuation(attenuation),
    })
}

const D_BEER_FADE_OBJECTS: &[Object<'static, f32>] = &[
    FLOOR,
    Object::new(BALL, tinted(1.5, Rgb::new(0.2, 0.8, 1.6))).without_shadow(),
    Object::new(BOX, tinted(1.33, Rgb::new(0.8, 0.3, 0.1))).without_shadow(),
];

/// A ball and a box of coloured glass. 160 × 120 pixels.
pub const D_BEER_FADE: Scene<'static, f32> =
    Scene::new(CAMERA, Background::Solid(Rgb::grey(0.9))).with_objects(D_BEER_FADE_OBJECTS).with_lights(&[SUN]);

/// Bounces in POV-Ray's pictures of [`C_GLASS`] and [`D_BEER_FADE`].
pub const DEPTH: u32 = 11;

/// A picture in linear values.
pub struct Picture {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<[f64; 3]>,
}

/// POV-Ray's picture of [`A_DIRECT`], in steps of 1/65535.
pub fn a_direct_picture() -> Picture {
    read_ppm(include_bytes!("../data/povray/a_direct.ppm"))
}

/// The same of [`C_GLASS`].
pub fn c_glass_picture() -> Picture {
    read_ppm(include_bytes!("../data/povray/c_glass.ppm"))
}

/// The same of [`D_BEER_FADE`].
pub fn d_beer_fade_picture() -> Picture {
    read_ppm(include_bytes!("../data/povray/d_beer_fade.ppm"))
}

/// A binary Portable Pixmap of two bytes per value.
fn read_ppm(bytes: &[u8]) -> Picture {
    let mut rest = bytes;
    let mut header = Vec::new();
    while header.len() < 4 {
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap();
        let line = std::str::from_utf8(&rest[..end]).unwrap();
        header.extend(line.split('#').next().unwrap().split_whitespace());
        rest = &rest[end + 1..];
    }
    let [magic, width, height, largest] = header[..] else { panic!("header of {} words", header.len()) };
    assert_eq!((magic, largest), ("P6", "65535"));
    let (width, height) = (width.parse().unwrap(), height.parse().unwrap());
    let values: Vec<_> =
        rest.chunks_exact(2).map(|pair| f64::from(u16::from_be_bytes([pair[0], pair[1]])) / 65535.0).collect();
    let pixels: Vec<_> = values.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect();
    assert_eq!(pixels.len(), width as usize * height as usize);
    Picture { width, height, pixels }
}
