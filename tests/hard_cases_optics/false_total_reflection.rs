//! Light that gets into a ball or between two parallel faces gets out again: it meets the other side at the angle that
//! it got in with, so no total reflection can happen. Rays that graze the surface come next to the critical angle. More
//! than two million of them enter here.

use rayon::prelude::*;
use whit::scene::Triangle;
use whit::{Background, Material, Object, Ray, Rgb, Scene, Shape, Tracer, Vec3};

use crate::naive::glass_ball::{self, Way};
use crate::support::{Alone, Nested, Random, cross, dot, double, plus, scene, shoot, single, unit};

const ALL: u64 = whit::Effects::ALL.bits();
const INDICES: [f32; 10] = [1.0001, 1.01, 1.1, 1.31, 1.333, 1.5, 1.7, 2.0, 2.417, 3.0];
/// Internal reflections are followed, too.
const DEPTH: u8 = 8;

/// Of so many rays that entered, so many told of a total reflection.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Count {
    entered: u64,
    total: u64,
}

impl Count {
    fn plus(self, other: Self) -> Self {
        Self { entered: self.entered + other.entered, total: self.total + other.total }
    }
}

fn count<const MEDIA: usize>(tracer: &Tracer<'_, f32, ALL, 66, MEDIA>, rays: impl Iterator<Item = Ray<f32>>) -> Count {
    rays.fold(Count::default(), |sum, ray| {
        let (_, stats) = shoot(tracer, ray, DEPTH);
        // Where all of the light is reflected outside, nothing enters.
        let entered = u64::from(stats.transmitted > 0);
        sum.plus(Count { entered, total: u64::from(stats.total_internal > 0) })
    })
}

/// Adds up what was counted for each index, and shows where it is not 0.
fn sum(name: &str, counts: impl IntoIterator<Item = (f32, Count)>) -> Count {
    let counts: Vec<_> = counts.into_iter().collect();
    for index in INDICES {
        let of_index = counts.iter().filter(|(n, _)| *n == index).fold(Count::default(), |a, (_, b)| a.plus(*b));
        if of_index.total > 0 {
            println!("{name}, n = {index}: {} of {}", of_index.total, of_index.entered);
        }
    }
    let all = counts.iter().fold(Count::default(), |a, (_, b)| a.plus(*b));
    println!("{name}: {} of {}", all.total, all.entered);
    all
}

/// A vacuum around glass.
fn vacuum<'a>() -> Scene<'a, f32> {
    scene(Background::Solid(Rgb::WHITE))
}

/// A ray with the given distance from a point to its line, as a share of a radius, from some radii away.
fn ray_past(random: &mut Random, center: [f64; 3], radius: f64, impact: f64) -> Ray<f32> {
    let (along, other) = (random.direction(), random.direction());
    let across = unit(plus(other, -dot(other, along), along));
    let away = [1.2, 3.0, 30.0][(random.unit() * 3.0) as usize];
    let origin = plus(plus(center, radius * impact, across), -radius * away, along);
    Ray { origin: single(origin), direction: single(along).normalized() }
}

/// 1 − 10⁻ᵏ for k from 0 to 9.
fn grazing(random: &mut Random) -> f64 {
    1.0 - 10_f64.powf(random.between(-9.0, 0.0))
}

/// A ball somewhere: index, centre and radius.
type Ball = (f32, Vec3<f32>, f32);

fn balls() -> Vec<Ball> {
    let mut balls = Vec::new();
    for n in INDICES {
        for radius in [1e-6_f32, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6] {
            for away in [0.0, 1.0, 1e3] {
                balls.push((n, Vec3::new(0.6, -0.7, 0.4) * (radius * away), radius));
            }
        }
    }
    balls
}

fn rays_past((n, center, radius): Ball, count: usize) -> impl Iterator<Item = Ray<f32>> {
    let mut random = Random::new(u64::from(n.to_bits() ^ radius.to_bits() ^ center.x.to_bits()));
    (0..count).map(move |_| {
        let impact = grazing(&mut random);
        ray_past(&mut random, double(center), radius.into(), impact)
    })
}

/// The textbook's formulas report what cannot be.
#[test]
fn the_textbook_form_reports_some() {
    let counts = balls().into_par_iter().map(|ball| {
        let array = |v: Vec3<f32>| [v.x, v.y, v.z];
        let (n, center, radius) = ball;
        let ways = rays_past(ball, 500).map(|ray| {
            let way = glass_ball::follow(array(ray.origin), array(ray.direction), array(center), radius, n);
            Count { entered: u64::from(way != Way::Past), total: u64::from(way == Way::Inside) }
        });
        (n, ways.fold(Count::default(), Count::plus))
    });
    let all = sum("textbook", counts.collect::<Vec<_>>());
    assert!(all.entered > 50_000 && all.total > 1000, "{all:?}");
}

#[test]
fn a_ball_never_reflects_totally() {
    let counts = balls().into_par_iter().map(|ball| {
        let (n, center, radius) = ball;
        let objects = [Object::new(Shape::sphere(center, radius), Material::dielectric(n))];
        let scene = vacuum().with_objects(&objects);
        (n, count(&Alone::try_new(&scene).unwrap(), rays_past(ball, 10_000)))
    });
    let all = sum("ball", counts.collect::<Vec<_>>());
    assert!(all.entered > 1_700_000, "{all:?}");
    assert_eq!(all.total, 0, "total reflections, of {} rays that entered", all.entered);
}

/// A denser ball in the middle of a ball. By the invariant n·sin θ·r the angles at both surfaces are never beyond the
/// critical ones.
#[test]
fn a_ball_in_a_ball_never_reflects_totally() {
    let pairs: Vec<_> = INDICES.windows(2).flat_map(|n| [0.3_f32, 0.6, 0.95].map(|r| (n[0], n[1], r))).collect();
    let counts = pairs.into_par_iter().map(|(outer, inner, ratio)| {
        let mut both = Count::default();
        for (center, radius) in [(Vec3::ZERO, 1.0_f32), (Vec3::new(600.0, -700.0, 400.0), 1.0), (Vec3::ZERO, 1e4)] {
            let ball = |radius, n, priority| {
                Object::new(Shape::sphere(center, radius), Material::dielectric(n).with_priority(priority))
            };
            let objects = [ball(radius, outer, 1), ball(radius * ratio, inner, 2)];
            let scene = vacuum().with_objects(&objects);
            let mut random = Random::new(u64::from(inner.to_bits() ^ ratio.to_bits()));
            let rays = (0..1500).map(|i| {
                // Half of them graze the inner ball.
                let most = if i % 2 == 0 { 1.0 } else { f64::from(ratio * outer).min(1.0) };
                let impact = most * grazing(&mut random);
                ray_past(&mut random, double(center), radius.into(), impact)
            });
            both = both.plus(count(&Nested::try_new(&scene).unwrap(), rays));
        }
        (outer, both)
    });
    let all = sum("ball in ball", counts.collect::<Vec<_>>());
    assert!(all.entered > 80_000, "{all:?}");
    assert_eq!(all.total, 0, "total reflections, of {} rays that entered", all.entered);
}

/// Rays that graze the plane through a point, seen from the side that the unit normal points to.
fn rays_along(point: [f64; 3], normal: [f64; 3], count: usize, seed: u64) -> impl Iterator<Item = Ray<f32>> {
    let mut random = Random::new(seed);
    (0..count).map(move |_| {
        let other = random.direction();
        let along = unit(plus(other, -dot(other, normal), normal));
        // From so high above that rounding does not put the origin below.
        let (cosine, height) = (10_f64.powf(random.between(-5.0, -0.5)), random.between(0.05, 0.5));
        let direction = unit(plus(along, -cosine, normal));
        let origin = plus(plus(point, random.unit(), along), -height / cosine, direction);
        Ray { origin: single(origin), direction: single(direction).normalized() }
    })
}

/// Only the largest faces are met. Through neighbouring faces of a box there are total reflections, and rightly so.
#[test]
fn a_slab_never_reflects_totally() {
    let counts = INDICES.into_par_iter().map(|n| {
        let solid = Shape::axis_box(Vec3::new(-1e5, -0.3, -1e5), Vec3::new(1e5, 0.7, 1e5));
        let objects = [Object::new(solid, Material::dielectric(n))];
        let scene = vacuum().with_objects(&objects);
        let rays = rays_along([0.0, f64::from(0.7_f32), 0.0], [0.0, 1.0, 0.0], 20_000, 112);
        (n, count(&Alone::try_new(&scene).unwrap(), rays))
    });
    let all = sum("slab", counts.collect::<Vec<_>>());
    assert!(all.entered > 150_000, "{all:?}");
    assert_eq!(all.total, 0, "total reflections, of {} rays that entered", all.entered);
}

#[test]
fn parallel_planes_never_reflect_totally() {
    let counts = INDICES.into_par_iter().map(|n| {
        let mut random = Random::new(113);
        let of_pair = |_| {
            let normal = single(random.direction());
            let point = single(plus([0.0; 3], 10.0, random.direction()));
            let behind = single(plus(double(point), -1.0, double(normal)));
            let faces = [Shape::plane(point, normal), Shape::plane(behind, -normal)];
            let objects = faces.map(|face| Object::new(face, Material::dielectric(n)));
            let scene = vacuum().with_objects(&objects);
            let rays = rays_along(double(point), unit(double(normal)), 200, 114);
            count(&Alone::try_new(&scene).unwrap(), rays)
        };
        (n, (0..50).map(of_pair).fold(Count::default(), Count::plus))
    });
    let all = sum("planes", counts.collect::<Vec<_>>());
    assert!(all.entered > 50_000, "{all:?}");
    assert_eq!(all.total, 0, "total reflections, of {} rays that entered", all.entered);
}

/// Two triangles across a whole-number normal: the corners are whole numbers, so they are parallel without any error.
fn parallel_triangles(random: &mut Random) -> (Triangle<f32>, Triangle<f32>, [f64; 3]) {
    let mut whole = |size: f64| [1.0; 3].map(|_: f64| random.between(-size, size).round());
    let normal = whole(5.0).map(|x| if x == 0.0 { 1.0 } else { x });
    let [p, q, _] = normal;
    let u = [q, -p, 0.0];
    let (u, v) = (u.map(|x| x * 60.0), cross(normal, u).map(|x| x * 8.0));
    let shift = whole(3.0);
    // Behind the front.
    let shift = match dot(shift, normal) {
        x if x > 0.0 => shift.map(|x| -x),
        x if x < 0.0 => shift,
        _ => normal.map(|x| -x.signum()),
    };
    let corner = |origin: [f64; 3], a: f64, b: f64| single(plus(plus(origin, a, u), b, v));
    let front = [corner([0.0; 3], -3.0, -3.0), corner([0.0; 3], 6.0, -3.0), corner([0.0; 3], -3.0, 6.0)];
    let back = [corner(shift, -3.0, -6.0), corner(shift, -6.0, 9.0), corner(shift, 9.0, -3.0)];
    (Triangle { vertices: front }, Triangle { vertices: back }, unit(normal))
}

#[test]
fn parallel_triangles_never_reflect_totally() {
    let counts = INDICES.into_par_iter().map(|n| {
        let mut random = Random::new(115);
        let of_pair = |_| {
            let (front, back, normal) = parallel_triangles(&mut random);
            let faces = [front, back].map(Shape::Triangle);
            let objects = faces.map(|face| Object::new(face, Material::dielectric(n)));
            let scene = vacuum().with_objects(&objects);
            count(&Alone::try_new(&scene).unwrap(), rays_along([0.0; 3], normal, 200, 116))
        };
        (n, (0..50).map(of_pair).fold(Count::default(), Count::plus))
    });
    let all = sum("triangles", counts.collect::<Vec<_>>());
    assert!(all.entered > 80_000, "{all:?}");
    assert_eq!(all.total, 0, "total reflections, of {} rays that entered", all.entered);
}
