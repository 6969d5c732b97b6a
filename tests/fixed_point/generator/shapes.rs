//! Shapes: huge, tiny, thin and flat ones.

use whit::scene::{Cone, Sides, SmoothTriangle};
use whit::{Object, Shape, Vec3};

use super::Source;

impl Source {
    pub fn object(&mut self) -> Object<'static, f32> {
        let object = Object::new(self.shape(), self.material());
        let is_transparent = object.material.interface.medium().is_some();
        let object = if self.once_in(5) { Object { sides: Sides::Outside, ..object } } else { object };
        match self.below(6) {
            0 => object.without_shadow(),
            1..=3 if is_transparent => object.with_tinted_shadow(),
            _ => object,
        }
    }

    fn shape(&mut self) -> Shape<'static, f32> {
        match self.below(11) {
            0..=2 => {
                let radius = self.length();
                Shape::sphere(self.point(), if self.once_in(6) { -radius } else { radius })
            }
            3 => Shape::plane(self.point(), self.direction()),
            4 => Shape::disc(self.point(), self.direction(), self.length()),
            5 => {
                let (a, b) = (self.length(), self.length());
                Shape::annulus(self.point(), self.direction(), a.min(b), a.max(b))
            }
            6 => {
                let (a, b) = (self.point(), self.point());
                let ordered = |f: fn(f32, f32) -> f32| Vec3::new(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));
                Shape::axis_box(ordered(f32::min), ordered(f32::max))
            }
            7 => {
                let [a, b, c] = self.corners();
                Shape::triangle(a, b, c)
            }
            8 => {
                let normals = [self.course(), self.course(), self.course()];
                Shape::SmoothTriangle(SmoothTriangle { vertices: self.corners(), normals })
            }
            _ => self.cone(),
        }
    }

    /// Sometimes in line.
    fn corners(&mut self) -> [Vec3<f32>; 3] {
        let (a, b, c) = (self.point(), self.point(), self.point());
        [a, b, if self.once_in(8) { (a + b) * 0.5 } else { c }]
    }

    fn cone(&mut self) -> Shape<'static, f32> {
        let base = self.point();
        let apex = self.point();
        let apex = if apex == base { base.map(|x| if x > 0.0 { x - 1.0 } else { x + 1.0 }) } else { apex };
        let height = (apex - base).length();
        let base_radius = self.length();
        let apex_radius = match self.below(4) {
            0 => base_radius,
            1 => (base_radius - 4.0 * height).max(0.0),
            2 => (base_radius + 4.0 * height).min(self.limit),
            _ => base_radius + (self.length() - base_radius).clamp(-4.0 * height, 4.0 * height),
        };
        let sign = if self.once_in(6) { -1.0 } else { 1.0 };
        let capped = self.once_in(2);
        Shape::Cone(Cone { base, apex, base_radius: base_radius * sign, apex_radius: apex_radius * sign, capped })
    }
}
