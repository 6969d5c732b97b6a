//! A sky of stars that is a function of the direction alone.

use super::sequence::mix;
use crate::math::{Real, Rgb, Vec3};

/// The light of the stars in a direction, of which the brightest gives 1 in its middle.
///
/// The direction is a point on the cube around the eye; each face is cut into `cells`² cells. A hash of the cell says
/// whether there is a star in it, where, how bright and of which colour. No star reaches into another cell, so that one cell
/// is all there is to look at.
pub(super) fn stars<T: Real>(direction: Vec3<T>, cells: u16, radius: T) -> Rgb<T> {
    let (face, u, v) = on_cube(direction);
    let ((i, x), (j, y)) = (cell(u, cells), cell(v, cells));
    let hash = mix(face.wrapping_add(6_u32.wrapping_mul(i.wrapping_add(u32::from(cells).wrapping_mul(j)))));
    if hash & 1 == 0 {
        return Rgb::BLACK;
    }
    let place = mix(hash ^ 0x9e37_79b9);
    let within = |bits: u32| radius + (T::ONE - radius - radius) * share(bits & 0xffff, 16);
    let (x, y) = (x - within(place), y - within(place >> 16));
    let rest = T::ONE - T::ratio(x.product(x) + y.product(y), radius.product(radius));
    if rest <= T::ZERO {
        return Rgb::BLACK;
    }
    let magnitude = share::<T>((hash >> 8) & 0xffff, 16).powi(4);
    let color = HOT.map(T::from_f32).mix(COOL.map(T::from_f32), share(hash >> 24, 8));
    color * (magnitude * rest * rest)
}

/// The colours of the hottest and of the coolest star.
const HOT: Rgb<f32> = Rgb::new(0.7, 0.8, 1.0);
const COOL: Rgb<f32> = Rgb::new(1.0, 0.8, 0.6);

/// So many bits as a number from 0 to 1.
fn share<T: Real>(bits: u32, count: u32) -> T {
    T::fraction(bits << (32 - count))
}

/// The face of the cube from −1 to 1 that a direction goes through, and where on it.
fn on_cube<T: Real>(Vec3 { x, y, z }: Vec3<T>) -> (u32, T, T) {
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    let (axis, along, u, v) = if ax >= ay && ax >= az {
        (0, x, y, z)
    } else if ay >= az {
        (1, y, z, x)
    } else {
        (2, z, x, y)
    };
    let scale = if along == T::ZERO { T::ZERO } else { T::ONE / along.abs() };
    (2 * axis + u32::from(along < T::ZERO), u * scale, v * scale)
}

/// The cell of a place from −1 to 1, and where in the cell it is.
fn cell<T: Real>(place: T, cells: u16) -> (u32, T) {
    let last = T::from_u32(u32::from(cells).saturating_sub(1));
    let scaled = (place + T::ONE) * T::HALF * T::from_u32(cells.into());
    let cell = scaled.floor().max(T::ZERO).min(last);
    (cell.to_f32() as u32, scaled - cell)
}
