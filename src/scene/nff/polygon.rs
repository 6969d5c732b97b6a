//! From polygons to triangles.
//!
//! Ear clipping (Meisters, "Polygons Have Ears", 1975): a corner whose triangle holds no other vertex is cut off, until
//! three are left. Every decision is taken in integers, without rounding, so that a simple polygon of n vertices, with
//! straight runs or without, comes apart into exactly n − 2 triangles of the given vertices. Nothing is cut off at a
//! straight vertex: a neighbour that shares the edge would be left with a crack.

use heapless::Vec;

use super::MAX_VERTICES;
use crate::math::Vec3;

/// A corner of a polygon.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    pub(super) position: Vec3<f32>,
    /// Zero in a polygon without normals.
    pub(super) normal: Vec3<f32>,
}

/// What is left of a polygon while its triangles are taken from it.
pub(super) struct Polygon {
    vertices: Vec<Vertex, MAX_VERTICES>,
    grid: Grid,
    /// Where the search for the next ear begins. It moves past each ear, so that the triangles of a round polygon do
    /// not all meet in one vertex.
    start: usize,
}

impl Polygon {
    pub(super) const EMPTY: Self =
        Self { vertices: Vec::new(), grid: Grid { u: Axis::X, v: Axis::Y, exponent: 0 }, start: 0 };

    /// Forgets what is left of the polygon before.
    pub(super) fn clear(&mut self) {
        self.vertices.clear();
        self.start = 0;
    }

    /// Adds a vertex, of which there are no more than [`MAX_VERTICES`].
    pub(super) fn push(&mut self, vertex: Vertex) {
        let _ = self.vertices.push(vertex);
    }

    /// Ends the list of vertices: the triangles can be taken.
    pub(super) fn close(&mut self) {
        match Grid::across(&self.vertices) {
            Some(grid) => self.grid = grid,
            None => self.vertices.clear(),
        }
    }

    /// Takes the next triangle, counter-clockwise like the polygon.
    pub(super) fn next_triangle(&mut self) -> Option<[Vertex; 3]> {
        while self.vertices.len() >= 3 {
            let index = self.next_cut()?;
            let corner = self.corner(index)?;
            self.remove(index);
            let [a, b, c] = self.grid.points(corner);
            if turn(a, b, c) > 0 {
                return Some(corner);
            }
        }
        None
    }

    /// The vertex that goes next: first where the outline runs back on itself, which would pass for an ear from
    /// outside; then an ear.
    ///
    /// A simple polygon always has an ear. One that touches or crosses itself may have none: it loses a straight
    /// vertex or else any convex one, so that most of it is seen.
    fn next_cut(&self) -> Option<usize> {
        self.find(|index| self.is_spike(index))
            .or_else(|| self.find(|index| self.is_ear(index)))
            .or_else(|| self.find(|index| self.turn_at(index) == Some(0)))
            .or_else(|| self.find(|index| self.turn_at(index) > Some(0)))
    }

    fn find(&self, fits: impl Fn(usize) -> bool) -> Option<usize> {
        let len = self.vertices.len();
        (self.start..len).chain(0..self.start.min(len)).find(|&index| fits(index))
    }

    fn is_spike(&self, index: usize) -> bool {
        let Some(corner) = self.corner(index) else { return false };
        let [a, b, c] = self.grid.points(corner);
        turn(a, b, c) == 0 && b.minus(a).dot(c.minus(b)) <= 0
    }

    fn is_ear(&self, index: usize) -> bool {
        let Some(corner) = self.corner(index) else { return false };
        let [a, b, c] = self.grid.points(corner);
        turn(a, b, c) > 0 && (0..self.vertices.len()).all(|other| !self.is_in_the_way(other, [a, b, c]))
    }

    fn turn_at(&self, index: usize) -> Option<i128> {
        let [a, b, c] = self.grid.points(self.corner(index)?);
        Some(turn(a, b, c))
    }

    /// Whether vertex `index` lies in the triangle or on its outline.
    ///
    /// One that coincides with a corner of the triangle, as where a cut joins a hole to the outline, is in the way only
    /// if an edge leaves it for the inside: at `a` and `c` the far end of such an edge is in the way itself, at `b` the
    /// edge may cross to the far side.
    fn is_in_the_way(&self, index: usize, [a, b, c]: [Point; 3]) -> bool {
        let Some(vertex) = self.vertices.get(index) else { return false };
        let p = self.grid.point(vertex.position);
        if p == b {
            let Some(corner) = self.corner(index) else { return false };
            let [before, _, after] = self.grid.points(corner);
            return [before, after].into_iter().any(|q| turn(a, b, q) > 0 && turn(b, c, q) > 0);
        }
        p != a && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0
    }

    /// The vertex with its neighbours.
    fn corner(&self, index: usize) -> Option<[Vertex; 3]> {
        let vertices = &self.vertices;
        let before = match index.checked_sub(1) {
            Some(before) => vertices.get(before),
            None => vertices.last(),
        };
        let after = vertices.get(index + 1).or_else(|| vertices.first());
        Some([*before?, *vertices.get(index)?, *after?])
    }

    fn remove(&mut self, index: usize) {
        if let Some(rest @ [_, ..]) = self.vertices.get_mut(index..) {
            rest.rotate_left(1);
            self.vertices.pop();
        }
        self.start = if index + 1 < self.vertices.len() { index + 1 } else { 0 };
    }
}

/// A coordinate.
#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    fn of(self, v: Vec3<f32>) -> f32 {
        match self {
            Self::X => v.x,
            Self::Y => v.y,
            Self::Z => v.z,
        }
    }
}

/// A projection along an axis to a grid of integers.
///
/// The largest coordinate of the polygon takes 56 bits, so the 24 bits of a coordinate up to 2³² times smaller than
/// that fit without loss; of smaller ones, what is below 2⁻⁵⁶ of the largest is cut off. Products of differences stay
/// below 2¹¹⁴, sums of [`MAX_VERTICES`] of their differences within an `i128`.
#[derive(Clone, Copy)]
struct Grid {
    u: Axis,
    v: Axis,
    /// Biased exponent of the largest coordinate.
    exponent: u32,
}

impl Grid {
    /// Along the axis that sees most of the polygon, from the side where it is counter-clockwise; `None` if it has no
    /// area. Its area along each axis is a component of Newell's normal.
    fn across(vertices: &[Vertex]) -> Option<Self> {
        let coordinates = vertices.iter().flat_map(|v| [v.position.x, v.position.y, v.position.z]);
        let exponent = coordinates.map(exponent_of).max()?;
        let (grid, area) = [(Axis::Y, Axis::Z), (Axis::Z, Axis::X), (Axis::X, Axis::Y)]
            .map(|(u, v)| Self { u, v, exponent })
            .map(|grid| (grid, grid.area(vertices)))
            .into_iter()
            .max_by_key(|(_, area)| area.unsigned_abs())?;
        match area {
            0 => None,
            1.. => Some(grid),
            _ => Some(Self { u: grid.v, v: grid.u, exponent }),
        }
    }

    /// Twice the signed area of a polygon.
    fn area(&self, vertices: &[Vertex]) -> i128 {
        let points = || vertices.iter().map(|vertex| self.point(vertex.position));
        let Some(origin) = points().next() else { return 0 };
        points().zip(points().skip(1)).map(|(p, q)| turn(origin, p, q)).sum()
    }

    fn point(&self, position: Vec3<f32>) -> Point {
        let [u, v] = [self.u, self.v].map(|axis| on_grid(axis.of(position), self.exponent));
        Point { u, v }
    }

    fn points(&self, corner: [Vertex; 3]) -> [Point; 3] {
        corner.map(|vertex| self.point(vertex.position))
    }
}

/// The biased exponent, the same for all numbers next to zero.
fn exponent_of(x: f32) -> u32 {
    ((x.to_bits() >> 23) & 0xff).max(1)
}

/// `x` in units of 2⁻⁵⁶ of the power of two above a number with the biased exponent `largest`.
fn on_grid(x: f32, largest: u32) -> i64 {
    let (bits, exponent) = (x.to_bits(), exponent_of(x));
    let implicit = if (bits >> 23) & 0xff == 0 { 0 } else { 1 << 23 };
    let significand = u64::from(bits & 0x007f_ffff | implicit) << 32;
    let magnitude = significand.checked_shr(largest.saturating_sub(exponent)).unwrap_or(0) as i64;
    if x < 0.0 { -magnitude } else { magnitude }
}

/// A vertex seen along an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Point {
    u: i64,
    v: i64,
}

impl Point {
    fn minus(self, other: Self) -> Self {
        Self { u: self.u - other.u, v: self.v - other.v }
    }

    fn dot(self, other: Self) -> i128 {
        i128::from(self.u) * i128::from(other.u) + i128::from(self.v) * i128::from(other.v)
    }

    fn cross(self, other: Self) -> i128 {
        i128::from(self.u) * i128::from(other.v) - i128::from(self.v) * i128::from(other.u)
    }
}

/// Twice the signed area of a triangle: above 0 where the way from `a` by `b` to `c` turns left.
fn turn(a: Point, b: Point, c: Point) -> i128 {
    b.minus(a).cross(c.minus(a))
}
