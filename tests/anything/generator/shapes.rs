//! Shapes of every kind.

use whit::scene::{Cone, PackedSpheres, SmoothTriangle, Sphere, SphereList, Triangle};
use whit::{Shape, Vec3};

use super::Source;
use super::span::{LENGTH, POSITIVE};

/// The geometry of an object, with the memory that it borrows from.
#[derive(Clone, Debug)]
pub enum Form {
    Single(Shape<'static, f32>),
    Triangles(Vec<Triangle<f32>>),
    Spheres(Box<Packed>),
}

/// Packed spheres, in several numbers.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant)] // There is always a box around it.
pub enum Packed {
    One(PackedSpheres<f32, 1, 1>),
    Nine(PackedSpheres<f32, 1, 2>),
    Many(PackedSpheres<f32, 2, 9>),
}

impl Packed {
    fn view(&self) -> SphereList<'_, f32> {
        match self {
            Self::One(packed) => packed.view(),
            Self::Nine(packed) => packed.view(),
            Self::Many(packed) => packed.view(),
        }
    }
}

impl Form {
    pub fn shape(&self) -> Shape<'_, f32> {
        match self {
            Self::Single(shape) => *shape,
            Self::Triangles(list) => Shape::Triangles(list),
            Self::Spheres(packed) => Shape::Spheres(packed.view()),
        }
    }

    pub fn random(source: &mut Source<'_>) -> Self {
        Self::Single(match source.below(12) {
            0 | 1 => {
                let Sphere { center, radius } = sphere(source);
                Shape::sphere(center, radius)
            }
            2 => Shape::plane(source.point(), source.direction()),
            3 => Shape::disc(source.point(), source.direction(), source.size(POSITIVE)),
            4 | 5 => axis_box(source),
            6 => Shape::Triangle(triangle(source)),
            7 => Shape::SmoothTriangle(smooth_triangle(source)),
            8 | 9 => cone(source),
            10 => return Self::Triangles((0..source.below(7)).map(|_| triangle(source)).collect()),
            _ => return Self::Spheres(Box::new(packed(source))),
        })
    }
}

impl Source<'_> {
    /// A disc with a hole; sometimes without one, or with nothing around it.
    pub fn annulus(&mut self) -> Form {
        let (a, b) = (self.size(POSITIVE), if self.once_in(4) { 0.0 } else { self.size(POSITIVE) });
        let (inner, outer) = if self.is_wild { (a, b) } else { (a.min(b), a.max(b)) };
        Form::Single(Shape::annulus(self.point(), self.direction(), inner, outer))
    }
}

fn sphere(source: &mut Source<'_>) -> Sphere<f32> {
    let (center, radius) = (source.point(), source.size(POSITIVE));
    Sphere { center, radius: if source.once_in(6) { -radius } else { radius } }
}

/// Sometimes without a thickness.
fn axis_box(source: &mut Source<'_>) -> Shape<'static, f32> {
    let (a, mut b) = (source.point(), source.point());
    match source.below(16) {
        13 => b.x = a.x,
        14 => b.y = a.y,
        15 => b = a,
        _ => {}
    }
    if source.is_wild && source.once_in(2) {
        return Shape::axis_box(a, b);
    }
    let (min, max) = ([a.x.min(b.x), a.y.min(b.y), a.z.min(b.z)], [a.x.max(b.x), a.y.max(b.y), a.z.max(b.z)]);
    Shape::axis_box(min.into(), max.into())
}

/// Sometimes without an area.
fn triangle(source: &mut Source<'_>) -> Triangle<f32> {
    let (a, b) = (source.point(), source.point());
    let c = match source.below(12) {
        9 => a,
        10 => (a + b) * 0.5,
        11 => b + (b - a),
        _ => source.point(),
    };
    Triangle { vertices: [a, b, c.map(|x| source.fit(x, LENGTH))] }
}

fn smooth_triangle(source: &mut Source<'_>) -> SmoothTriangle<f32> {
    let Triangle { vertices } = triangle(source);
    let first = source.direction();
    let normals = match source.below(4) {
        0 | 1 => [first, source.direction(), source.direction()],
        2 => [first; 3],
        _ => [first, -first, source.direction()],
    };
    SmoothTriangle { vertices, normals }
}

fn cone(source: &mut Source<'_>) -> Shape<'static, f32> {
    let base = source.point();
    let apex = source.point();
    let apex = if source.is_wild || (apex - base).length_squared() > 1e-24 { apex } else { away_from(base) };
    let base_radius = source.size(POSITIVE);
    let apex_radius = match source.below(6) {
        0 | 1 => base_radius,
        2 => 0.0,
        3 => -0.0,
        _ => source.size(POSITIVE),
    };
    let (a, b) = if source.once_in(4) { (apex_radius, base_radius) } else { (base_radius, apex_radius) };
    let sign = if source.once_in(5) { -1.0 } else { 1.0 };
    Shape::Cone(Cone { base, apex, base_radius: a * sign, apex_radius: b * sign, capped: source.once_in(2) })
}

/// A point that is surely another one, within the same range.
pub fn away_from(point: Vec3<f32>) -> Vec3<f32> {
    if point.x == 0.0 { Vec3 { x: 1.0, ..point } } else { Vec3 { x: -point.x - point.x.signum(), ..point } }
        .map(|x| LENGTH.fit(x))
}

/// More spheres than the source has are copies of a few, moved aside.
fn packed(source: &mut Source<'_>) -> Packed {
    let first: Vec<_> = (0..3).map(|_| sphere(source)).collect();
    let step = source.axis() * source.scale;
    let is_wild = source.is_wild;
    let copy = move |i: usize| {
        let Some(&Sphere { center, radius }) = first.get(i % first.len().max(1)) else {
            return Sphere { center: Vec3::ZERO, radius: 1.0 };
        };
        let moved = center + step * ((i / 3) as f32);
        Sphere { center: if is_wild { moved } else { moved.map(|x| LENGTH.fit(x)) }, radius }
    };
    match source.below(3) {
        0 => Packed::One(PackedSpheres::new(&core::array::from_fn::<_, 3, _>(copy))),
        1 => Packed::Nine(PackedSpheres::new(&core::array::from_fn::<_, 9, _>(copy))),
        _ => Packed::Many(PackedSpheres::new(&core::array::from_fn::<_, 65, _>(copy))),
    }
}
