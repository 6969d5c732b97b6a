//! What a scene is made of, geometrically.

use super::SphereList;
use crate::math::{Real, Vec3};

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<T> {
    /// Centre.
    pub center: Vec3<T>,
    /// Radius; a negative one turns the outside inwards.
    pub radius: T,
}

/// The plane through a point; its outside is where the normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<T> {
    /// Any point of the plane.
    pub point: Vec3<T>,
    /// The direction across the plane, of any length but zero.
    pub normal: Vec3<T>,
}

/// A flat disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc<T> {
    /// Centre.
    pub center: Vec3<T>,
    /// The direction across the disc, of any length but zero.
    pub normal: Vec3<T>,
    /// Radius.
    pub radius: T,
}

/// A flat disc with a round hole in its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Annulus<T> {
    /// Centre.
    pub center: Vec3<T>,
    /// The direction across it, of any length but zero.
    pub normal: Vec3<T>,
    /// Radius of the hole.
    pub inner: T,
    /// Radius of the rim.
    pub outer: T,
}

/// A box whose edges lie along the axes. A ray in the plane of a face meets it, and a box without thickness is a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisBox<T> {
    /// The corner with the smallest coordinates.
    pub min: Vec3<T>,
    /// The corner with the largest coordinates.
    pub max: Vec3<T>,
}

/// A flat triangle, seen counter-clockwise from its outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<T> {
    /// Corners.
    pub vertices: [Vec3<T>; 3],
}

/// A flat triangle that is shaded as if it were curved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothTriangle<T> {
    /// Corners, counter-clockwise seen from outside.
    pub vertices: [Vec3<T>; 3],
    /// The normal at each corner, of any length but zero, on the outside.
    pub normals: [Vec3<T>; 3],
}

/// A cylinder, a cone or a part of one, between two circles on one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone<T> {
    /// Centre of the first circle.
    pub base: Vec3<T>,
    /// Centre of the second circle.
    pub apex: Vec3<T>,
    /// Radius of the first circle.
    pub base_radius: T,
    /// Radius of the second circle: 0 for a pointed cone, `base_radius` for a cylinder. Both radii negative: the
    /// outside is turned inwards.
    pub apex_radius: T,
    /// Whether discs close the ends.
    pub capped: bool,
}

/// The geometry of an object.
///
/// `Spheres` and `Triangles` are many primitives of one material in one compact slice: the way to keep a big constant
/// scene small in flash and, for spheres, quick to search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<'a, T> {
    /// One sphere.
    Sphere(Sphere<T>),
    /// Many spheres, eight by eight.
    Spheres(SphereList<'a, T>),
    /// An infinite plane.
    Plane(Plane<T>),
    /// A disc.
    Disc(Disc<T>),
    /// A disc with a hole.
    Annulus(Annulus<T>),
    /// An axis-aligned box.
    Box(AxisBox<T>),
    /// One triangle.
    Triangle(Triangle<T>),
    /// Many triangles.
    Triangles(&'a [Triangle<T>]),
    /// One triangle with a normal at each corner.
    SmoothTriangle(SmoothTriangle<T>),
    /// A cylinder or a cone.
    Cone(Cone<T>),
}

impl<T: Copy> Shape<'_, T> {
    /// A sphere.
    pub const fn sphere(center: Vec3<T>, radius: T) -> Self {
        Self::Sphere(Sphere { center, radius })
    }

    /// The plane through `point` across `normal`.
    pub const fn plane(point: Vec3<T>, normal: Vec3<T>) -> Self {
        Self::Plane(Plane { point, normal })
    }

    /// A disc across `normal`.
    pub const fn disc(center: Vec3<T>, normal: Vec3<T>, radius: T) -> Self {
        Self::Disc(Disc { center, normal, radius })
    }

    /// A disc across `normal` between two circles.
    pub const fn annulus(center: Vec3<T>, normal: Vec3<T>, inner: T, outer: T) -> Self {
        Self::Annulus(Annulus { center, normal, inner, outer })
    }

    /// An axis-aligned box between two opposite corners.
    pub const fn axis_box(min: Vec3<T>, max: Vec3<T>) -> Self {
        Self::Box(AxisBox { min, max })
    }

    /// A triangle, counter-clockwise seen from outside.
    pub const fn triangle(a: Vec3<T>, b: Vec3<T>, c: Vec3<T>) -> Self {
        Self::Triangle(Triangle { vertices: [a, b, c] })
    }

    /// A cylinder, open at both ends.
    pub const fn cylinder(base: Vec3<T>, apex: Vec3<T>, radius: T) -> Self {
        Self::Cone(Cone { base, apex, base_radius: radius, apex_radius: radius, capped: false })
    }

    /// A cone between circles of two radii, open at both ends.
    pub const fn cone(base: Vec3<T>, base_radius: T, apex: Vec3<T>, apex_radius: T) -> Self {
        Self::Cone(Cone { base, apex, base_radius, apex_radius, capped: false })
    }

    /// The same shape with its ends closed, if it is a cylinder or a cone.
    #[must_use]
    pub const fn capped(self) -> Self {
        match self {
            Self::Cone(cone) => Self::Cone(Cone { capped: true, ..cone }),
            other => other,
        }
    }
}

impl<T: Real> Shape<'_, T> {
    /// Whether it is one triangle.
    pub(crate) fn is_triangle(&self) -> bool {
        matches!(self, Self::Triangle(_) | Self::SmoothTriangle(_))
    }

    /// Part `index` as a shape of its own, in another number type: the only part of most shapes, or one primitive of
    /// a slice. `None` past the end.
    pub(crate) fn part<U: Real>(&self, index: usize, convert: impl Fn(T) -> U) -> Option<Shape<'static, U>> {
        let point = |v: Vec3<T>| v.map(&convert);
        let sphere = |s: &Sphere<T>| Shape::sphere(point(s.center), convert(s.radius));
        let triangle = |t: &Triangle<T>| Shape::Triangle(Triangle { vertices: t.vertices.map(point) });
        match self {
            Self::Spheres(list) => {
                return list.sphere(index).map(|s| sphere(&s));
            }
            Self::Triangles(list) => return list.get(index).map(triangle),
            _ if index > 0 => return None,
            _ => {}
        }
        Some(match self {
            Self::Spheres(_) | Self::Triangles(_) => return None,
            Self::Sphere(s) => sphere(s),
            Self::Triangle(t) => triangle(t),
            Self::Plane(p) => Shape::plane(point(p.point), point(p.normal)),
            Self::Disc(d) => Shape::disc(point(d.center), point(d.normal), convert(d.radius)),
            Self::Annulus(a) => Shape::annulus(point(a.center), point(a.normal), convert(a.inner), convert(a.outer)),
            Self::Box(b) => Shape::axis_box(point(b.min), point(b.max)),
            Self::SmoothTriangle(t) => {
                Shape::SmoothTriangle(SmoothTriangle { vertices: t.vertices.map(point), normals: t.normals.map(point) })
            }
            Self::Cone(c) => Shape::Cone(Cone {
                base: point(c.base),
                apex: point(c.apex),
                base_radius: convert(c.base_radius),
                apex_radius: convert(c.apex_radius),
                capped: c.capped,
            }),
        })
    }
}
