//! The sphere-flake of Eric Haines's Standard Procedural Databases ("balls").

use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, Camera, Exponent, Extent, Highlight, Interface, Light, Lobe, Material, Object, PackedSpheres, Scene,
    Shape, Sphere,
};

/// 91 mirrored spheres, each with nine smaller ones around it, over a floor; z is up.
pub const FLAKE: Scene<'static, f32> =
    Scene::new(CAMERA, Background::Solid(Rgb::new(0.078, 0.361, 0.753))).with_objects(&OBJECTS).with_lights(&LIGHTS);

const CAMERA: Camera<f32> = Camera {
    extent: Extent::PixelCentres,
    ..Camera::look_at(Vec3::new(2.1, 1.3, 1.7), Vec3::ZERO, Vec3::new(0.0, 0.0, 1.0), 45.0)
};

const BALLS: PackedSpheres<f32, 2, 12> = PackedSpheres::new(&flake_spheres::<91>());

const BALL: Material<f32> = Material {
    highlight: Some(Highlight { color: Rgb::grey(0.5), lobe: Lobe::Blinn, exponent: Exponent::Real(3.0827) }),
    interface: Interface::Mirror { reflected: Rgb::grey(0.5) },
    ..Material::matte(Rgb::new(1.0, 0.9, 0.7)).with_shares(0.0, 0.0, 0.5)
};
const FLOOR: Material<f32> = Material::matte(Rgb::new(1.0, 0.75, 0.33)).with_shares(0.0, 0.0, 0.8);

const OBJECTS: [Object<'static, f32>; 2] = [
    Object::new(Shape::plane(Vec3::new(0.0, 0.0, -0.5), Vec3::new(0.0, 0.0, 1.0)), FLOOR),
    Object::new(Shape::Spheres(BALLS.view()), BALL),
];

/// 1/√3 each, so that three lights are as bright as one.
const INTENSITY: Rgb<f32> = Rgb::grey(0.577_350_3);
const LIGHTS: [Light<f32>; 3] = [
    Light::point(Vec3::new(4.0, 3.0, 2.0), INTENSITY),
    Light::point(Vec3::new(1.0, -4.0, 4.0), INTENSITY),
    Light::point(Vec3::new(-3.0, 1.0, 5.0), INTENSITY),
];

/// The first `N` spheres of the flake, generation by generation: 1, 10, 91, 820, 7381, … for whole ones. The first has
/// the radius 1/2 and lies at the origin; each has nine of a third of its size around it.
#[must_use]
#[allow(clippy::indexing_slicing)] // In range by the loop's condition: a parent comes before its children.
pub const fn flake_spheres<const N: usize>() -> [Sphere<f32>; N] {
    let mut spheres = [Sphere { center: Vec3::new(0.0_f32, 0.0, 0.0), radius: 0.5 }; N];
    let mut exact = [Ball { center: [0.0; 3], radius: 0.5, direction: [0.0, 0.0, 1.0] }; N];
    let directions = child_directions();
    let mut i = 1;
    while i < N {
        let ball = exact[(i - 1) / 9].child(directions[(i - 1) % 9]);
        let [x, y, z] = ball.center;
        spheres[i] = Sphere { center: Vec3::new(x as f32, y as f32, z as f32), radius: ball.radius as f32 };
        exact[i] = ball;
        i += 1;
    }
    spheres
}

/// A sphere while the flake grows, with the direction from its parent.
#[derive(Clone, Copy)]
struct Ball {
    center: [f64; 3],
    radius: f64,
    direction: [f64; 3],
}

impl Ball {
    /// The child whose direction is `local` where the parent's direction is z.
    const fn child(&self, local: [f64; 3]) -> Self {
        let direction = turn_from_z(self.direction, local);
        let radius = self.radius / 3.0;
        let distance = self.radius + radius;
        let ([x, y, z], [dx, dy, dz]) = (self.center, direction);
        Self { center: [x + dx * distance, y + dy * distance, z + dz * distance], radius, direction }
    }
}

/// The shortest rotation that takes z to the unit vector `to`, applied to `v`: v + a×v + a×(a×v)/(1 + cos) with
/// a = z × to.
const fn turn_from_z(to: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    let [x, y, cosine] = to;
    if cosine < -0.999_999 {
        // Half a turn about the y axis.
        return [-v[0], v[1], -v[2]];
    }
    let once = cross([-y, x, 0.0], v);
    let twice = cross([-y, x, 0.0], once);
    let scale = 1.0 / (1.0 + cosine);
    [v[0] + once[0] + twice[0] * scale, v[1] + once[1] + twice[1] * scale, v[2] + once[2] + twice[2] * scale]
}

const fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Nine directions: three, tilted about (1, −1, 0)/√2 by the angle of sine 2/√6, and turned by thirds about z.
#[allow(clippy::indexing_slicing)] // Constant ranges.
const fn child_directions() -> [[f64; 3]; 9] {
    let h = core::f64::consts::FRAC_1_SQRT_2;
    let trio = [[h, h, 0.0], [h, 0.0, -h], [0.0, h, -h]];
    let axis = [h, -h, 0.0];
    let (sine, cosine) = (0.816_496_580_927_726, 0.577_350_269_189_625_7);
    let turns = [(0.0, 1.0), (0.866_025_403_784_438_6, -0.5), (-0.866_025_403_784_438_6, -0.5)];
    let mut directions = [[0.0; 3]; 9];
    let mut i = 0;
    while i < 9 {
        let v = trio[i % 3];
        let across = cross(axis, v);
        let along = (axis[0] * v[0] + axis[1] * v[1]) * (1.0 - cosine);
        let x = v[0] * cosine + across[0] * sine + axis[0] * along;
        let y = v[1] * cosine + across[1] * sine + axis[1] * along;
        let z = v[2] * cosine + across[2] * sine;
        let (s, c) = turns[i / 3];
        directions[i] = [x * c - y * s, x * s + y * c, z];
        i += 1;
    }
    directions
}
