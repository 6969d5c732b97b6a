//! Rays that leave a surface do not meet it again, and those that go into a solid meet it from within.
//!
//! The test of `hard_cases_shapes`, with shapes of all sizes that there is room for, down to [`SMALLEST`] spacings of the
//! numbers: what is smaller is smaller than the room that rays are given to leave it.

use rayon::prelude::*;
use whit::math::{Q16, Q20};
use whit::scene::{Cone, Triangle};
use whit::{Background, Camera, Intersection, Material, Object, Ray, Real, Rgb, Scene, Shape, Tracer, Vec3};

use super::exact::{Vector, cross, dot, exact, length, plus, rounded, times, unit};
use super::meshes::Mesh;
use super::random::Random;
use super::solids::{depth, is_near_rim};
use super::{ALL, cases, converted, to_f32};

/// The size of the smallest shapes, in spacings of the numbers.
const SMALLEST: f64 = 32.0;
/// Nearer to an edge of a solid than so many spacings, a ray may be taken for one on the other side of it.
const NEAR_EDGE: f64 = 8.0;

/// The cosine of a ray along a cone that comes to the tip, where the side ends.
const GRAZING: f64 = 1.0 / 256.0;

const SHAPES: u64 = 300;
const RAYS_TO_EACH: usize = 10;
const RAYS_FROM_EACH: usize = 30;

#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// What has two sides and no inside.
    Flat,
    /// What is closed.
    Solid,
    /// What has an inside, and no ends.
    Tube,
}

type Make = fn(&mut Random, Room) -> (Vec<Shape<'static, f32>>, Vector);

/// What shapes there is room for.
#[derive(Clone, Copy)]
struct Room {
    /// The spacing of the numbers.
    spacing: f64,
    /// The largest coordinate.
    largest: f64,
}

impl Room {
    fn of<T: Real>() -> Self {
        Self { spacing: T::SMALLEST.to_f32().into(), largest: T::RANGE.unwrap().coordinate.into() }
    }

    /// A size, all decades alike, of which three are within the range.
    fn size(self, random: &mut Random) -> f64 {
        let (low, high) = (SMALLEST * self.spacing, self.largest / 3.0);
        low * (high / low).powf(random.unit())
    }

    /// A place for what is so large.
    fn place(self, random: &mut Random, size: f64) -> Vector {
        times(random.in_cube(), (size * random.decades(3.0)).min(self.largest - 2.0 * size))
    }
}

/// A direction from a surface: any, or nearly along it to either side.
fn away(random: &mut Random, normal: Vector, room: Room) -> Vector {
    let any = random.direction();
    if random.below(2) == 0 {
        return any;
    }
    let along = plus(any, times(normal, -dot(any, normal)));
    unit(plus(unit(along), times(normal, random.signed_decades(1.0) * 16.0 * room.spacing)))
}

/// What is wrong about a ray that left where `hit` is and what it then meets.
fn judge<T: Real>(
    form: Form,
    shapes: &[Shape<'_, f32>],
    hit: &Intersection<T>,
    ray: &Ray<T>,
    again: Option<&Intersection<T>>,
) -> Option<&'static str> {
    let wide = |v: Vec3<T>| exact(v.map(T::to_f32));
    let room = Room::of::<T>();
    let is_flat = form == Form::Flat;
    let (normal, direction) = (wide(hit.normal), wide(ray.direction));
    let goes_away = ray.direction.dot(hit.normal) > T::ZERO;
    let depth = shapes.iter().map(|shape| depth(shape, wide(ray.origin))).fold(f64::INFINITY, f64::min);
    if goes_away && depth > 0.0 || is_flat && !goes_away && depth < 0.0 {
        return Some("starts on the wrong side");
    }
    let moved = if shapes.iter().any(is_pointed) { length(wide(hit.offset)) } else { 0.0 };
    let cosine = dot(normal, direction).abs();
    if cosine < 4.0 * room.spacing || cosine < GRAZING && shapes.iter().any(is_pointed) {
        return None;
    }
    match again {
        Some(_) if is_flat || goes_away => Some("meets it again"),
        _ if is_flat || goes_away || depth <= NEAR_EDGE * room.spacing + moved => None,
        _ if shapes.iter().any(|shape| is_near_rim(shape, &narrow(ray), NEAR_EDGE * room.spacing)) => None,
        Some(again) if again.from_outside => Some("meets it from the wrong side"),
        None if form == Form::Solid => Some("gets out of it"),
        _ => None,
    }
}

/// A cone with a tip: a ray along its side comes there, and a place near it is nearer to the side opposite.
fn is_pointed(shape: &Shape<'_, f32>) -> bool {
    matches!(shape, Shape::Cone(cone) if cone.apex_radius != cone.base_radius)
}

fn narrow<T: Real>(ray: &Ray<T>) -> Ray<f32> {
    Ray { origin: ray.origin.map(T::to_f32), direction: ray.direction.map(T::to_f32) }
}

/// Faults of rays that leave a shape where random rays meet it, and how many left.
fn faults<T: Real>(form: Form, make: Make, random: &mut Random) -> (Vec<String>, usize) {
    let room = Room::of::<T>();
    let (shapes, target) = make(random, room);
    let objects: Vec<_> = shapes.iter().map(|shape| Object::new(*shape, Material::matte(Rgb::WHITE))).collect();
    let scene = converted::<T>(&scene_of(&objects));
    let scene = scene.as_scene();
    let tracer = Tracer::<T, ALL, 0>::try_new(&scene).unwrap();
    // As they are when the numbers are rounded.
    let back = to_f32(&scene);
    let shapes: Vec<_> = back.as_scene().objects.iter().map(|object| object.shape).collect();
    let (mut faults, mut count) = (Vec::new(), 0);
    for _ in 0..RAYS_TO_EACH {
        let origin =
            plus(target, times(random.direction(), room.size(random))).map(|x| x.clamp(-room.largest, room.largest));
        let towards = plus(target, times(origin, -1.0));
        if length(towards) < 1e-9 {
            continue;
        }
        let vector = |v: Vector| rounded(v).map(T::from_f32);
        let first = Ray { origin: vector(origin), direction: vector(unit(towards)).normalized() };
        let Some(hit) = tracer.intersect(&first) else { continue };
        for _ in 0..RAYS_FROM_EACH {
            let direction = vector(away(random, exact(hit.normal.map(T::to_f32)), room)).normalized();
            let ray = hit.leave(direction);
            let again = tracer.intersect(&ray);
            count += 1;
            if let Some(fault) = judge(form, &shapes, &hit, &ray, again.as_ref()) {
                faults.push(format!(
                    "{fault}: {shapes:?}
 {first:?}
 {hit:?}
 {ray:?}
 {again:?}"
                ));
            }
        }
    }
    (faults, count)
}

fn scene_of<'a>(objects: &'a [Object<'a, f32>]) -> Scene<'a, f32> {
    let camera = Camera::look_at(Vec3::new(0.0, 0.0, 1.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(objects)
}

fn assert_never_met_again(case: u64, form: Form, make: Make) {
    assert_never_met_again_in::<Q16>(case, form, make);
    assert_never_met_again_in::<Q20>(case, form, make);
}

fn assert_never_met_again_in<T: Real>(case: u64, form: Form, make: Make) {
    let of = |round| faults::<T>(form, make, &mut Random::new(case, round));
    let all: Vec<_> = (0..cases(SHAPES)).into_par_iter().map(of).collect();
    let count: usize = all.iter().map(|(_, count)| count).sum();
    let faults: Vec<_> = all.into_iter().flat_map(|(faults, _)| faults).collect();
    let first = faults.iter().take(3).cloned().collect::<Vec<_>>().join("\n");
    assert!(faults.is_empty(), "{} of {count} rays:\n{first}", faults.len());
    assert!(count as u64 > SHAPES * 30, "only {count} rays");
}

fn sphere(random: &mut Random, room: Room) -> (Vec<Shape<'static, f32>>, Vector) {
    let radius = room.size(random);
    let center = room.place(random, radius);
    let target = plus(center, times(random.direction(), radius));
    (vec![Shape::sphere(rounded(center), radius as f32)], target)
}

#[test]
fn spheres() {
    assert_never_met_again(1, Form::Solid, sphere);
}

#[test]
fn boxes() {
    assert_never_met_again(2, Form::Solid, |random, room| {
        let sides: Vector = [0; 3].map(|_| room.size(random));
        let low = room.place(random, length(sides) / 2.0);
        let mut target: Vector = std::array::from_fn(|i| low[i] + random.unit() * sides[i]);
        let face = random.below(6);
        target[face / 2] = low[face / 2] + sides[face / 2] * (face % 2) as f64;
        (vec![Shape::axis_box(rounded(low), rounded(plus(low, sides)))], target)
    });
}

/// What enters a box next to an edge, and goes out of the other face there, does get out.
#[test]
fn edges_of_boxes() {
    edges::<Q16>();
    edges::<Q20>();
}

fn edges<T: Real>() {
    let (low, high) = (Vec3::new(-1.0, -2.0, 0.25), Vec3::new(1.5, 0.5, 3.0));
    let objects = [Object::new(Shape::axis_box(low, high), Material::matte(Rgb::WHITE))];
    let scene = converted::<T>(&scene_of(&objects));
    let scene = scene.as_scene();
    let tracer = Tracer::<T, ALL, 0>::try_new(&scene).unwrap();
    let c = T::from_f32;
    for steps in 0..4 {
        let within = (0..steps).fold(c(high.x), |x, _| x - T::SMALLEST);
        // Into the upper face, straight down.
        let first = Ray { origin: Vec3::new(within, c(3.0), c(1.0)), direction: Vec3::new(T::ZERO, -T::ONE, T::ZERO) };
        let hit = tracer.intersect(&first).unwrap();
        assert!(hit.normal.y == T::ONE, "{hit:?}");
        for aside in [0.1, 0.6, 0.999] {
            let direction = Vec3::new(c(aside), -c((1.0 - aside * aside).sqrt()), T::ZERO).normalized();
            let again = tracer.intersect(&hit.leave(direction));
            assert!(again.is_some_and(|again| !again.from_outside), "{steps} {aside}: {hit:?} {again:?}");
        }
    }
}

#[test]
fn planes() {
    assert_never_met_again(3, Form::Flat, |random, room| {
        let place = times(random.in_cube(), room.largest);
        (vec![Shape::plane(rounded(place), rounded(random.direction()))], place)
    });
}

#[test]
fn discs() {
    assert_never_met_again(4, Form::Flat, |random, room| {
        let radius = room.size(random);
        let center = room.place(random, radius);
        (vec![Shape::disc(rounded(center), rounded(random.direction()), radius as f32)], center)
    });
}

/// Of which the shortest height is not the smallest size.
fn corners(random: &mut Random, room: Room) -> [Vector; 3] {
    loop {
        let size = room.size(random);
        let center = room.place(random, size);
        let corners = [0; 3].map(|_| plus(center, times(random.in_cube(), size)));
        let [ab, ac] = [1, 2].map(|i| plus(corners[i], times(corners[0], -1.0)));
        if length(cross(ab, ac)) > SMALLEST * room.spacing * (length(ab) + length(ac)) {
            return corners;
        }
    }
}

#[test]
fn triangles() {
    assert_never_met_again(5, Form::Flat, |random, room| {
        let [a, b, c] = corners(random, room);
        let weights = random.weights();
        let target = [a, b, c].iter().zip(weights).fold([0.0; 3], |sum, (v, weight)| plus(sum, times(*v, weight)));
        (vec![Shape::triangle(rounded(a), rounded(b), rounded(c))], target)
    });
}

#[test]
fn convex_meshes() {
    assert_never_met_again(6, Form::Solid, |random, room| {
        let size = 4.0 * room.size(random) / 8.0 + SMALLEST * 8.0 * room.spacing;
        let sides = std::array::from_fn(|_| size * random.decades(0.3));
        let mesh = Mesh::icosahedron().placed(sides, room.place(random, 2.0 * size)).triangles();
        let Triangle { vertices: [a, b, c] } = mesh[random.below(20)];
        let target = exact((a + b + c) * (1.0 / 3.0));
        (mesh.into_iter().map(Shape::Triangle).collect(), target)
    });
}

/// A cone and a place on its side or at an end.
fn cone(random: &mut Random, room: Room, taper: f64, capped: bool) -> (Vec<Shape<'static, f32>>, Vector) {
    let size = room.size(random);
    let height = (size * random.decades(1.0)).clamp(SMALLEST * room.spacing, room.largest / 3.0);
    let radius = size.min(3.9 * height) / taper.max(1.0);
    let base = room.place(random, height + size);
    let up = match random.below(4) {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, -1.0, 0.0],
        _ => random.direction(),
    };
    let aside = unit(cross(up, random.direction()));
    let (along, reach) = match random.below(4) {
        0 => (0.0, random.unit()),
        1 => (1.0, random.unit()),
        _ => (random.unit(), 1.0),
    };
    let around = plus(times(up, height * along), times(aside, reach * radius * (1.0 + (taper - 1.0) * along)));
    let (base_radius, apex_radius) = (radius as f32, (radius * taper) as f32);
    let apex = plus(base, times(up, height));
    let cone = Cone { base: rounded(base), apex: rounded(apex), base_radius, apex_radius, capped };
    (vec![Shape::Cone(cone)], plus(base, around))
}

#[test]
fn cylinders() {
    assert_never_met_again(7, Form::Tube, |random, room| cone(random, room, 1.0, false));
    assert_never_met_again(8, Form::Solid, |random, room| cone(random, room, 1.0, true));
}

#[test]
fn cones() {
    assert_never_met_again(9, Form::Tube, |random, room| cone(random, room, 0.0, false));
    assert_never_met_again(10, Form::Solid, |random, room| cone(random, room, 0.0, true));
    assert_never_met_again(11, Form::Tube, |random, room| cone(random, room, 0.5, false));
    assert_never_met_again(12, Form::Solid, |random, room| cone(random, room, 0.5, true));
    assert_never_met_again(13, Form::Solid, |random, room| cone(random, room, 3.0, true));
}
