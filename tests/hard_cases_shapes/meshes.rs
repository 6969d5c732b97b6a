//! Closed meshes.

use std::collections::HashMap;

use whit::Vec3;
use whit::scene::Triangle;

use crate::exact::{Vector, cross, exact, minus, plus, rounded, times, unit};
use crate::random::Random;

/// A closed mesh whose faces are counter-clockwise from outside. All of it is seen from its centre.
#[derive(Clone, Debug)]
pub struct Mesh {
    pub center: Vector,
    pub vertices: Vec<Vec3<f32>>,
    pub faces: Vec<[usize; 3]>,
}

/// A place on a mesh that more than one face shares.
pub struct Seam {
    /// The corners; one twice for a corner.
    pub ends: [usize; 2],
    pub faces: Vec<usize>,
}

impl Mesh {
    fn new(vertices: &[Vector], faces: Vec<[usize; 3]>) -> Self {
        Self { center: [0.0; 3], vertices: vertices.iter().map(|v| rounded(*v)).collect(), faces }
    }

    pub fn tetrahedron() -> Self {
        let vertices = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        Self::new(&vertices, vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
    }

    pub fn octahedron() -> Self {
        let axis = |i: usize, x: f64| std::array::from_fn(|j| if i == j { x } else { 0.0 });
        let vertices: Vec<Vector> = (0..6).map(|i| axis(i % 3, if i < 3 { 1.0 } else { -1.0 })).collect();
        let faces = vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
        Self::new(&vertices, faces)
    }

    /// 12 triangles; bit k of a corner is its side along axis k.
    pub fn cube() -> Self {
        let side = |corner: usize, k: usize| if corner >> k & 1 == 0 { -1.0 } else { 1.0 };
        let vertices: Vec<Vector> = (0..8).map(|corner| [0, 1, 2].map(|k| side(corner, k))).collect();
        let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        Self::new(&vertices, quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
    }

    pub fn icosahedron() -> Self {
        let g = (1.0 + 5.0_f64.sqrt()) / 2.0;
        let corner = |i: usize| {
            let (a, b) = (if i & 1 == 0 { 1.0 } else { -1.0 }, if i & 2 == 0 { g } else { -g });
            [[0.0, a, b], [a, b, 0.0], [b, 0.0, a]][i / 4]
        };
        let vertices: Vec<Vector> = (0..12).map(|i| unit(corner(i))).collect();
        let near = |a: usize, b: usize| {
            let between = minus(vertices[a], vertices[b]);
            crate::exact::length(between) < 1.2
        };
        let mut faces = Vec::new();
        for a in 0..12 {
            for b in a + 1..12 {
                for c in b + 1..12 {
                    if near(a, b) && near(b, c) && near(c, a) {
                        let normal = cross(minus(vertices[b], vertices[a]), minus(vertices[c], vertices[a]));
                        let is_outward = crate::exact::dot(normal, vertices[a]) > 0.0;
                        faces.push(if is_outward { [a, b, c] } else { [a, c, b] });
                    }
                }
            }
        }
        assert_eq!(faces.len(), 20);
        Self::new(&vertices, faces)
    }

    /// Each face of an icosahedron in four, so many times.
    pub fn ball_of_triangles(times_divided: u32) -> Self {
        let mut mesh = Self::icosahedron();
        for _ in 0..times_divided {
            let mut middles = HashMap::new();
            let mut vertices = mesh.vertices.clone();
            let mut middle = |a: usize, b: usize| {
                *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                    vertices.push(rounded(unit(plus(exact(mesh.vertices[a]), exact(mesh.vertices[b])))));
                    vertices.len() - 1
                })
            };
            let divide = |&[a, b, c]: &[usize; 3]| {
                let (d, e, f) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, d, f], [b, e, d], [c, f, e], [d, e, f]]
            };
            mesh.faces = mesh.faces.iter().flat_map(divide).collect();
            mesh.vertices = vertices;
        }
        mesh
    }

    /// A ball with each corner moved by up to this part of its radius, inwards and outwards.
    pub fn jittered_ball(times_divided: u32, part: f64, random: &mut Random) -> Self {
        let mut mesh = Self::ball_of_triangles(times_divided);
        for vertex in &mut mesh.vertices {
            *vertex = rounded(times(exact(*vertex), 1.0 + part * random.symmetric()));
        }
        mesh
    }

    /// The same mesh, its sides multiplied and then moved.
    pub fn placed(&self, size: Vector, center: Vector) -> Self {
        let place = |v: &Vec3<f32>| {
            let v = exact(*v);
            rounded([0, 1, 2].map(|i| v[i] * size[i] + center[i]))
        };
        Self { center, vertices: self.vertices.iter().map(place).collect(), faces: self.faces.clone() }
    }

    pub fn triangles(&self) -> Vec<Triangle<f32>> {
        self.faces.iter().map(|face| Triangle { vertices: face.map(|i| self.vertices[i]) }).collect()
    }

    /// All edges and corners with the faces around them; each edge has two.
    pub fn seams(&self) -> Vec<Seam> {
        let mut seams = HashMap::<[usize; 2], Vec<usize>>::new();
        for (number, &[a, b, c]) in self.faces.iter().enumerate() {
            for (x, y) in [(a, b), (b, c), (c, a), (a, a), (b, b), (c, c)] {
                seams.entry([x.min(y), x.max(y)]).or_default().push(number);
            }
        }
        let mut seams: Vec<_> = seams.into_iter().map(|(ends, faces)| Seam { ends, faces }).collect();
        seams.sort_by_key(|seam| seam.ends);
        assert!(seams.iter().all(|seam| seam.ends[0] == seam.ends[1] || seam.faces.len() == 2), "a mesh with a hole");
        seams
    }

    /// The outward normal of a face, of any length.
    pub fn normal(&self, face: usize) -> Vector {
        let [a, b, c] = self.faces[face].map(|i| exact(self.vertices[i]));
        cross(minus(b, a), minus(c, a))
    }

    /// The largest distance of a corner from the centre.
    pub fn radius(&self) -> f64 {
        let far = |v: &Vec3<f32>| crate::exact::length(minus(exact(*v), self.center));
        self.vertices.iter().map(far).fold(0.0, f64::max)
    }

    /// A point inside: from the centre up to this part of the way to the surface.
    pub fn inside(&self, part: f64, random: &mut Random) -> Vec3<f32> {
        let face = self.faces[random.below(self.faces.len())].map(|i| exact(self.vertices[i]));
        let weights = random.weights();
        let surface = (0..3).fold([0.0; 3], |sum, i| plus(sum, times(face[i], weights[i])));
        let way = part * random.unit();
        rounded(plus(times(self.center, 1.0 - way), times(surface, way)))
    }
}
