//! The scene of Andrew Kensler's ray tracer on a business card.

use crate::math::{Rgb, Vec3};
use crate::scene::{
    Aperture, Background, Body, Camera, Emitter, Exponent, Highlight, Interface, Lens, Light, Lobe, Material, Object,
    PackedSpheres, Pattern, Scene, Shape, Sphere, Tone,
};

/// The letters "aek" in 49 mirrored spheres over a checkered floor, with a soft shadow and depth of field; z is up.
///
/// Its values are what the display shows: 13/255 for black, no gamma. The original takes 64 samples a pixel at 512×512
/// and does not limit the depth; 15 bounces are reached.
pub const CARD: Scene<'static, f32> = Scene {
    tone: Tone::Display { gain: 3.5 * 64.0 / 255.0, lift: 13.0 / 255.0 },
    ..Scene::new(CAMERA, SKY).with_objects(&OBJECTS).with_lights(&LIGHTS)
};

const UP: Vec3<f32> = Vec3::new(0.0, 0.0, 1.0);

const CAMERA: Camera<f32> =
    Camera::with_half_height(Vec3::new(17.0, 16.0, 8.0), Vec3::new(11.0, 0.0, 8.0), UP, 256.0 * 0.002)
        .with_lens(Lens { aperture: Aperture::Square { side: 99.0 * 0.002 }, focus: 16.0 });

const SKY: Background<f32> = Background::Sky { horizon: Rgb::new(0.7, 0.6, 1.0), up: UP };

/// The rows of the letters from the bottom up; bit k is a sphere at x = k.
const LETTERS: [u32; 9] = [247_570, 280_596, 280_600, 249_748, 18_578, 18_577, 231_184, 16, 16];

const BALLS: PackedSpheres<f32, 1, 7> = PackedSpheres::new(&balls());

#[allow(clippy::indexing_slicing)] // There are 49 set bits; one more would not compile.
const fn balls() -> [Sphere<f32>; 49] {
    let mut balls = [Sphere { center: Vec3::new(0.0_f32, 0.0, 0.0), radius: 1.0 }; 49];
    let (mut count, mut row) = (0, 0);
    while row < LETTERS.len() {
        let mut k = 0;
        while k < 19 {
            if LETTERS[row] >> k & 1 == 1 {
                balls[count].center = Vec3::new(k as f32, 0.0, row as f32 + 4.0);
                count += 1;
            }
            k += 1;
        }
        row += 1;
    }
    balls
}

const BALL: Material<f32> = Material {
    body: None,
    highlight: Some(Highlight { color: Rgb::grey(1.0), lobe: Lobe::Phong, exponent: Exponent::Integer(99) }),
    interface: Interface::Mirror { reflected: Rgb::grey(0.5) },
    balance: None,
};

const FLOOR: Material<f32> = Material {
    body: Some(Body {
        color: Pattern::Checker {
            even: Rgb::new(3.0, 3.0, 3.0),
            odd: Rgb::new(3.0, 1.0, 1.0),
            u: Vec3::new(0.2, 0.0, 0.0),
            v: Vec3::new(0.0, 0.2, 0.0),
        },
        emission: 0.1,
        ambient: 0.0,
        diffuse: 0.2,
    }),
    highlight: None,
    interface: Interface::Opaque,
    balance: None,
};

const OBJECTS: [Object<'static, f32>; 2] =
    [Object::new(Shape::plane(Vec3::ZERO, UP), FLOOR), Object::new(Shape::Spheres(BALLS.view()), BALL)];

const LIGHTS: [Light<f32>; 1] = [Light {
    emitter: Emitter::Parallelogram {
        corner: Vec3::new(9.0, 9.0, 16.0),
        edge_u: Vec3::new(1.0, 0.0, 0.0),
        edge_v: Vec3::new(0.0, 1.0, 0.0),
    },
    color: Rgb::grey(1.0),
    falloff: None,
}];
