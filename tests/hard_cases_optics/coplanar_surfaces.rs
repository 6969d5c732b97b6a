//! Surfaces that lie in one place but belong to shapes that are worked out differently, such as a box that is let into a
//! floor. They are equally near but for rounding, and of equally near ones the first is to be seen.

use whit::{Background, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::support::{Alone, Random, UP, plus, scene, single, unit};

const HEIGHT: f32 = 0.2;

const fn v(x: f32, y: f32, z: f32) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

/// Flat things in one plane.
fn shapes() -> [(&'static str, Shape<'static, f32>); 6] {
    [
        ("plane", Shape::plane(v(0.0, HEIGHT, 0.0), UP)),
        ("another plane", Shape::plane(v(3.1, HEIGHT, -1.7), UP * 3.0)),
        ("box", Shape::axis_box(v(-1.0, -1.0, -1.0), v(1.0, HEIGHT, 1.0))),
        ("disc", Shape::disc(v(0.0, HEIGHT, 0.0), UP, 1.0)),
        ("cap", Shape::cylinder(v(0.0, -1.0, 0.0), v(0.0, HEIGHT, 0.0), 1.0).capped()),
        ("triangle", Shape::triangle(v(-1.0, HEIGHT, 1.0), v(1.0, HEIGHT, 1.0), v(0.0, HEIGHT, -1.0))),
    ]
}

/// Of rays that meet both shapes in one place, so many see the second; of how many.
fn second_seen(first: Shape<'_, f32>, second: Shape<'_, f32>, target: [f64; 3], reach: f64) -> [usize; 2] {
    let objects = [first, second].map(|shape| Object::new(shape, Material::matte(Rgb::WHITE)));
    let scene = scene(Background::Solid(Rgb::BLACK));
    let [both, first, second] = [&objects[..], &objects[..1], &objects[1..]].map(|objects| scene.with_objects(objects));
    let [both, first, second] = [&both, &first, &second].map(|scene| Alone::try_new(scene).unwrap());
    let mut random = Random::new(84);
    let mut counts = [0; 2];
    for _ in 0..5000 {
        let origin = plus(target, 4.0, unit(plus([0.0, 1.2, 0.0], 1.0, random.direction())));
        let target = plus(target, reach * random.unit(), random.direction());
        let ray = Ray { origin: single(origin), direction: single(unit(plus(target, -1.0, origin))).normalized() };
        let [Some(a), Some(b)] = [first.intersect(&ray), second.intersect(&ray)] else { continue };
        if (a.distance - b.distance).abs() < 1e-6 * a.distance && a.normal.y.abs() > 0.999 {
            counts[1] += 1;
            counts[0] += usize::from(both.intersect(&ray).is_some_and(|hit| hit.object == 1));
        }
    }
    counts
}

#[test]
fn of_coplanar_surfaces_the_first_is_seen() {
    let mut speckles = 0;
    for (a, first) in shapes() {
        for (b, second) in shapes().into_iter().filter(|(b, _)| *b != a) {
            let [seen, all] = second_seen(first, second, [0.0, HEIGHT.into(), 0.0], 0.9);
            assert!(all > 200, "{a}, {b}: {all}");
            if seen > 0 {
                println!("{a} before {b}: {seen} of {all} rays see the {b}");
            }
            speckles += seen;
        }
    }
    assert_eq!(speckles, 0, "rays that see the second surface");
}

/// A ball that touches a larger one from inside does not shine through where they touch.
#[test]
fn of_touching_balls_the_outer_is_seen() {
    let mut speckles = 0;
    for (place, radius) in [(0.5, 0.5), (0.9, 0.1), (1.0 / 3.0, 2.0 / 3.0)] {
        let (outer, inner) = (Shape::sphere(Vec3::ZERO, 1.0), Shape::sphere(UP * place, radius));
        let [seen, all] = second_seen(outer, inner, [0.0, 1.0, 0.0], 1e-3);
        assert!(all > 200, "{all}");
        println!("{place}: {seen} of {all} rays see the inner ball");
        speckles += seen;
    }
    assert_eq!(speckles, 0, "rays that see the inner ball");
}
