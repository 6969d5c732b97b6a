//! Light after 64 bounces: where it is, which way it goes, how much of it is left.

use whit::optics::reflect;
use whit::scene::Medium;
use whit::{Background, Intersection, Material, Object, Pattern, Ray, Rgb, Scene, Shape, Vec3};

use crate::naive;
use crate::support::{Alone, Nested, Random, dot, double, plus, scene, shoot, single, unit};

const BOUNCES: usize = 64;

/// The surfaces that a ray meets, each reflecting it, as the tracer does it.
fn chain(tracer: &Alone<'_>, ray: Ray<f32>) -> Vec<(Ray<f32>, Intersection<f32>)> {
    let mut ray = ray;
    let mut hits = Vec::new();
    for _ in 0..=BOUNCES {
        let Some(hit) = tracer.intersect(&ray) else { break };
        hits.push((ray, hit));
        let normal = if hit.from_outside { hit.normal } else { -hit.normal };
        let direction = reflect(ray.direction, normal, -ray.direction.dot(normal)).normalized();
        ray = hit.leave(direction);
    }
    hits
}

/// Two mirrors that face each other, as planes in `f64`: a point and a unit normal each.
type Planes = [([f64; 3], [f64; 3]); 2];

/// The points where a ray meets two mirrors in turn, by the method of images: the ray goes on in a straight line, and it
/// is the mirrors that are reflected.
fn unfolded(mirrors: Planes, origin: [f64; 3], direction: [f64; 3], first: usize) -> Vec<[f64; 3]> {
    // An isometry from space to unfolded space: the images of the axes, and of the origin.
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut zero = [0.0; 3];
    let mut points = Vec::new();
    for k in 0..=BOUNCES {
        let (point, normal) = mirrors[(first + k) % 2];
        let turn = |v: [f64; 3]| (0..3).fold([0.0; 3], |sum, i| plus(sum, v[i], axes[i]));
        let (point, normal) = (plus(turn(point), 1.0, zero), unit(turn(normal)));
        let t = dot(plus(point, -1.0, origin), normal) / dot(direction, normal);
        let met = plus(plus(origin, t, direction), -1.0, zero);
        points.push([0, 1, 2].map(|i| dot(met, axes[i])));
        let mirror = |v: [f64; 3]| plus(v, -2.0 * dot(v, normal), normal);
        axes = axes.map(mirror);
        zero = plus(point, 1.0, mirror(plus(zero, -1.0, point)));
    }
    points
}

/// A random direction across a vector.
fn across(random: &mut Random, axis: [f64; 3]) -> [f64; 3] {
    let (axis, other) = (unit(axis), random.direction());
    unit(plus(other, -dot(other, axis), axis))
}

/// A pair of mirrors that look at each other across the origin, the second one turned by an angle; a ray between them at
/// a slope from their normal; and the planes of the mirrors.
fn mirrors(random: &mut Random, angle: f64, slope: f64) -> ([Shape<'static, f32>; 2], Ray<f32>, Planes) {
    let normal = single(random.direction()).normalized();
    let away = across(random, double(normal));
    let turned = single(unit(plus(double(-normal), angle, away)));
    let direction = single(unit(plus(double(normal), slope, across(random, double(normal)))));
    let origin = single(plus([0.0; 3], 0.3, random.direction()));
    let planes = [(double(-normal), unit(double(normal))), (double(normal), unit(double(turned)))];
    ([Shape::plane(-normal, normal), Shape::plane(normal, turned)], Ray { origin, direction }, planes)
}

fn objects<const N: usize>(shapes: [Shape<'static, f32>; N], material: Material<f32>) -> [Object<'static, f32>; N] {
    shapes.map(|shape| Object::new(shape, material))
}

fn dark<'a>() -> Scene<'a, f32> {
    scene(Background::Solid(Rgb::BLACK))
}

/// Without care a direction grows or shrinks at each bounce.
#[test]
fn the_textbook_form_loses_its_length() {
    let mut random = Random::new(70);
    let worst = (0..1000).map(|_| {
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        let normal = single(random.direction()).normalized();
        let mut direction = array(single(unit(plus(double(normal), 0.5, across(&mut random, double(normal))))));
        for _ in 0..BOUNCES {
            direction = naive::reflect::reflect(direction, array(normal));
        }
        let length = dot(direction.map(f64::from), direction.map(f64::from)).sqrt();
        (length - 1.0).abs()
    });
    let worst = worst.fold(0.0, f64::max);
    println!("{worst:e}");
    assert!(worst > 5e-6, "{worst:e}");
}

/// Between parallel mirrors, and ones that stand at a small angle: the places of all images, by the share of the way
/// that light has come; and the lengths of all directions.
#[test]
fn images_are_in_their_places() {
    let mut random = Random::new(71);
    for (angle, slope, tolerance) in [(0.0, 1.0, 4e-5), (1e-3, 0.0, 5e-6), (0.01, 0.0, 2e-5)] {
        let (mut off, mut length) = (0.0_f64, 0.0_f64);
        for _ in 0..2000 {
            let slope = random.between(0.0, slope);
            let (shapes, ray, planes) = mirrors(&mut random, angle, slope);
            let objects = objects(shapes, Material::mirror(Rgb::WHITE));
            let scene = dark().with_objects(&objects);
            let hits = chain(&Alone::try_new(&scene).unwrap(), ray);
            assert_eq!(hits.len(), BOUNCES + 1);
            let mut way = 0.0;
            for ((ray, hit), exact) in hits.iter().zip(unfolded(planes, double(ray.origin), double(ray.direction), 1)) {
                way += f64::from(hit.distance);
                let error = plus(double(hit.point), -1.0, exact);
                off = off.max(dot(error, error).sqrt() / way);
                length = length.max((dot(double(ray.direction), double(ray.direction)).sqrt() - 1.0).abs());
            }
        }
        println!("angle {angle}: {off:e} of the way, lengths {length:e}");
        assert!(off < tolerance, "angle {angle}: {off:e} of the way");
        assert!(length < 2.0 * f64::from(f32::EPSILON), "{length:e}");
    }
}

/// The same by the tracer: a wall across the mirrors shows by its colour where light met it, and the counts say after how
/// many bounces.
#[test]
fn the_tracer_sees_images_in_their_places() {
    const WALL: f32 = 10.0;
    let x = Vec3::new(1.0, 0.0, 0.0);
    let ramp = Pattern::Gradient { from: Rgb::BLACK, to: Rgb::WHITE, origin: -x, axis: x * 0.5 };
    let wall = Material::patterned(ramp).with_shares(1.0, 0.0, 0.0);
    let mirror = Material::mirror(Rgb::WHITE);
    let objects = [
        Object::new(Shape::plane(-x, x), mirror),
        Object::new(Shape::plane(x, -x), mirror),
        Object::new(Shape::plane(Vec3::new(0.0, 0.0, WALL), Vec3::new(0.0, 0.0, -1.0)), wall),
    ];
    let scene = dark().with_objects(&objects);
    let tracer = Alone::try_new(&scene).unwrap();
    let mut random = Random::new(72);
    let (mut worst, mut most) = (0.0_f64, 0);
    for _ in 0..20_000 {
        let origin = single([random.between(-0.9, 0.9), random.between(-1.0, 1.0), 0.0]);
        let direction = single(unit([random.between(-12.5, 12.5), random.between(-1.0, 1.0), 1.0]));
        let (light, stats) = shoot(&tracer, Ray { origin, direction }, BOUNCES as u8);
        // Half the way across the mirrors, from the first one, without any mirror in the way.
        let slope = f64::from(direction.x) / f64::from(direction.z);
        let crossed = (f64::from(origin.x) + 1.0 + f64::from(WALL) * slope) / 2.0;
        let (bounces, fold) = (crossed.floor().abs() as u64, crossed.rem_euclid(2.0));
        let expected = if fold < 1.0 { fold } else { 2.0 - fold };
        worst = worst.max((f64::from(light.r) - expected).abs());
        let is_at_a_corner = !(1e-4..1.0 - 1e-4).contains(&expected);
        assert!(is_at_a_corner || stats.reflected == bounces, "{stats:?}: expected {bounces}");
        most = most.max(stats.reflected);
    }
    println!("{worst:e} after up to {most} bounces");
    assert!(most >= 60 && worst < 2e-4, "{worst:e} after up to {most} bounces");
}

/// Ways for light that never gets out of a ball of glass: by the cosine at which it meets the surface.
fn trapped(random: &mut Random, center: Vec3<f32>, radius: f32, cosine: f64) -> (Ray<f32>, f64) {
    // From the middle of a chord.
    let normal = random.direction();
    let origin = single(plus(double(center), f64::from(radius) * (1.0 - cosine * cosine).sqrt(), normal));
    let direction = single(across(random, normal)).normalized();
    let (from_center, along) = (plus(double(origin), -1.0, double(center)), unit(double(direction)));
    let nearest = dot(from_center, from_center) - dot(from_center, along).powi(2);
    (Ray { origin, direction }, (1.0 - nearest / f64::from(radius).powi(2)).sqrt())
}

const COSINES: [f64; 6] = [0.74, 0.5, 0.3, 0.1, 0.03, 0.01];

/// The angle is the same at all 65 surfaces, but that each reflected ray starts a little inside: by the offset from the
/// surface, which takes the sine down by its share of the radius. So the square of the cosine grows by no more than twice
/// that at each bounce; the rounding of the places themselves adds less than half as much.
#[test]
fn angles_in_a_ball_drift_no_more_than_offsets_make_them() {
    let mut random = Random::new(73);
    for (center, radius) in [(Vec3::ZERO, 1.0_f32), (Vec3::ZERO, 1e-6), (Vec3::ZERO, 1e6), (Vec3::splat(500.0), 1.0)] {
        let ball = [Object::new(Shape::sphere(center, radius), Material::dielectric(1.5))];
        let scene = dark().with_objects(&ball);
        let tracer = Alone::try_new(&scene).unwrap();
        for cosine in COSINES {
            let (mut drift, mut share, mut offsets) = (0.0_f64, 0.0_f64, 0.0_f64);
            for _ in 0..300 {
                let (ray, exact) = trapped(&mut random, center, radius, cosine);
                let hits = chain(&tracer, ray);
                assert_eq!(hits.len(), BOUNCES + 1);
                for (k, (ray, hit)) in hits.iter().enumerate() {
                    assert!(!hit.from_outside, "out of the ball");
                    let offset = dot(double(hit.offset), double(hit.offset)).sqrt() / f64::from(radius);
                    let found = dot(double(ray.direction), double(hit.normal));
                    let bound = 3.0 * offset * (k as f64 + 2.0);
                    drift = drift.max((found - exact).abs());
                    share = share.max((found * found - exact * exact).abs() / bound);
                    offsets = offsets.max(offset);
                }
            }
            println!(
                "{center:?} {radius:e}, cosine {cosine}: {drift:.1e}, {share:.2} of the bound, offset {offsets:.1e}"
            );
            assert!(share < 1.0, "{center:?} {radius:e}, cosine {cosine}: {share} of the bound");
            // What that means in the middle of things.
            assert!(drift < 4e-4 || cosine < 0.1 || center.x > 0.0, "cosine {cosine}: {drift}");
        }
    }
}

/// The tracer counts a total reflection for each of the 65 surfaces, and attenuates light over all of the way between
/// them.
#[test]
fn light_in_a_ball_is_reflected_totally_every_time() {
    let mut random = Random::new(74);
    for cosine in COSINES.into_iter().filter(|cosine| *cosine >= 0.1) {
        let way = 2.0 * cosine * BOUNCES as f64 + cosine;
        let tint = Rgb::new(1.0, 0.1, 0.0).map(|c| c / way as f32);
        let glass = Material::transparent(Medium::new(1.5).with_attenuation(tint));
        let ball = [Object::new(Shape::sphere(Vec3::ZERO, 1.0), glass)];
        let scene = scene(Background::Solid(Rgb::WHITE)).with_objects(&ball);
        let tracer = Nested::try_new(&scene).unwrap();
        let mut worst = 0.0_f64;
        for _ in 0..300 {
            let (ray, exact) = trapped(&mut random, Vec3::ZERO, 1.0, cosine);
            let (light, stats) = shoot(&tracer, ray, BOUNCES as u8);
            assert_eq!([stats.total_internal, stats.reflected, stats.transmitted], [65, 64, 0]);
            assert_eq!([stats.cut_by_depth, stats.rays()], [1, 65]);
            assert_eq!(light.b, 1.0, "no light is lost");
            let red = (-exact * (2.0 * BOUNCES as f64 + 1.0) * f64::from(tint.r)).exp();
            worst = worst.max((f64::from(light.r) / red - 1.0).abs());
        }
        println!("cosine {cosine}: {worst:e}");
        // The drift of the cosine, by its share, makes the way longer.
        assert!(worst < 2e-5 / (cosine * cosine), "cosine {cosine}: {worst:e}");
    }
}

/// Mirrors that reflect all light give back exactly what they get.
#[test]
fn mirrors_keep_all_light() {
    let mut random = Random::new(75);
    let light = Rgb::new(0.7, 0.1, 1e-3);
    for _ in 0..500 {
        let (shapes, ray, _) = mirrors(&mut random, 0.0, 0.5);
        let objects = objects(shapes, Material::mirror(Rgb::WHITE));
        let scene = scene(Background::Solid(light)).with_objects(&objects);
        let (found, stats) = shoot(&Alone::try_new(&scene).unwrap(), ray, BOUNCES as u8);
        assert_eq!((found, stats.reflected, stats.cut_by_depth), (light, 64, 1));
    }
}

/// A tree of glass, 64 bounces deep, adds up to the background within four roundings of the largest number in it.
#[test]
fn glass_keeps_all_light() {
    let mut random = Random::new(76);
    let shapes = [
        Shape::sphere(Vec3::ZERO, 1.0),
        Shape::axis_box(Vec3::splat(-0.6), Vec3::new(0.5, 0.6, 0.7)),
        Shape::cone(Vec3::new(-0.2, -0.7, 0.0), 0.8, Vec3::new(0.1, 0.8, 0.2), 0.3).capped(),
    ];
    let mut worst = 0.0_f32;
    for shape in shapes {
        for index in [1.1, 1.5, 2.4, 10.0, 0.7] {
            let glass = [Object::new(shape, Material::dielectric(index))];
            let scene = scene(Background::Solid(Rgb::WHITE)).with_objects(&glass);
            let tracer = Alone::try_new(&scene).unwrap();
            for _ in 0..500 {
                let origin = single(plus([0.0; 3], 3.0, random.direction()));
                let target = single(plus([0.0; 3], random.unit(), random.direction()));
                let (light, _) =
                    shoot(&tracer, Ray { origin, direction: (target - origin).normalized() }, BOUNCES as u8);
                worst = worst.max((light.r - 1.0).abs());
            }
        }
    }
    println!("{worst:e}");
    assert!(worst <= 4.0 * f32::EPSILON, "{worst:e}");
}
