//! A light exactly on a surface is in front of it: the surface throws no shadow on what it faces.

use whit::{Background, Light, Material, Object, Ray, Rgb, Scene, Shape, Vec3};

use crate::support::{Alone, UP, scene, shoot};

const fn v(x: f32, y: f32, z: f32) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

fn white(shape: Shape<'static, f32>) -> Object<'static, f32> {
    Object::new(shape, Material::matte(Rgb::WHITE))
}

/// How many of 10,000 places, 4 units across, are dark to rays in a direction that start at a height.
fn dark_places(scene: &Scene<'_, f32>, height: f32, direction: Vec3<f32>) -> usize {
    let tracer = Alone::try_new(scene).unwrap();
    let places = (0..10_000).map(|i| v((i % 100) as f32 * 0.04 - 2.0, height, (i / 100) as f32 * 0.04 - 2.0));
    places.filter(|&origin| shoot(&tracer, Ray { origin, direction }, 0).0.r == 0.0).count()
}

#[test]
fn a_lamp_at_the_foot_of_a_ball_lights_the_floor() {
    let mut dark = 0;
    for (radius, height) in [(0.3, 1.0), (0.1, 1.37), (1.0, 0.33), (1.0, 2.0)] {
        let ball = white(Shape::sphere(v(0.0, height + radius, 0.0), radius));
        let (objects, lights) = ([white(Shape::plane(Vec3::ZERO, UP)), ball], [Light::point(UP * height, Rgb::WHITE)]);
        let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
        let places = dark_places(&scene, 0.05, -UP);
        println!("radius {radius}, height {height}: {places} of 10000 places are dark");
        dark += places;
    }
    assert_eq!(dark, 0);
}

#[test]
fn a_lamp_on_the_floor_lights_the_ceiling() {
    let mut dark = 0;
    for height in [0.0, 0.3] {
        let floors = [
            ("plane", Shape::plane(v(0.0, height, 0.0), UP)),
            ("disc", Shape::disc(v(0.0, height, 0.0), UP, 5.0)),
            ("box", Shape::axis_box(v(-5.0, -1.0, -5.0), v(5.0, height, 5.0))),
            ("triangle", Shape::triangle(v(-9.0, height, 9.0), v(9.0, height, 9.0), v(0.0, height, -9.0))),
        ];
        for (name, floor) in floors {
            let objects = [white(floor), white(Shape::plane(v(0.0, 2.0, 0.0), -UP))];
            let lights = [Light::point(v(0.11, height, 0.07), Rgb::WHITE)];
            let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
            let places = dark_places(&scene, 1.9, UP);
            println!("{name} at {height}: {places} of 10000 places are dark");
            dark += places;
        }
    }
    assert_eq!(dark, 0);
}
