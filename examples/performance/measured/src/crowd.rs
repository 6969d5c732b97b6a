//! Many objects: spheres or triangles, in place of the balls of the built-in flake.

use fastrand::Rng;
use whit::Vec3;
use whit::scene::{Sphere, Triangle};
use whit::scenes::flake_spheres;

pub enum Crowd {
    Spheres(Vec<Sphere<f32>>),
    Triangles(Vec<Triangle<f32>>),
}

impl Crowd {
    pub fn new(scene: &str, count: usize) -> Result<Self, String> {
        match scene {
            "flake" => flake(count).map(Self::Spheres),
            "balls" => Ok(Self::Spheres(balls(count))),
            "mesh" => Ok(Self::Triangles(mesh(count))),
            _ => Err(format!("{scene}: expected flake, balls or mesh")),
        }
    }

    /// Centre and radius of each sphere, or the corners of each triangle.
    pub fn numbers(&self) -> Vec<f32> {
        let vector = |v: &Vec3<f32>| [v.x, v.y, v.z];
        match self {
            Self::Spheres(spheres) => {
                let numbers = |s: &Sphere<f32>| [s.center.x, s.center.y, s.center.z, s.radius];
                spheres.iter().flat_map(numbers).collect()
            }
            Self::Triangles(triangles) => triangles.iter().flat_map(|t| t.vertices.iter().flat_map(vector)).collect(),
        }
    }
}

/// The first spheres of the flake, generation by generation.
fn flake(count: usize) -> Result<Vec<Sphere<f32>>, String> {
    const MOST: usize = 7381;
    let some = flake_spheres::<MOST>().get(..count).map(<[_]>::to_vec);
    some.ok_or_else(|| format!("a flake of {count}: expected at most {MOST}"))
}

/// Spheres at random in a ball over the floor, of which they fill a twentieth, however many they are.
fn balls(count: usize) -> Vec<Sphere<f32>> {
    const SIZE: f32 = 0.8;
    const MIDDLE: Vec3<f32> = Vec3::new(0.0, 0.0, 0.4);
    let mut random = Rng::with_seed(1);
    let radius = SIZE * (0.05 / count as f32).cbrt();
    let place = || Vec3::new(random.f32(), random.f32(), random.f32()) * 2.0 - Vec3::splat(1.0);
    let inside = std::iter::repeat_with(place).filter(|at| at.length() <= 1.0);
    inside.map(|at| Sphere { center: MIDDLE + at * SIZE, radius }).take(count).collect()
}

/// The first triangles of a torus of about so many, twice as many along it as around.
fn mesh(count: usize) -> Vec<Triangle<f32>> {
    let around = ((count as f32 / 4.0).sqrt().round() as usize).max(3);
    let along = count.div_ceil(2 * around).max(3);
    let corner = |i: usize, j: usize| {
        let angle = |i: usize, of: usize| (i % of) as f32 / of as f32 * std::f32::consts::TAU;
        let (u, v) = (angle(i, along), angle(j, around));
        let reach = 0.7 + 0.25 * v.cos();
        Vec3::new(reach * u.cos(), reach * u.sin(), 0.25 * v.sin())
    };
    let squares = (0..along).flat_map(|i| (0..around).map(move |j| (i, j)));
    let halves = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        [Triangle { vertices: [a, b, c] }, Triangle { vertices: [a, c, d] }]
    });
    halves.take(count).collect()
}
