//! An eye or a light on a surface, or in a body. What is seen does not depend on rounding.

use whit::{Background, Light, Material, Object, Ray, Rgb, Scene, Shape, Vec3};

use crate::support::{Alone, Random, UP, dot, double, plus, scene, shoot, single};

const fn v(x: f32, y: f32, z: f32) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

/// Objects and lights in the dark.
fn view<'a>(objects: &'a [Object<'a, f32>], lights: &'a [Light<f32>]) -> Scene<'a, f32> {
    scene(Background::Solid(Rgb::BLACK)).with_objects(objects).with_lights(lights)
}

/// A ray does not meet a flat surface that it starts on; one that starts on a closed body meets that from inside or not at
/// all, as it looks in or out.
#[test]
fn an_eye_on_a_surface_does_not_see_it() {
    let height = 0.3;
    let flat = [
        Shape::plane(v(0.0, height, 0.0), UP),
        Shape::disc(v(0.0, height, 0.0), UP, 5.0),
        Shape::triangle(v(-9.0, height, 9.0), v(9.0, height, 9.0), v(0.0, height, -9.0)),
    ];
    let closed = [
        Shape::axis_box(v(-5.0, -1.0, -5.0), v(5.0, height, 5.0)),
        Shape::cylinder(v(0.0, -1.0, 0.0), v(0.0, height, 0.0), 5.0).capped(),
    ];
    let mut random = Random::new(82);
    for (is_closed, shape) in flat.map(|shape| (false, shape)).into_iter().chain(closed.map(|shape| (true, shape))) {
        let objects = [Object::new(shape, Material::dielectric(1.5))];
        let scene = view(&objects, &[]);
        let tracer = Alone::try_new(&scene).unwrap();
        for _ in 0..5000 {
            let origin = single([random.between(-1.0, 1.0), f64::from(height), random.between(-1.0, 1.0)]);
            let direction = single(random.direction());
            let hit = tracer.intersect(&Ray { origin, direction });
            let expected = (is_closed && direction.y < 0.0).then_some(false);
            assert_eq!(hit.map(|hit| hit.from_outside), expected, "{shape:?}: {direction:?}");
            assert!(hit.is_none_or(|hit| hit.distance > 1.0), "{hit:?}");
        }
    }
}

/// On a ball, rounding puts the eye a little inside or outside; every ray sees it on the same side.
#[test]
fn an_eye_on_a_ball_is_on_one_side_of_it() {
    let mut random = Random::new(83);
    for (center, radius) in [(Vec3::ZERO, 1.0), (v(0.1, 0.2, 0.3), 0.7), (v(10.0, -2.0, 0.7), 3.3), (Vec3::ZERO, 1e-6)]
    {
        let objects = [Object::new(Shape::sphere(center, radius), Material::dielectric(1.5))];
        let scene = view(&objects, &[]);
        let tracer = Alone::try_new(&scene).unwrap();
        for _ in 0..500 {
            let outward = random.direction();
            let origin = single(plus(double(center), radius.into(), outward));
            let mut sides = Vec::new();
            for _ in 0..100 {
                let direction = random.direction();
                let hit = tracer.intersect(&Ray { origin, direction: single(direction).normalized() });
                // Along the surface it is the curvature that counts.
                if dot(direction, outward) < -0.01 {
                    sides.push(hit.expect("the ball").from_outside);
                } else if dot(direction, outward) > 0.01 && hit.is_some() {
                    sides.push(hit.unwrap().from_outside);
                }
            }
            assert!(sides.windows(2).all(|pair| pair[0] == pair[1]), "{center:?} {radius}: {origin:?}");
        }
    }
}

/// Whether a floor is lit in a place by a light.
fn is_lit(objects: &[Object<'_, f32>], light: Light<f32>, place: [f32; 2]) -> bool {
    let (lights, [x, z]) = ([light], place);
    let scene = view(objects, &lights);
    let ray = Ray { origin: v(x, 0.01, z), direction: -UP };
    let light = shoot(&Alone::try_new(&scene).unwrap(), ray, 0).0.r;
    assert!(light.is_finite());
    light > 0.0
}

/// In the middle of an opaque ball a light shines on nothing outside, but where the ball casts no shadow.
#[test]
fn a_light_in_a_body_shines_inside_it() {
    let floor = Object::new(Shape::plane(Vec3::ZERO, UP), Material::matte(Rgb::WHITE));
    let ball = Object::new(Shape::sphere(v(0.0, 1.0, 0.0), 0.5), Material::matte(Rgb::WHITE));
    let glass = Object { material: Material::dielectric(1.5), ..ball };
    let light = Light::point(v(0.1, 1.1, 0.0), Rgb::WHITE);
    for place in [[0.0, 0.0], [1.0, 2.0], [30.0, -7.0]] {
        assert!(!is_lit(&[floor, ball], light, place) && !is_lit(&[floor, glass], light, place));
        assert!(is_lit(&[floor, ball.without_shadow()], light, place));
        assert!(is_lit(&[floor, glass.with_tinted_shadow()], light, place));
    }
    // From inside, the ball itself is lit.
    let (objects, lights) = ([ball], [light]);
    let scene = view(&objects, &lights);
    let ray = Ray { origin: v(0.0, 1.0, 0.0), direction: v(0.0, 0.0, 1.0) };
    assert!(shoot(&Alone::try_new(&scene).unwrap(), ray, 0).0.r > 0.5);
}

/// A light in the plane of a floor does not light it: the angle is none. Neither does one at the very point.
#[test]
fn a_light_in_a_plane_does_not_light_it() {
    for height in [0.0, 0.3, -7.1] {
        let floors = [
            Shape::plane(v(0.0, height, 0.0), UP),
            Shape::disc(v(0.0, height, 0.0), UP, 50.0),
            Shape::axis_box(v(-50.0, height - 1.0, -50.0), v(50.0, height, 50.0)),
        ];
        for floor in floors {
            let objects = [Object::new(floor, Material::matte(Rgb::WHITE).with_highlight(Rgb::WHITE, 3))];
            let lights = [Light::point(v(0.25, height, 0.5), Rgb::WHITE)];
            let scene = view(&objects, &lights);
            let tracer = Alone::try_new(&scene).unwrap();
            for i in 0..2000 {
                let place = v(0.25 * (i % 50) as f32, height + 1.0, 0.5 * (i / 50) as f32);
                let light = shoot(&tracer, Ray { origin: place, direction: -UP }, 0).0;
                assert_eq!(light, Rgb::BLACK, "{floor:?} at {place:?}");
            }
        }
    }
}

/// A ball of light is nothing to be seen: an eye in it sees what there is. What lies in it is lit from points on a disc
/// through its middle, and its very middle by a number, too.
#[test]
fn an_eye_in_a_ball_of_light_sees_through_it() {
    let floor = [Object::new(Shape::plane(Vec3::ZERO, UP), Material::matte(Rgb::WHITE))];
    for (center, radius) in [(Vec3::ZERO, 1.0), (v(0.0, 0.5, 0.0), 2.0), (v(0.0, 0.5, 0.0), 1e3), (Vec3::ZERO, 1e-12)] {
        let lights = [Light::sphere(center, radius, Rgb::WHITE)];
        let empty = view(&[], &lights);
        for direction in [UP, -UP, v(0.6, 0.0, 0.8)] {
            let ray = Ray { origin: v(0.0, 0.3, 0.0), direction };
            assert_eq!(shoot(&Alone::try_new(&empty).unwrap(), ray, 0).0, Rgb::BLACK);
        }
        let lit = view(&floor, &lights);
        let lit = Alone::try_new(&lit).unwrap();
        for i in 0..1000 {
            let ray = Ray { origin: v((i % 40) as f32 * 0.1 - 2.0, 0.3, (i / 40) as f32 * 0.1 - 1.0), direction: -UP };
            let light = shoot(&lit, ray, 0).0.r;
            assert!((0.0..=1.0).contains(&light), "{light}");
        }
    }
}
