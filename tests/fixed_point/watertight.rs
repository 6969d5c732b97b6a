//! Closed meshes have no holes: rays from inside always get to a triangle, also through edges and corners.

use rayon::prelude::*;
use whit::math::{Q16, Q20};
use whit::scene::Triangle;
use whit::{Background, Camera, Material, Object, Ray, Real, Rgb, Scene, Shape, Tracer, Vec3};

use super::exact::{Vector, minus, plus, times, unit};
use super::meshes::Mesh;
use super::random::Random;
use super::{ALL, cases};

const RAYS: usize = 300;

#[test]
fn rays_from_inside_meet_the_mesh() {
    assert_watertight::<Q16>(1);
    assert_watertight::<Q20>(2);
}

fn assert_watertight<T: Real>(case: u64) {
    let faults: Vec<_> =
        (0..cases(150)).into_par_iter().filter_map(|round| hole::<T>(&mut Random::new(case, round))).collect();
    assert!(faults.is_empty(), "{} meshes have holes:\n{}", faults.len(), faults[0]);
}

/// A ray from inside of a random mesh that meets none of its triangles.
fn hole<T: Real>(random: &mut Random) -> Option<String> {
    let spacing = f64::from(T::SMALLEST.to_f32());
    let largest = f64::from(T::RANGE.unwrap().coordinate);
    // All sizes from some thousand spacings, in which neighbours are still apart, to the whole range.
    let size = 4096.0 * spacing * (largest / 2.0 / (4096.0 * spacing)).powf(random.unit());
    let center = times(random.in_cube(), (size * random.decades(2.0)).min(largest - 2.0 * size));
    let mesh = Mesh::jittered_ball(2, 0.2, random).placed([size; 3], center);
    let triangles: Vec<Triangle<T>> =
        mesh.triangles().iter().map(|t| Triangle { vertices: t.vertices.map(|v| v.map(T::from_f32)) }).collect();
    let objects = [Object::new(Shape::Triangles(&triangles), Material::matte(Rgb::WHITE))];
    let scene = scene(&objects);
    let tracer = Tracer::<T, ALL, 0>::try_new(&scene).unwrap();
    let wide = |v: Vec3<T>| -> Vector {
        let Vec3 { x, y, z } = v.map(T::to_f32);
        [x, y, z].map(f64::from)
    };
    for _ in 0..RAYS {
        let origin = mesh.inside(0.4, random).map(T::from_f32);
        let vertices = triangles[random.below(triangles.len())].vertices.map(wide);
        // Into a face, an edge or a corner.
        let weights = match random.below(3) {
            0 => random.weights(),
            1 => {
                let share = random.unit();
                [share, 1.0 - share, 0.0]
            }
            _ => [1.0, 0.0, 0.0],
        };
        let target = (0..3).fold([0.0; 3], |sum, i| plus(sum, times(vertices[i], weights[i])));
        let Vec3 { x, y, z } = direction::<T>(unit(minus(target, wide(origin))));
        let ray = Ray { origin, direction: Vec3::new(x, y, z) };
        match tracer.intersect(&ray) {
            None => return Some(format!("size {size}: {ray:?}")),
            Some(hit) if hit.from_outside => return Some(format!("size {size}, from outside: {ray:?} {hit:?}")),
            Some(_) => {}
        }
    }
    None
}

fn direction<T: Real>(v: Vector) -> Vec3<T> {
    let [x, y, z] = v.map(|x| T::from_f32(x as f32));
    Vec3::new(x, y, z).normalized()
}

fn scene<'a, T: Real>(objects: &'a [Object<'a, T>]) -> Scene<'a, T> {
    let (o, i) = (T::ZERO, T::ONE);
    let camera = Camera::with_half_height(Vec3::new(o, o, i), Vec3::ZERO, Vec3::new(o, i, o), i);
    Scene::new(camera, Background::Solid(Rgb::BLACK)).with_objects(objects)
}
