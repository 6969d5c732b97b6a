//! A prism that takes white light apart.

use super::UP;
use crate::math::{Rgb, Vec3};
use crate::optics::materials::dispersive::{CROWN_GLASS, FLINT_GLASS};
use crate::scene::{Background, Camera, Material, Medium, Object, Pattern, Scene, Shape, Triangle};

/// A tube of white light far behind a direct-vision prism, and its spectrum in the glass.
///
/// The block is Amici's prism: crown glass with a wedge of flint glass in the middle, two media that overlap, of which
/// the flint has the higher priority. Green light leaves it in the direction that it came from, red and blue light
/// 0.9° to the left and 2.2° to the right of that. So the tube, which is white above the block, stands in it once in
/// each channel, side by side. The images fade to both sides and overlap: yellow and cyan are between them.
pub const PRISM: Scene<'static, f32> = Scene::new(CAMERA, ROOM).with_objects(&OBJECTS);

const CAMERA: Camera<f32> = Camera::look_at(Vec3::new(1.3, 3.3, 6.5), Vec3::new(1.42, 2.3, 0.0), UP, 21.0);
const ROOM: Background<f32> = Background::Gradient { below: Rgb::BLACK, above: Rgb::new(0.012, 0.016, 0.024), up: UP };

const OBJECTS: [Object<'static, f32>; 6] = [
    Object::new(Shape::Triangles(&CROWN), glass(CROWN_GLASS.channels(), 1)),
    Object::new(Shape::Triangles(&FLINT), glass(FLINT_GLASS.channels(), 2)),
    half_tube(-1.0),
    half_tube(1.0),
    Object::new(Shape::axis_box(Vec3::new(-1.0, 0.9, -2.2), Vec3::new(4.0, 1.0, 3.0)), TABLE),
    // Mirrored in the front of the block.
    Object::new(Shape::axis_box(Vec3::new(-9.0, -4.0, 1.0), Vec3::new(-8.9, 6.0, 16.0)), glow(PALE)),
];

/// Apex angles of 100° in flint and of 80.6° in crown glass send green light straight on.
const CROWN: [Triangle<f32>; 12] = upright([1.0, 2.0], [1.192, 1.783], [1.02, 3.0]);
/// A little beyond the crown glass in front, where it ends, and a little inside of it at the other sides.
const FLINT: [Triangle<f32>; 12] = upright([0.99, 1.995], [1.204, 0.006], [1.03, 2.99]);

const fn glass(index: Rgb<f32>, priority: u8) -> Material<f32> {
    Material::transparent(Medium::dispersive(index).with_priority(priority))
}

const fn glow(light: Pattern<f32>) -> Material<f32> {
    Material::patterned(light).with_shares(1.0, 0.0, 0.0)
}

const PALE: Pattern<f32> = Pattern::Solid(Rgb::new(0.35, 0.4, 0.5));
const TABLE: Material<f32> = glow(Pattern::Gradient {
    from: Rgb::new(0.06, 0.036, 0.02),
    to: Rgb::new(0.015, 0.009, 0.006),
    origin: Vec3::new(0.0, 0.0, 1.5),
    axis: Vec3::new(0.2, 0.0, -0.2),
})
.with_coat(1.5);

/// One half of the tube: brightest in the middle, and dark at one unit to the left (−1) or to the right (1).
const fn half_tube(side: f32) -> Object<'static, f32> {
    const MIDDLE: Vec3<f32> = Vec3::new(1.1, 0.0, -30.0);
    let light = Pattern::Gradient { from: Rgb::WHITE, to: Rgb::BLACK, origin: MIDDLE, axis: Vec3::new(side, 0.0, 0.0) };
    let (left, right) = if side < 0.0 { (-1.0, 0.0) } else { (0.0, 1.0) };
    let min = Vec3::new(MIDDLE.x + left, -20.0, MIDDLE.z - 1.0);
    let max = Vec3::new(MIDDLE.x + right, 20.0, MIDDLE.z);
    Object::new(Shape::axis_box(min, max), glow(light))
}

/// An upright block between two values of x and of y, which reaches from −z to z: as far as the first value of `z` at
/// the first x and as far as the second at the second.
const fn upright(x: [f32; 2], z: [f32; 2], y: [f32; 2]) -> [Triangle<f32>; 12] {
    const fn side(a: Vec3<f32>, b: Vec3<f32>, c: Vec3<f32>, d: Vec3<f32>) -> [Triangle<f32>; 2] {
        [Triangle { vertices: [a, b, c] }, Triangle { vertices: [a, c, d] }]
    }
    let [low, high] = y;
    let (a, b) = (Vec3::new(x[0], low, z[0]), Vec3::new(x[1], low, z[1]));
    let (c, d) = (Vec3::new(x[1], low, -z[1]), Vec3::new(x[0], low, -z[0]));
    let (e, f) = (Vec3::new(x[0], high, z[0]), Vec3::new(x[1], high, z[1]));
    let (g, h) = (Vec3::new(x[1], high, -z[1]), Vec3::new(x[0], high, -z[0]));
    let ([p, q], [r, s], [t, u]) = (side(e, f, g, h), side(a, d, c, b), side(a, b, f, e));
    let ([i, j], [k, l], [m, n]) = (side(b, c, g, f), side(c, d, h, g), side(d, a, e, h));
    [p, q, r, s, t, u, i, j, k, l, m, n]
}
