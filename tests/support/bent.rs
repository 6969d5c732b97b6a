//! Small scenes in which light is bent: by each law, by each method, around a black hole.
#![allow(unreachable_pub, dead_code)]

use whit::scene::{BlackHole, Law, Level, Medium, Method, Profile, Steps};
use whit::{Background, Camera, Light, Material, Object, Pattern, Rgb, Scene, Shape, Vec3};

const UP: Vec3<f32> = Vec3::new(0.0, 1.0, 0.0);
const EYE: Vec3<f32> = Vec3::new(0.5, 1.4, 4.5);
const CAMERA: Camera<f32> = Camera::look_at(EYE, Vec3::new(0.0, 0.6, 0.0), UP, 45.0);
const STARS: Background<f32> =
    Background::Stars { sky: Rgb::new(0.1, 0.2, 0.4), brightness: 3.0, cells: 16, radius: 0.3 };
const VALUES: [f32; 7] = [0.3, 0.22, 0.25, 0.15, 0.1, 0.08, 0.05];

/// Between levels of about 0 and 3, each with a large change.
const LAWS: [(&str, Law<'static, f32>); 6] = [
    ("polynomial", Law::Polynomial { constant: 0.6, linear: -0.3, quadratic: 0.05 }),
    ("exponential", Law::Exponential { far: 1.0, excess: 0.3, scale: 0.7 }),
    ("thermal", Law::Thermal { excess: 0.4, ratio: 0.8, scale: 0.5 }),
    ("inversion", Law::Inversion { below: 0.3, above: 0.05, height: 0.8, thickness: 0.2 }),
    ("fish-eye", Law::FishEye { index: 1.7, radius: 3.0 }),
    ("table", Law::Table { spacing: 0.5, values: &VALUES }),
];

/// Layers, steps of one length, and controlled ones.
pub const METHODS: [(&str, Method<f32>); 3] = [
    ("layers", Method::Layers { thickness: 0.11 }),
    ("fixed", Method::Steps(Steps::Fixed { length: 0.13 })),
    ("controlled", Method::Steps(Steps::Controlled { tolerance: 1e-4 })),
];

/// Every law by every method, over flat and over round ground, with straight and with bent shadow rays; and black holes.
pub fn scenes() -> Vec<(String, Scene<'static, f32>)> {
    let mut all = Vec::new();
    for (i, (law_name, law)) in LAWS.into_iter().enumerate() {
        for (j, (method_name, method)) in METHODS.into_iter().enumerate() {
            let scene = graded(law, method, if (i + j) % 2 == 0 { FLAT } else { ROUND });
            let scene = if (i + j / 2) % 2 == 0 { scene.with_bent_shadows() } else { scene };
            // Nothing is left of light from infinitely far where the air attenuates it.
            let haze = Medium::graded(0).with_attenuation(Rgb::new(0.05, 0.03, 0.02));
            let scene = if j == 2 { scene.with_medium(haze) } else { scene };
            all.push((format!("{law_name} by {method_name}"), scene));
        }
    }
    for (name, steps) in [
        ("hole in fixed steps", Steps::Fixed { length: 0.05 }),
        ("hole in controlled steps", Steps::Controlled { tolerance: 1e-5 }),
    ] {
        all.push((name.to_owned(), around_hole(steps)));
        all.push((format!("{name}, bent shadows"), around_hole(steps).with_bent_shadows()));
    }
    all
}

const FLAT: Level<f32> = Level::Height { origin: Vec3::ZERO, up: UP };
const ROUND: Level<f32> = Level::Radius { center: Vec3::new(0.0, -7.0, 0.0), radius: 7.0 };

/// Things on the ground in a medium of such a profile, with a lens among them.
pub fn graded(law: Law<'static, f32>, method: Method<f32>, level: Level<f32>) -> Scene<'static, f32> {
    let lens = Vec3::new(-0.7, 0.8, 0.6);
    let profiles = vec![
        Profile { level, from: 0.0, to: 3.0, law, method },
        Profile {
            level: Level::Radius { center: lens, radius: 0.0 },
            from: 0.0,
            to: 0.6,
            law: Law::luneburg(0.6),
            method: match method {
                Method::Layers { .. } => Method::Layers { thickness: 0.06 },
                steps @ Method::Steps(_) => steps,
            },
        },
    ];
    let rings = Pattern::Rings { even: Rgb::grey(0.9), odd: Rgb::grey(0.3), center: Vec3::ZERO, width: 0.4 };
    let objects = vec![
        Object::new(Shape::plane(Vec3::ZERO, UP), Material::patterned(rings)),
        Object::new(Shape::sphere(lens, 0.6), Material::transparent(Medium::graded(1))),
        Object::new(Shape::annulus(Vec3::new(0.9, 0.5, 0.0), EYE, 0.2, 0.5), Material::mirror(Rgb::grey(0.8))),
        Object::new(
            Shape::axis_box(Vec3::new(0.3, 0.0, 0.9), Vec3::new(0.7, 0.5, 1.3)),
            Material::matte(Rgb::new(0.8, 0.4, 0.2)),
        ),
        Object::new(Shape::sphere(Vec3::new(-0.2, 0.3, 1.6), 0.25), Material::dielectric(1.5)),
    ];
    Scene::new(CAMERA, STARS)
        .with_objects(objects.leak())
        .with_lights(&LIGHTS)
        .with_profiles(profiles.leak())
        .with_medium(Medium::graded(0))
}

const LIGHTS: [Light<f32>; 2] = [
    Light::point(Vec3::new(2.0, 2.5, 3.0), Rgb::grey(0.8)),
    Light::directional(Vec3::new(-1.0, 1.5, 0.5), Rgb::grey(0.4)),
];

/// A hole with a disc around it, and a ball that is seen past it.
pub fn around_hole(steps: Steps<f32>) -> Scene<'static, f32> {
    let center = Vec3::new(0.1, 0.7, 0.2);
    let hole = BlackHole { center, mass: 0.12, steps };
    let rings = Pattern::Rings { even: Rgb::new(0.9, 0.6, 0.2), odd: Rgb::grey(0.3), center, width: 0.1 };
    let objects = vec![
        Object::new(Shape::annulus(center, Vec3::new(0.1, 1.0, 0.3), 0.7, 1.4), Material::patterned(rings)),
        Object::new(Shape::sphere(Vec3::new(-0.4, 0.8, -3.0), 0.9), Material::matte(Rgb::new(0.2, 0.5, 0.8))),
        Object::new(Shape::sphere(Vec3::new(1.1, 0.8, 1.4), 0.4), Material::dielectric(1.5)),
    ];
    Scene::new(CAMERA, STARS).with_objects(objects.leak()).with_lights(&LIGHTS).with_black_hole(hole)
}
