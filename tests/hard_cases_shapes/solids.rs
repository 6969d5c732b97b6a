//! On which side of a shape a place is, by `f64`.

use whit::scene::{AxisBox, Cone, Triangle};
use whit::{Ray, Shape, Vec3};

use crate::exact::{Vector, cross, dot, exact, length, minus, plus, times, unit};

/// How far a place is under the surface of a solid, or of a flat shape on the side that its normal does not point to;
/// negative above it. A shape that is turned inside out is taken as it would be otherwise.
pub fn depth(shape: &Shape<'_, f32>, place: Vector) -> f64 {
    let below = |point: Vec3<f32>, normal: Vector| dot(minus(exact(point), place), unit(normal));
    let below_triangle = |t: &[Vec3<f32>; 3]| below(t[0], normal(t));
    match shape {
        Shape::Sphere(s) => f64::from(s.radius.abs()) - length(minus(place, exact(s.center))),
        Shape::Plane(p) => below(p.point, exact(p.normal)),
        Shape::Disc(d) => below(d.center, exact(d.normal)),
        Shape::Annulus(a) => below(a.center, exact(a.normal)),
        Shape::Box(AxisBox { min, max }) => {
            let (low, high) = (minus(place, exact(*min)), minus(exact(*max), place));
            low.into_iter().chain(high).fold(f64::INFINITY, f64::min)
        }
        Shape::Triangle(t) => below_triangle(&t.vertices),
        Shape::SmoothTriangle(t) => below_triangle(&t.vertices),
        Shape::Triangles(list) => {
            let depths = list.iter().map(|Triangle { vertices }| below_triangle(vertices));
            depths.fold(f64::INFINITY, f64::min)
        }
        Shape::Cone(cone) => depth_in_cone(cone, place),
        Shape::Spheres(list) => list.iter().map(|s| depth(&Shape::Sphere(s), place)).fold(f64::NEG_INFINITY, f64::max),
    }
}

/// The normal of a triangle, of any length.
pub fn normal(vertices: &[Vec3<f32>; 3]) -> Vector {
    let [a, b, c] = vertices.map(exact);
    cross(minus(b, a), minus(c, a))
}

/// Under the side and between the ends.
fn depth_in_cone(cone: &Cone<f32>, place: Vector) -> f64 {
    let axis = minus(exact(cone.apex), exact(cone.base));
    let (height, from_base) = (length(axis), minus(place, exact(cone.base)));
    let up = unit(axis);
    let along = dot(from_base, up);
    let across = length(minus(from_base, times(up, along)));
    let (base, apex) = (f64::from(cone.base_radius.abs()), f64::from(cone.apex_radius.abs()));
    let slope = (apex - base) / height;
    let under_side = (base + slope * along - across) / (1.0 + slope * slope).sqrt();
    under_side.min(along).min(height - along)
}

/// About how large a shape is.
pub fn size(shape: &Shape<'_, f32>) -> f64 {
    match shape {
        Shape::Sphere(s) => f64::from(s.radius.abs()),
        Shape::Box(AxisBox { min, max }) => length(minus(exact(*max), exact(*min))),
        Shape::Triangle(t) => extent(&t.vertices),
        Shape::SmoothTriangle(t) => extent(&t.vertices),
        Shape::Triangles(list) => extent(list.iter().map(|t| t.vertices).collect::<Vec<_>>().as_flattened()),
        Shape::Cone(cone) => {
            let radius = f64::from(cone.base_radius.abs().max(cone.apex_radius.abs()));
            length(minus(exact(cone.apex), exact(cone.base))) + radius
        }
        _ => 0.0,
    }
}

fn extent(corners: &[Vec3<f32>]) -> f64 {
    corners.iter().map(|corner| length(minus(exact(*corner), exact(corners[0])))).fold(0.0, f64::max)
}

/// Whether a ray goes through the plane of an end of a cone so near to its rim.
pub fn is_near_rim(shape: &Shape<'_, f32>, ray: &Ray<f32>, near: f64) -> bool {
    let Shape::Cone(cone) = shape else { return false };
    let up = unit(minus(exact(cone.apex), exact(cone.base)));
    [(cone.base, cone.base_radius), (cone.apex, cone.apex_radius)].into_iter().any(|(center, radius)| {
        let (from, direction) = (minus(exact(ray.origin), exact(center)), exact(ray.direction));
        let place = plus(from, times(direction, -dot(from, up) / dot(direction, up)));
        (length(place) - f64::from(radius.abs())).abs() < near
    })
}
