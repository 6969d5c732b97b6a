//! The sun at the horizon.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, Camera, Law, Level, Light, Material, Medium, Method, Object, Pattern, Profile, Scene, Shape, Steps,
    Triangle,
};

/// The sun just over the sea, flattened by the atmosphere.
///
/// The air gets thinner with the height, by a factor of e in 8 km, and bends light around the Earth: by half a degree at the
/// horizon, and by less above. The lower rim of the sun is lifted more than the upper one, so that its disc is flatter than it
/// is wide. Without the air this sun would be below the horizon. One unit is a kilometre, and all is in its true size, the
/// Earth, a ship that is 7 km away, gulls at 200 m, but the sun, which is as near as is far enough and as wide as it looks.
pub const SUNSET: Scene<'static, f32> = Scene::new(CAMERA, Background::Solid(DUSK))
    .with_objects(&OBJECTS)
    .with_lights(&LIGHTS)
    .with_profiles(&PROFILES)
    .with_medium(Medium::graded(0));

/// Of the Earth.
const RADIUS: f32 = 6371.0;
const CENTER: Vec3<f32> = Vec3::new(0.0, -RADIUS, 0.0);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(0.0, 0.02, 0.0), Vec3::new(0.0, 0.022, -1.0), UP, 1.4);

const PROFILES: [Profile<'static, f32>; 1] = [Profile {
    level: Level::Radius { center: CENTER, radius: RADIUS },
    from: -1.0,
    to: 100.0,
    law: Law::Exponential { far: 1.0, excess: 2.8e-4, scale: 8.0 },
    method: Method::Steps(Steps::Controlled { tolerance: 1e-6 }),
}];

const DUSK: Rgb<f32> = Rgb::new(0.5, 0.3, 0.25);

const fn glow(light: Pattern<f32>) -> Material<f32> {
    Material::patterned(light).with_shares(1.0, 0.0, 0.0)
}

/// What is so far away that only its direction counts, in kilometres.
const FAR: f32 = 4e5;
/// The sun is 695,700 km large and 149.6 million km away.
const SUN_RADIUS: f32 = FAR * 6.957e5 / 1.496e8;
/// The height of the middle of the sun over the horizontal, as a tangent.
const ALTITUDE: f32 = -0.0078;

const SUN: Object<'static, f32> = Object::new(
    Shape::sphere(Vec3::new(0.0, ALTITUDE * FAR, -FAR), SUN_RADIUS),
    glow(Pattern::Gradient {
        from: Rgb::new(1.0, 0.42, 0.1),
        to: Rgb::new(1.0, 0.8, 0.35),
        origin: Vec3::new(0.0, ALTITUDE * FAR - SUN_RADIUS, 0.0),
        axis: Vec3::new(0.0, 0.5 / SUN_RADIUS, 0.0),
    }),
)
.without_shadow();

/// A part of the sky between two heights, as tangents.
const fn sky(low: f32, high: f32, from: Rgb<f32>, to: Rgb<f32>) -> Object<'static, f32> {
    const Z: f32 = -2.0 * FAR;
    const WIDTH: f32 = 0.1 * FAR;
    let (low, high) = (-Z * low, -Z * high);
    let light =
        Pattern::Gradient { from, to, origin: Vec3::new(0.0, low, 0.0), axis: Vec3::new(0.0, 1.0 / (high - low), 0.0) };
    let shape = Shape::axis_box(Vec3::new(-WIDTH, low, Z), Vec3::new(WIDTH, high, Z));
    Object::new(shape, glow(light)).without_shadow()
}

const LOW: Rgb<f32> = Rgb::new(0.62, 0.2, 0.09);
const MIDDLE: Rgb<f32> = Rgb::new(0.78, 0.38, 0.16);
const HIGH: Rgb<f32> = Rgb::new(0.55, 0.36, 0.3);

const SEA: Material<f32> = Material::matte(Rgb::new(0.05, 0.045, 0.06))
    .with_shares(1.0, 0.0, 0.0)
    .with_highlight(Rgb::new(0.6, 0.28, 0.08), 4);
const DARK: Material<f32> = Material::matte(Rgb::new(0.03, 0.022, 0.025)).with_shares(1.0, 0.0, 0.0);

const fn silhouette(triangles: &'static [Triangle<f32>]) -> Object<'static, f32> {
    Object::new(Shape::Triangles(triangles), DARK).without_shadow()
}

/// How far away the ship is, in kilometres, and how much lower the sea is there.
const AWAY: f32 = 7.0;
const FALL: f32 = AWAY * AWAY / (2.0 * RADIUS);

const fn on_ship(x: f32, y: f32) -> Vec3<f32> {
    Vec3::new(0.034 + 0.001 * x, 0.001 * y - FALL, -AWAY)
}

/// A sail, a mast or a hull, in metres on the ship.
const fn sail(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> Triangle<f32> {
    Triangle { vertices: [on_ship(a[0], a[1]), on_ship(b[0], b[1]), on_ship(c[0], c[1])] }
}

const SHIP: [Triangle<f32>; 8] = [
    sail([-13.0, 3.5], [-9.0, -1.0], [9.0, -1.0]),
    sail([-13.0, 3.5], [9.0, -1.0], [12.0, 3.0]),
    sail([4.4, 3.0], [4.9, 3.0], [4.6, 29.0]),
    sail([-4.2, 3.0], [-3.7, 3.0], [-4.0, 26.0]),
    sail([4.2, 5.0], [-3.0, 5.0], [4.2, 27.0]),
    sail([-4.4, 5.0], [-11.5, 5.5], [-4.4, 24.0]),
    sail([5.2, 26.0], [5.5, 6.0], [15.0, 5.5]),
    sail([12.0, 3.0], [17.0, 4.8], [11.0, 3.6]),
];

/// One wing of a gull, in metres at a distance of 200 m.
const fn wing(x: f32, y: f32, side: f32, lift: f32) -> [Triangle<f32>; 3] {
    const fn at(x: f32, y: f32) -> Vec3<f32> {
        Vec3::new(0.001 * x, 0.02 + 0.001 * y, -0.2)
    }
    let (body, elbow) = (at(x, y + 0.02), at(x + 0.26 * side, y + 0.13 * lift));
    let (under, tip) = (at(x, y - 0.06), at(x + 0.6 * side, y + 0.02 * lift));
    let bend = at(x + 0.24 * side, y + 0.06 * lift);
    [
        Triangle { vertices: [body, elbow, bend] },
        Triangle { vertices: [body, bend, under] },
        Triangle { vertices: [bend, elbow, tip] },
    ]
}

const fn gull(x: f32, y: f32, lift: f32) -> [Triangle<f32>; 6] {
    let ([a, b, c], [d, e, f]) = (wing(x, y, -1.0, lift), wing(x, y, 1.0, lift));
    [a, b, c, d, e, f]
}

const GULLS: [[Triangle<f32>; 6]; 3] = [gull(-1.9, 1.9, 1.0), gull(-1.0, 2.25, 1.4), gull(-2.4, 1.3, 0.7)];

const OBJECTS: [Object<'static, f32>; 8] = [
    Object::new(Shape::sphere(CENTER, RADIUS), SEA),
    SUN,
    sky(-0.02, 0.003, LOW, MIDDLE),
    sky(0.003, 0.03, MIDDLE, HIGH),
    silhouette(&SHIP),
    silhouette(&GULLS[0]),
    silhouette(&GULLS[1]),
    silhouette(&GULLS[2]),
];

/// From where the sun is seen.
const LIGHTS: [Light<f32>; 1] = [Light::directional(Vec3::new(0.0, 0.003, -1.0), Rgb::grey(1.0))];
