//! Numbers at the ends of their ranges: powers that vanish, 0⁰, numbers with few digits left, very bright lights.

use whit::optics::transmittance;
use whit::scene::{Exponent, Highlight, Lobe, Medium};
use whit::{Background, Interface, Light, Material, Object, Ray, Rgb, Shape, Vec3};

use crate::naive;
use crate::support::{Alone, Nested, Random, UP, dot, double, plus, scene, shoot, single, unit};

const DOWN: Ray<f32> = Ray { origin: Vec3::new(0.0, 3.0, 0.0), direction: Vec3::new(0.0, -1.0, 0.0) };

/// Small steps through a dense medium take more light than there is.
#[test]
fn attenuation_by_steps_makes_light() {
    let left = |constant| naive::attenuation::transmittance(constant, 1.0, 100);
    assert!(left(150.0) > 0.0 && left(250.0) > 1e10 && !left(2000.0).is_finite());
}

/// Down to the smallest number there is, and then 0: within one step of the number type.
#[test]
fn attenuation_fades_to_nothing() {
    for i in 0..=200_000 {
        let x = i as f32 * 0.0006;
        let (found, exact) = (transmittance(Rgb::grey(x), 1.0).r, (-f64::from(x)).exp());
        let step = (f64::from(f32::EPSILON) * exact).max(f64::from(f32::from_bits(1)));
        assert!((f64::from(found) - exact).abs() <= step, "{x}: {found} {exact}");
    }
    let ends = [
        (1e12, 1e12, 0.0),
        (1e12, f32::MAX, 0.0),
        (0.0, f32::MAX, 1.0),
        (1e-45, 1.0, 1.0),
        (1e-38, 1e12, 1.0),
        (104.0, 1.0, 0.0),
        (1e12, 0.0, 1.0),
    ];
    for (constant, distance, expected) in ends {
        assert_eq!(transmittance(Rgb::grey(constant), distance).r, expected, "{constant:e} over {distance:e}");
    }
}

/// A slab that takes nothing but by its medium.
fn slab(attenuation: Rgb<f32>, thickness: f32) -> Object<'static, f32> {
    let medium = Medium::VACUUM.with_attenuation(attenuation);
    let clear = Interface::Constant { reflected: Rgb::BLACK, transmitted: Rgb::WHITE, medium };
    let shape = Shape::axis_box(Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, thickness, 1.0));
    Object::new(shape, Material::dielectric(1.0).with_interface(clear))
}

/// The same through the tracer, from glass that nothing gets through to glass that is a subnormal number thick.
#[test]
fn slabs_of_any_density_have_the_light_of_their_law() {
    for thickness in [1.0, 1e-6, 1e-12, 1e-40] {
        for constant in [0.0, 1e-45, 1e-38, 1e-6, 1.0, 50.0, 95.0, 103.0, 1e6, 1e12] {
            let objects = [slab(Rgb::new(constant, 0.0, 1.0), thickness)];
            let scene = scene(Background::Solid(Rgb::WHITE)).with_objects(&objects);
            let (light, _) = shoot(&Nested::try_new(&scene).unwrap(), DOWN, 4);
            let exact = (-f64::from(constant) * f64::from(thickness)).exp();
            // The distance is good to the rounding of the place where light came in.
            let share = 1e-6 * (1.0 + f64::from(constant * thickness));
            let tolerance = share * exact + f64::from(f32::from_bits(1));
            assert!(
                (f64::from(light.r) - exact).abs() <= tolerance,
                "{constant:e} by {thickness:e}: {light:?} {exact}"
            );
            assert_eq!(light.g, 1.0);
        }
    }
}

/// A plane that only shines, seen along a direction, lit along another.
fn shine(lobe: Lobe, exponent: Exponent<f32>, seen: Vec3<f32>, towards: Vec3<f32>) -> f32 {
    let highlight = Highlight { color: Rgb::WHITE, lobe, exponent };
    let material = Material { highlight: Some(highlight), ..Material::mirror(Rgb::BLACK) };
    let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
    let lights = [Light::directional(towards, Rgb::WHITE)];
    let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
    let (light, _) = shoot(&Alone::try_new(&scene).unwrap(), Ray { origin: -seen, direction: seen }, 0);
    light.r
}

/// x⁰ = 1 wherever the light is in front, and 0 where it is not: a cosine of 0 has no highlight, whatever the power.
#[test]
fn the_power_zero_is_one_in_front() {
    let light = Vec3::new(-0.6, 0.8, 0.0);
    for exponent in [Exponent::Integer(0), Exponent::Real(0.0)] {
        for lobe in [Lobe::Blinn, Lobe::Phong] {
            assert_eq!(shine(lobe, exponent, Vec3::new(-0.6, -0.8, 0.0), light), 1.0);
            assert_eq!(shine(lobe, exponent, Vec3::new(0.1, -0.8, 0.0).normalized(), light), 1.0);
        }
        // The mirrored direction of view is across the light: 0⁰.
        assert_eq!(shine(Lobe::Phong, exponent, Vec3::new(0.0, -1.0, 0.0), Vec3::new(1.0, 0.0, 0.0)), 0.0);
        assert_eq!(shine(Lobe::Phong, exponent, Vec3::new(0.8, -0.6, 0.0), light), 0.0);
    }
}

/// A vector and itself: the cosine is one.
#[test]
fn the_textbook_highlight_blows_up() {
    let mut random = Random::new(90);
    let brightest = (0..10_000).map(|_| {
        let Vec3 { x, y, z } = single(random.direction()).normalized();
        naive::highlight::highlight([x, y, z], [x, y, z], 1e12)
    });
    assert_eq!(brightest.fold(0.0, f32::max), f32::INFINITY);
}

/// The sharpest highlights are never brighter than their light, and as far as the digits of a cosine go, as bright as in
/// exact arithmetic.
#[test]
fn sharp_highlights_stay_in_range() {
    let mut random = Random::new(91);
    let powers = [(1e5, Exponent::Integer(100_000)), (1e5, Exponent::Real(1e5)), (1e3, Exponent::Integer(1000))];
    let blunt = [(f64::from(u32::MAX), Exponent::Integer(u32::MAX)), (1e12, Exponent::Real(1e12))];
    let (mut worst, mut lit) = (0.0_f64, 0);
    for _ in 0..3000 {
        let seen = single(unit(plus([0.0, -1.0, 0.0], 0.7, random.direction()))).normalized();
        let mirrored = Vec3::new(seen.x, -seen.y, seen.z);
        let near = unit(plus(double(mirrored), 10_f64.powf(random.between(-6.0, -2.0)), random.direction()));
        let towards = single(near);
        if seen.y >= -0.1 || towards.y <= 0.1 {
            continue;
        }
        let half = unit(plus(unit(double(towards)), -1.0, unit(double(seen))));
        let reflected = unit(double(mirrored));
        for (lobe, cosine) in [(Lobe::Blinn, half[1]), (Lobe::Phong, dot(reflected, unit(double(towards))))] {
            for (power, exponent) in powers {
                let (found, exact) = (shine(lobe, exponent, seen, towards), cosine.min(1.0).powf(power));
                assert!((0.0..=1.0).contains(&found), "{exponent:?}: {found}");
                // Four roundings of the cosine, raised to the power.
                let error = (f64::from(found) - exact).abs() / (power * f64::from(f32::EPSILON));
                worst = worst.max(error);
                lit += u32::from(exact > 0.1);
            }
            for (_, exponent) in blunt {
                let found = shine(lobe, exponent, seen, towards);
                assert!((0.0..=1.0).contains(&found), "{exponent:?}: {found}");
            }
        }
    }
    println!("{worst} roundings of the cosine, {lit} lit");
    assert!(worst < 4.0 && lit > 1000, "{worst} {lit}");
}

/// Colours that have hardly any digits left are still the products that they should be.
#[test]
fn the_darkest_colours_are_kept() {
    for tiny in [1e-45_f32, 1e-42, 1e-40, f32::MIN_POSITIVE, 1e-30] {
        let empty = scene(Background::Solid(Rgb::grey(tiny)));
        assert_eq!(shoot(&Alone::try_new(&empty).unwrap(), DOWN, 0).0, Rgb::grey(tiny));
        let floors = [
            (Material::matte(Rgb::grey(tiny)), Rgb::WHITE),
            (Material::matte(Rgb::WHITE), Rgb::grey(tiny)),
            (Material::matte(Rgb::WHITE).with_shares(0.0, tiny, 0.0), Rgb::WHITE),
            (Material::matte(Rgb::WHITE).with_shares(tiny, 0.0, 0.0), Rgb::BLACK),
            (Material::mirror(Rgb::BLACK).with_highlight(Rgb::grey(tiny), 1), Rgb::WHITE),
        ];
        for (material, light) in floors {
            let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), material)];
            let lights = [Light::directional(UP, light)];
            let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
            let (found, _) = shoot(&Alone::try_new(&scene).unwrap(), DOWN, 0);
            assert_eq!(found, Rgb::grey(tiny), "{material:?}");
        }
        let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), Material::mirror(Rgb::grey(tiny)))];
        let scene = scene(Background::Solid(Rgb::grey(0.5))).with_objects(&objects);
        assert_eq!(shoot(&Alone::try_new(&scene).unwrap(), DOWN, 1).0, Rgb::grey(tiny * 0.5));
    }
}

/// A slope that is a subnormal number is as good as none: no division by it makes an infinity that shows.
#[test]
fn the_smallest_slopes_are_none() {
    let shapes = [
        Shape::sphere(Vec3::ZERO, 1.0),
        Shape::axis_box(Vec3::splat(-1.0), Vec3::splat(1.0)),
        Shape::plane(Vec3::ZERO, UP),
        Shape::disc(Vec3::ZERO, UP, 1.0),
        Shape::triangle(Vec3::new(-2.0, 0.0, -1.0), Vec3::new(0.0, 0.0, 3.0), Vec3::new(2.0, 0.0, -1.0)),
        Shape::cylinder(Vec3::new(0.0, -1.0, 0.0), UP, 1.0).capped(),
    ];
    for shape in shapes {
        let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
        let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects);
        let tracer = Alone::try_new(&scene).unwrap();
        for x in [0.0, 0.5, -0.25, 1e-40] {
            let origin = Vec3::new(x, 3.0, 0.25);
            let straight = tracer.intersect(&Ray { origin, direction: -UP });
            for tiny in [1e-45, -1e-45, 1e-40, -1e-40, 1e-38, -1e-38, 1e-30] {
                let direction = Vec3::new(tiny, -1.0, -tiny);
                let found = tracer.intersect(&Ray { origin, direction });
                let known = |hit: Option<whit::Intersection<f32>>| {
                    hit.map(|hit| (hit.distance, hit.from_outside, hit.point.map(|x| x.abs() < 5.0), hit.normal.y))
                };
                assert_eq!(known(found), known(straight), "{shape:?} at {x}, slope {tiny:e}");
            }
        }
    }
}

/// Rays in the very plane of a box's face, or out of it by a slope that is hardly a number: 0·∞.
#[test]
fn rays_in_a_face_meet_the_box_or_not() {
    let objects = [Object::new(Shape::axis_box(Vec3::splat(-1.0), Vec3::splat(1.0)), Material::matte(Rgb::WHITE))];
    let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects);
    let tracer = Alone::try_new(&scene).unwrap();
    for x in [1.0, -1.0] {
        for slope in [0.0, 1e-45, -1e-45, 1e-40, -1e-40, 1e-38, -1e-38, 1e-30, -1e-30] {
            let ray = Ray { origin: Vec3::new(x, 3.0, 0.25), direction: Vec3::new(slope, -1.0, 0.0) };
            let hit = tracer.intersect(&ray);
            assert!(hit.is_some() || slope * x > 0.0, "{x}, slope {slope:e}");
            let Some(hit) = hit else { continue };
            assert_eq!((hit.distance, hit.normal, hit.from_outside), (2.0, UP, true), "{x}, slope {slope:e}");
        }
    }
}

/// Sizes and places of any size down to the smallest that a scene may have, right under the eye.
#[test]
fn the_smallest_things_are_seen() {
    for radius in [1e-12_f32, 1e-11, 1e-6] {
        for place in [0.0, 1e-45, 1e-40, 1e-38, 1e-30, 1e-20] {
            let center = Vec3::splat(place);
            let shapes = [
                Shape::sphere(center, radius),
                Shape::disc(center, UP, radius),
                Shape::axis_box(center + Vec3::splat(-radius), center + Vec3::splat(radius)),
                Shape::cylinder(center + UP * -radius, center + UP * radius, radius).capped(),
            ];
            for shape in shapes {
                let objects = [Object::new(shape, Material::matte(Rgb::WHITE))];
                let lights = [Light::directional(UP, Rgb::grey(0.75))];
                let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
                let ray = Ray { origin: center + UP * (3.0 * radius), ..DOWN };
                let (light, _) = shoot(&Alone::try_new(&scene).unwrap(), ray, 0);
                assert!((light.r - 0.75).abs() < 1e-6, "{shape:?}: {light:?}");
            }
        }
    }
}

/// A light right above a plane: what arrives does not depend on the distance, down to where its square has no digits
/// left. From there on it is off by up to a hundredth, and then none arrives.
#[test]
fn the_nearest_lights_are_seen() {
    for (height, tolerance) in [(1.0, 0.0), (1e-6, 0.0), (1e-12, 2e-7), (1e-18, 2e-7), (1e-20, 1e-5), (1e-22, 1e-2)] {
        let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), Material::matte(Rgb::WHITE))];
        let lights = [Light::point(UP * height, Rgb::WHITE)];
        let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
        let (light, _) = shoot(&Alone::try_new(&scene).unwrap(), DOWN, 0);
        assert!((light.r - 1.0).abs() <= tolerance, "{height:e}: {light:?}");
    }
}

/// The brightest light on the brightest body.
#[test]
fn the_brightest_light_is_a_number() {
    const MOST: f32 = 1e12;
    for (cosine, height) in [(1.0_f64, 0.0), (0.6, 0.8_f32)] {
        let body = Material::matte(Rgb::new(MOST, 1.0, 0.0)).with_shares(MOST, MOST, MOST);
        let objects = [Object::new(Shape::plane(Vec3::ZERO, UP), body)];
        let lights = [Light::directional(Vec3::new(height, cosine as f32, 0.0), Rgb::grey(MOST)); 4];
        let scene = scene(Background::Solid(Rgb::BLACK)).with_objects(&objects).with_lights(&lights);
        let (found, _) = shoot(&Alone::try_new(&scene).unwrap(), DOWN, 0);
        let most = f64::from(MOST);
        let exact = most * (most + 4.0 * most * (most + most * cosine));
        for (found, exact) in [(found.r, exact), (found.g, exact / most), (found.b, 0.0)] {
            assert!((f64::from(found) - exact).abs() <= 1e-6 * exact, "{found} {exact}");
        }
    }
}
