//! Ray against triangle, watertight: a ray through a shared edge or corner meets at least one of its triangles.
//!
//! Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013). The vertices are sheared into a space
//! where the ray is an axis; two triangles see the same numbers with opposite signs at a shared edge, so none of them
//! can round the ray away on both sides. A value of exactly zero counts as a hit on either side.

use super::{Contact, Located, Ray, fixed_point};
use crate::math::{Real, Vec3};
use crate::scene::Triangle;

/// The shear that makes a ray an axis; worked out once a ray.
#[derive(Clone, Copy)]
pub(crate) struct Shear<T> {
    axis: u8,
    x: T,
    y: T,
    z: T,
}

impl<T: Real> Shear<T> {
    #[inline]
    pub(crate) fn new(direction: Vec3<T>) -> Self {
        let size = direction.abs();
        let axis = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let d = permute(direction, axis);
        let z = T::ONE / d.z;
        Self { axis, x: d.x * z, y: d.y * z, z }
    }
}

/// Turns the coordinates so that `axis` comes last; a rotation, so orientation stays.
#[inline]
fn permute<T>(v: Vec3<T>, axis: u8) -> Vec3<T> {
    match axis {
        0 => Vec3 { x: v.y, y: v.z, z: v.x },
        1 => Vec3 { x: v.z, y: v.x, z: v.y },
        _ => v,
    }
}

/// Where the ray crosses the plane of the triangle: weights of the three corners, not yet divided by their sum, and t.
struct Crossing<T> {
    weights: [T; 3],
    sum: T,
    t: T,
    /// [`SETTLED`], or 0.
    part: u32,
}

/// The part of a contact whose distance is worked out in twice the digits, while its weights are not.
const SETTLED: u32 = 1;

#[inline(always)]
fn cross<T: Real>(vertices: &[Vec3<T>; 3], ray: &Ray<T>, shear: &Shear<T>) -> Option<Crossing<T>> {
    let [a, b, c] = vertices.map(|v| {
        let v = permute(v - ray.origin, shear.axis);
        Vec3 { x: v.x - shear.x * v.z, y: v.y - shear.y * v.z, z: shear.z * v.z }
    });
    if T::IS_FIXED {
        let fixed_point::Crossing { shares, t, is_clockwise } = fixed_point::triangle([a, b, c])?;
        let sum = if is_clockwise { T::ONE } else { -T::ONE };
        return (t > T::ZERO).then_some(Crossing { weights: shares, sum, t, part: 0 });
    }
    let u = c.x * b.y - c.y * b.x;
    let v = a.x * c.y - a.y * c.x;
    let w = b.x * a.y - b.y * a.x;
    if (u < T::ZERO || v < T::ZERO || w < T::ZERO) && (u > T::ZERO || v > T::ZERO || w > T::ZERO) {
        return None;
    }
    let sum = u + v + w;
    if sum == T::ZERO {
        return None;
    }
    let t = (u * a.z + v * b.z + w * c.z) / sum;
    let mut crossing = Crossing { weights: [u, v, w], sum, t, part: 0 };
    // Where all corners lie in front of the origin, so does the crossing.
    let is_ahead = a.z > T::ZERO && b.z > T::ZERO && c.z > T::ZERO;
    if !is_ahead {
        crossing.settle([a, b, c], vertices, ray);
    }
    (crossing.t > T::ZERO).then_some(crossing)
}

impl<T: Real> Crossing<T> {
    /// Works t out in twice the digits, from the plane of the triangle, where rounding takes more than a thousandth of it.
    /// Its sign is right then, so that a ray that leaves a triangle does not meet it again.
    #[cold]
    #[inline(never)]
    fn settle(&mut self, sheared: [Vec3<T>; 3], vertices: &[Vec3<T>; 3], ray: &Ray<T>) {
        if leaves(vertices, ray) {
            self.t = T::ZERO;
            return;
        }
        if self.t.abs() > uncertainty(sheared, self.weights, self.sum) * T::from_f32(1024.0) {
            return;
        }
        self.part = SETTLED;
        let [a, b, c] = vertices;
        let normal = b.exact_difference(*a).twofold_cross(c.exact_difference(*a));
        let approach = ray.direction.exact_difference(Vec3::ZERO).twofold_dot(normal).rounded();
        self.t = if approach == T::ZERO {
            edge_crossing(sheared)
        } else {
            a.exact_difference(ray.origin).twofold_dot(normal).rounded() / approach
        };
    }
}

/// Whether a ray surely goes away from the plane of a triangle, on which it may start, as most do that leave the triangle.
///
/// The normal n is good to 4u·N, where N is the sum of its products' sizes; so n·v is good to 10u·N·|v| for a difference v
/// of two points, of which 12 are taken. What underflow takes is less than 2⁻¹⁴⁸, times the three coordinates of v, in `f32`.
fn leaves<T: Real>([a, b, c]: &[Vec3<T>; 3], ray: &Ray<T>) -> bool {
    let (p, q, start) = (*b - *a, *c - *a, ray.origin - *a);
    let (plus, minus) = (Vec3::new(p.y * q.z, p.z * q.x, p.x * q.y), Vec3::new(p.z * q.y, p.x * q.z, p.y * q.x));
    let normal = plus - minus;
    let doubt = (plus.abs() + minus.abs()).map(|size| size.roundings(12.0));
    let underflow = T::SMALLEST * T::from_f32(67_108_864.0);
    let side = |v: Vec3<T>| {
        let (along, least) = (v.dot(normal), v.abs().dot(doubt) + underflow);
        if along.abs() > least { Some(along > T::ZERO) } else { None }
    };
    // A plane along two axes, as of a floor, has no roundings.
    let is_zero = |p: T, q: T, start: T| p == T::ZERO && q == T::ZERO && start == T::ZERO;
    let is_on_plane = is_zero(p.x, q.x, start.x) || is_zero(p.y, q.y, start.y) || is_zero(p.z, q.z, start.z);
    let going = side(ray.direction);
    going.is_some() && (is_on_plane || side(start) == going)
}

/// Where a ray comes nearest to the longest edge of a sheared triangle that has no area but closes a seam.
fn edge_crossing<T: Real>([a, b, c]: [Vec3<T>; 3]) -> T {
    let square = |from: Vec3<T>, to: Vec3<T>| (to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y);
    let [ab, bc, ca] = [square(a, b), square(b, c), square(c, a)];
    let (from, to, square) = if ab >= bc && ab >= ca {
        (a, b, ab)
    } else if bc >= ca {
        (b, c, bc)
    } else {
        (c, a, ca)
    };
    from.z - (from.x * (to.x - from.x) + from.y * (to.y - from.y)) / square * (to.z - from.z)
}

/// A bound on the error of t, which is that of the farthest corner (Pharr, Jakob and Humphreys,
/// "Physically Based Rendering", 4th edition, 6.8.7). The corners are sheared.
fn uncertainty<T: Real>([a, b, c]: [Vec3<T>; 3], [u, v, w]: [T; 3], sum: T) -> T {
    let rounding = |operations: f32| T::ONE.roundings(operations);
    let largest = |a: T, b: T, c: T| a.abs().max(b.abs()).max(c.abs());
    let (x, y, z) = (largest(a.x, b.x, c.x), largest(a.y, b.y, c.y), largest(a.z, b.z, c.z));
    let (error_x, error_y, error_z) = (rounding(5.0) * (x + z), rounding(5.0) * (y + z), rounding(3.0) * z);
    let error_weight = T::TWO * (rounding(2.0) * x * y + error_y * x + error_x * y);
    let weight = largest(u, v, w);
    T::from_f32(3.0) * (rounding(3.0) * weight * z + error_weight * z + error_z * weight) / sum.abs()
}

/// The contact nearer than `limit`, if it may be seen, and the weights of the corners there, not yet divided by their sum.
#[inline(always)]
pub(crate) fn intersect<T: Real>(
    vertices: &[Vec3<T>; 3],
    ray: &Ray<T>,
    shear: &Shear<T>,
    limit: T,
    outside_only: bool,
) -> Option<(Contact<T>, [T; 3])> {
    let Crossing { weights, sum, t, part } = cross(vertices, ray, shear)?;
    // The sheared triangle turns clockwise, seen along the ray, when the sum is positive.
    let front = (sum > T::ZERO) == (shear.z > T::ZERO);
    (t < limit && (front || !outside_only)).then_some((Contact::new(t, front, part), weights))
}

/// The nearest contact with a list of triangles, the number of the triangle and the weights there; with `any`, the first
/// found.
pub(crate) fn intersect_list<T: Real>(
    list: &[Triangle<T>],
    ray: &Ray<T>,
    shear: &Shear<T>,
    limit: T,
    outside_only: bool,
    any: bool,
) -> Option<(Contact<T>, usize, [T; 3])> {
    let mut best = None;
    let mut limit = limit;
    for (i, triangle) in list.iter().enumerate() {
        if let Some((contact, weights)) = intersect(&triangle.vertices, ray, shear, limit, outside_only) {
            limit = contact.t;
            best = Some((contact, i, weights));
            if any {
                break;
            }
        }
    }
    best
}

/// The point of a contact with these weights, and the shares of the corners.
///
/// The point comes from the shares, which keeps it in the triangle's plane whatever the distance; with 7 roundings of each
/// product (Pharr, Jakob and Humphreys, 6.8.5).
#[inline]
pub(crate) fn locate<T: Real>(
    vertices: &[Vec3<T>; 3],
    ray: &Ray<T>,
    contact: &Contact<T>,
    weights: [T; 3],
) -> (Located<T>, [T; 3]) {
    if T::IS_FIXED {
        return (fixed_point::locate_on_triangle(vertices, weights, ray), weights);
    }
    let exact = if contact.part() == SETTLED { exact_shares(vertices, ray) } else { None };
    let shares = exact.unwrap_or_else(|| shares(weights));
    let error = weigh(&vertices.map(Vec3::abs), shares).map(|size| size.roundings(8.0));
    let normal = exact_normal(vertices).normalized_or(-ray.direction);
    (Located { point: weigh(vertices, shares), normal, error }, shares)
}

/// The normal to shade a smooth triangle with: the mean of the corners' unit normals by the corners' shares, or the
/// geometric one where they cancel.
#[inline]
pub(crate) fn shading<T: Real>(normals: &[Vec3<T>; 3], shares: [T; 3], geometric: Vec3<T>) -> Vec3<T> {
    weigh(&normals.map(Vec3::normalized), shares).normalized_or(geometric)
}

/// The weights divided by their sum.
#[inline]
fn shares<T: Real>([u, v, w]: [T; 3]) -> [T; 3] {
    let sum = u + v + w;
    [u / sum, v / sum, w / sum]
}

/// The shares of the corners, worked out in twice the digits: for slivers, and for triangles whose corners are far away.
/// `None` where they have no sum.
#[cold]
#[inline(never)]
fn exact_shares<T: Real>(vertices: &[Vec3<T>; 3], ray: &Ray<T>) -> Option<[T; 3]> {
    let [a, b, c] = vertices.map(|v| v.exact_difference(ray.origin));
    let direction = ray.direction.exact_difference(Vec3::ZERO);
    let weights = [(c, b), (a, c), (b, a)].map(|(p, q)| direction.twofold_dot(p.twofold_cross(q)).rounded());
    let [u, v, w] = weights;
    // What rounding has taken out of the triangle is at its edge.
    let sign = if u + v + w < T::ZERO { -T::ONE } else { T::ONE };
    let [u, v, w] = weights.map(|weight| (weight * sign).max(T::ZERO));
    if u + v + w >= T::SMALLEST { Some(shares([u, v, w])) } else { None }
}

/// The direction across a triangle, good to a rounding even for a sliver, and so long that its square neither underflows
/// nor overflows; the zero vector where the corners are in line or too near each other for the number type.
fn exact_normal<T: Real>([a, b, c]: &[Vec3<T>; 3]) -> Vec3<T> {
    let normal = b.exact_difference(*a).twofold_cross(c.exact_difference(*a)).rounded();
    let largest = normal.largest();
    if largest >= T::SMALLEST { normal * (T::ONE / largest) } else { Vec3::ZERO }
}

#[inline]
fn weigh<T: Real>([a, b, c]: &[Vec3<T>; 3], [u, v, w]: [T; 3]) -> Vec3<T> {
    *a * u + *b * v + *c * w
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intersect::numbers::Numbers;

    /// Rays from a triangle's plane and from next to it, over 12 decades, compared with the same in twice the digits of
    /// `f64`. A third of the triangles lie along two axes.
    #[test]
    fn what_leaves_a_triangle_does_not_meet_it() {
        let mut left = 0;
        for round in 0..60_000_u32 {
            let numbers = Numbers(round);
            let (number, vector) = (|i| numbers.number(i), |i| numbers.vector(i));
            let (scale, away) = (10_f32.powi((number(900) * 6.0) as i32), vector(800) * (10.0 * (number(901) + 1.0)));
            let mut vertices = [0, 10, 20].map(|i| (vector(i) + away) * scale);
            if round % 3 == 0 {
                vertices.iter_mut().for_each(|v| v.z = away.z);
            }
            let height = vertices[0].largest() * 10_f32.powi(-4 - (number(902) * 4.0) as i32);
            let normal = exact_normal(&vertices).normalized();
            let inside = weigh(&vertices, shares([0, 1, 2].map(|i| number(30 + i).abs())));
            let origin = if round % 2 == 0 { inside } else { inside + normal * (height * number(903)) };
            let ray = Ray { origin, direction: vector(40).normalized() };
            if leaves(&vertices, &ray) {
                let exact = |v: Vec3<f32>| v.map(f64::from).exact_difference(Vec3::ZERO);
                let [a, b, c] = vertices.map(|v| v.map(f64::from));
                let across = b.exact_difference(a).twofold_cross(c.exact_difference(a));
                let height = a.exact_difference(origin.map(f64::from)).twofold_dot(across).rounded();
                let approach = exact(ray.direction).twofold_dot(across).rounded();
                assert!(height * approach <= 0.0, "{vertices:?} {ray:?}");
                left += 1;
            }
        }
        assert!(left > 20_000, "{left}");
    }
}
