//! Polygons and patches become triangles that tile them.

use std::collections::BTreeSet;

use whit::scene::nff::MAX_VERTICES;
use whit::{Object, Shape, Vec3};

use crate::{FILES, HEAD, Random, read_big};

type Point = [f64; 3];

fn exact(v: Vec3<f32>) -> Point {
    [v.x.into(), v.y.into(), v.z.into()]
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Newell's normal, of twice the polygon's area.
fn normal(outline: &[Point]) -> Point {
    let mut sum = [0.0; 3];
    for (i, a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        for k in 0..3 {
            sum[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        }
    }
    sum
}

fn length(v: Point) -> f64 {
    dot(v, v).sqrt()
}

/// The winding number of a flat outline around a point of its plane, by summing angles.
fn winding(outline: &[Point], up: Point, p: Point) -> f64 {
    let angle = |i: usize| {
        let (a, b) = (minus(outline[i], p), minus(outline[(i + 1) % outline.len()], p));
        let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        (dot(cross, up) / length(up)).atan2(dot(a, b))
    };
    (0..outline.len()).map(angle).sum::<f64>() / std::f64::consts::TAU
}

fn bits(v: Vec3<f32>) -> [u32; 3] {
    // Adding zero makes -0 and 0 one.
    [v.x + 0.0, v.y + 0.0, v.z + 0.0].map(f32::to_bits)
}

/// The same three corners, the smallest first.
pub(crate) fn cyclic(vertices: [Vec3<f32>; 3]) -> [[u32; 3]; 3] {
    let [a, b, c] = vertices.map(bits);
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap()
}

fn triangle(object: &Object<'_, f32>) -> [Vec3<f32>; 3] {
    match object.shape {
        Shape::Triangle(triangle) => triangle.vertices,
        Shape::SmoothTriangle(triangle) => triangle.vertices,
        other => panic!("{other:?}"),
    }
}

/// What makes triangles a tiling of a polygon: each is counter-clockwise and inside, their areas add up to the whole,
/// and they meet along edges of the same bits, each edge of the outline being an edge of one of them.
fn assert_tiles(outline: &[Vec3<f32>], triangles: &[[Vec3<f32>; 3]]) {
    let polygon: Vec<Point> = outline.iter().map(|v| exact(*v)).collect();
    let whole = normal(&polygon);
    let mut area = 0.0;
    let mut edges = std::collections::BTreeMap::new();
    let mut add = |from: Vec3<f32>, to: Vec3<f32>, n: i32| *edges.entry((bits(from), bits(to))).or_insert(0) += n;
    for corners in triangles {
        let corner = corners.map(exact);
        let part = normal(&corner);
        assert!(dot(part, whole) > 0.0, "{corner:?} is not counter-clockwise");
        area += length(part);
        let centroid = [0, 1, 2].map(|k| (corner[0][k] + corner[1][k] + corner[2][k]) / 3.0);
        let turns = winding(&polygon, whole, centroid);
        assert!((turns - 1.0).abs() < 1e-6, "{corner:?} has winding number {turns}");
        for k in 0..3 {
            add(corners[k], corners[(k + 1) % 3], 1);
            add(corners[(k + 1) % 3], corners[k], -1);
        }
    }
    assert!((area / length(whole) - 1.0).abs() < 1e-5, "{} of the area", area / length(whole));
    for (i, from) in outline.iter().enumerate() {
        let to = outline[(i + 1) % outline.len()];
        add(*from, to, -1);
        add(to, *from, 1);
    }
    assert!(edges.values().all(|n| *n == 0), "the outline of the triangles is that of the polygon");
}

/// The vertices of the polygons of a text, and of its patches.
fn outlines(text: &str) -> Vec<Vec<Vec3<f32>>> {
    let mut lines = text.lines();
    let mut outlines = Vec::new();
    while let Some(line) = lines.next() {
        if let Some(n) = line.strip_prefix("p ").or_else(|| line.strip_prefix("pp ")) {
            let vertex = |line: &str| {
                let numbers: Vec<f32> = line.split_whitespace().map(|word| word.parse().unwrap()).collect();
                Vec3::new(numbers[0], numbers[1], numbers[2])
            };
            outlines.push(lines.by_ref().take(n.parse().unwrap()).map(vertex).collect());
        }
    }
    outlines
}

fn assert_all_tile(text: &str) {
    let (_, scene) = read_big(text);
    let scene = scene.as_scene();
    let is_triangle = |object: &&Object<'_, f32>| matches!(object.shape, Shape::Triangle(_) | Shape::SmoothTriangle(_));
    let mut triangles = scene.objects.iter().filter(is_triangle).map(triangle);
    let has_area =
        |outline: &Vec<Vec3<f32>>| length(normal(&outline.iter().map(|v| exact(*v)).collect::<Vec<_>>())) > 1e-9;
    for outline in outlines(text).into_iter().filter(has_area) {
        let own: Vec<_> = triangles.by_ref().take(outline.len() - 2).collect();
        assert_tiles(&outline, &own);
    }
    assert_eq!(triangles.count(), 0);
}

#[test]
fn polygons_of_files_are_tiled() {
    for (_, text) in FILES {
        assert_all_tile(text);
    }
}

fn polygon(vertices: impl IntoIterator<Item = [f32; 3]>) -> String {
    let lines: Vec<String> = vertices.into_iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
    format!("{HEAD}p {}\n{}", lines.len(), lines.concat())
}

/// Deep concavities; the back of the comb is one straight run.
#[test]
fn combs_and_spirals_with_straight_runs_are_tiled() {
    let comb = |teeth: i32| {
        let upper =
            (0..2 * teeth).rev().flat_map(|x| if x % 2 == 0 { [(x + 1, 9), (x, 9)] } else { [(x + 1, 1), (x, 1)] });
        (0..=2 * teeth).map(|x| (x, 0)).chain(upper).map(|(x, y)| [x as f32, y as f32, 0.5]).collect::<Vec<_>>()
    };
    for teeth in 1..40 {
        assert_all_tile(&polygon(comb(teeth)));
    }
    let arm = |r: f32| (0..90).map(move |i| (i as f32 * 0.2, r * (1.0 + i as f32 * 0.1)));
    let spiral = arm(1.1).chain(arm(1.0).collect::<Vec<_>>().into_iter().rev());
    assert_all_tile(&polygon(spiral.map(|(angle, r)| [5.0, r * angle.cos(), r * angle.sin()])));
}

/// The outline of a set of unit squares, counter-clockwise, with a vertex at every lattice point. Where two squares
/// meet in a corner only, it turns to the one side or to the other. `None` if there are holes.
fn lattice_outline(squares: &BTreeSet<(i32, i32)>, turns_left: bool) -> Option<Vec<(i32, i32)>> {
    const WAYS: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
    let mut edges = BTreeSet::new();
    for &(x, y) in squares {
        let corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
        // The neighbour across side `way` is to its right.
        let is_open = |way: usize| !squares.contains(&(x + WAYS[way].1, y - WAYS[way].0));
        edges.extend((0..4).filter(|way| is_open(*way)).map(|way| (corners[way], way)));
    }
    let (mut at, mut way) = *edges.first()?;
    let mut outline = Vec::new();
    loop {
        edges.remove(&(at, way)).then(|| outline.push(at))?;
        at = (at.0 + WAYS[way].0, at.1 + WAYS[way].1);
        let [left, right] = [(way + 1) % 4, (way + 3) % 4];
        let order = if turns_left { [left, way, right] } else { [right, way, left] };
        match order.into_iter().find(|next| edges.contains(&(at, *next))) {
            Some(next) => way = next,
            None => return edges.is_empty().then_some(outline),
        }
    }
}

/// Straight runs everywhere, corridors, and outlines that touch themselves from inside or outside.
#[test]
fn random_outlines_on_a_lattice_are_tiled() {
    let mut random = Random(2);
    let (mut tiled, mut touching) = (0, 0);
    for round in 0..200 {
        let mut squares = BTreeSet::from([(5, 5)]);
        for _ in 0..300 {
            let square = (random.below(11) as i32, random.below(11) as i32);
            let sides = [(1, 0), (-1, 0), (0, 1), (0, -1)].map(|(x, y)| (square.0 + x, square.1 + y));
            // One neighbour only, for thin arms.
            if sides.iter().filter(|side| squares.contains(side)).count() == 1 {
                squares.insert(square);
            }
        }
        let Some(outline) = lattice_outline(&squares, round % 2 == 0) else { continue };
        if outline.len() > MAX_VERTICES {
            continue;
        }
        touching += usize::from(outline.iter().collect::<BTreeSet<_>>().len() < outline.len());
        tiled += 1;
        assert_all_tile(&polygon(outline.iter().map(|(x, y)| [*x as f32 * 0.1, *y as f32 * 0.1, 7.0])));
    }
    assert!(tiled > 50 && touching > 20, "{tiled} outlines, {touching} of them touching themselves");
}

#[test]
fn random_stars_in_random_planes_are_tiled() {
    let mut random = Random(1);
    for _ in 0..300 {
        let n = 3 + random.below(MAX_VERTICES - 2);
        let [slope_x, slope_y] = [random.unit() - 0.5, random.unit() - 0.5];
        let turn = random.below(3);
        let vertices = (0..n).map(|i| {
            let (angle, r) = (i as f32 / n as f32 * std::f32::consts::TAU, 0.1 + random.unit());
            let (x, y) = (r * angle.cos(), r * angle.sin());
            let mut vertex = [x, y, slope_x * x + slope_y * y];
            vertex.rotate_left(turn);
            vertex
        });
        assert_all_tile(&polygon(vertices.collect::<Vec<_>>()));
    }
}

/// The vertices in turn, starting at any of them, and the other way round.
#[test]
fn a_polygon_faces_the_side_from_which_it_is_counter_clockwise() {
    let chevron = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [4.0, 4.0, 1.0], [3.0, 1.0, 1.0]];
    for first in 0..4 {
        let mut vertices = chevron;
        vertices.rotate_left(first);
        assert_all_tile(&polygon(vertices));
        vertices.reverse();
        assert_all_tile(&polygon(vertices));
    }
}

/// The normal and the position of a corner stay together: here they are the same vector.
#[test]
fn patches_keep_their_normals() {
    let vertices = [[3.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 3.0, 1.0], [-3.0, 0.0, 1.0], [0.0, -3.0, 1.0]];
    let lines = vertices.map(|[x, y, z]| format!("{x} {y} {z} {x} {y} {z}\n")).concat();
    let text = format!("{HEAD}pp 5\n{lines}");
    assert_all_tile(&text);
    for object in read_big(&text).1.as_scene().objects {
        let Shape::SmoothTriangle(triangle) = object.shape else { panic!("{object:?}") };
        assert_eq!(triangle.vertices, triangle.normals);
    }
}

/// A square with a hole, joined by a cut: from any vertex on, and mirrored.
#[test]
fn a_hole_joined_by_a_cut_is_tiled() {
    let keyhole = [[-3, -3], [3, -3], [3, 3], [-3, 3], [-3, -3], [-1, -1], [-1, 1], [1, 1], [1, -1], [-1, -1]];
    for first in 0..keyhole.len() {
        let mut vertices = keyhole.map(|[x, y]| [x as f32, y as f32, 2.0]);
        vertices.rotate_left(first);
        assert_all_tile(&polygon(vertices));
        vertices.reverse();
        assert_all_tile(&polygon(vertices.map(|[x, y, z]| [-x, y, z])));
    }
}

/// A triangular hole that touches a corner of the square and is joined by a cut elsewhere: what would be cut off at that
/// corner holds no vertex but reaches into the hole.
#[test]
fn a_hole_that_touches_a_corner_is_tiled() {
    let outline = [[0, 0], [1, 0], [9, 0], [9, 9], [5, 3], [0, 0], [3, 5], [5, 3], [9, 9], [0, 9], [0, 1]];
    for first in 0..outline.len() {
        let mut vertices = outline.map(|[x, y]| [x as f32, y as f32, 2.0]);
        vertices.rotate_left(first);
        assert_all_tile(&polygon(vertices));
    }
}

/// A notch 10⁻¹² of the square's side wide.
#[test]
fn details_far_below_the_size_of_a_polygon_count() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 2e-12], [1e-12, 1e-12]];
    assert_all_tile(&polygon(square.map(|[x, y]| [x, y, 0.0])));
}

/// Spikes outwards and inwards, repeated vertices: the rest is tiled as if they were not there.
#[test]
fn what_has_no_area_is_dropped() {
    let spiky = [[0, 0], [0, 0], [4, 0], [6, 2], [4, 0], [4, 4], [2, 4], [2, 2], [2, 4], [0, 4], [-1, 4], [0, 4]];
    let plain = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 4.0], [0.0, 4.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
    for first in 0..spiky.len() {
        let mut vertices = spiky.map(|[x, y]| [x as f32, y as f32, 0.0]);
        vertices.rotate_left(first);
        let (_, scene) = read_big(&polygon(vertices));
        let triangles: Vec<_> = scene.as_scene().objects.iter().map(triangle).collect();
        assert_tiles(&plain, &triangles);
    }
    for flat in [vec![[1.0, 2.0, 3.0]; 9], vec![[0.0; 3], [1.0, 2.0, 3.0], [3.0, 6.0, 9.0], [2.0, 4.0, 6.0]]] {
        assert_eq!(read_big(&polygon(flat)).0.objects, 0);
    }
}

#[test]
fn a_polygon_that_crosses_itself_is_mostly_drawn() {
    let bow_tie = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 3.0, 0.0], [2.0, 3.0, 0.0]];
    let (summary, _) = read_big(&polygon(bow_tie));
    assert!((1..=2).contains(&summary.objects));
}
