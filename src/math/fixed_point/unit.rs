//! Unit vectors.
//!
//! The coordinates are shifted together until the largest has all of the digits, so a short vector is treated as well as a
//! long one.

use super::multiply::{high_of_any, high_of_square};
use super::normalise::{normalised, shifted};
use super::root::estimate;

/// v/|v|, each coordinate within 1 unit in the last place; `None` for 0.
#[inline(always)]
pub(crate) fn unit_narrow(v: [i32; 3], frac: u32) -> Option<[i32; 3]> {
    let [x, y, z] = v;
    if x | y | z == 0 { None } else { Some(narrow_to_unit(x, y, z, frac)) }
}

/// The same for wide coordinates, below 2⁶².
#[inline(always)]
pub(crate) fn unit(v: [i64; 3], frac: u32) -> Option<[i32; 3]> {
    let [x, y, z] = narrowed(v);
    unit_narrow([x, y, z], frac)
}

/// The same direction, in all digits of 32 bits if it has more.
#[inline(never)]
fn narrowed([x, y, z]: [i64; 3]) -> [i32; 3] {
    let bits = (x ^ (x >> 63)) | (y ^ (y >> 63)) | (z ^ (z >> 63));
    let (upper, lower) = ((bits >> 32) as u32, bits as u32);
    if upper == 0 && lower >> 31 == 0 {
        return [x as i32, y as i32, z as i32];
    }
    let shift = if upper == 0 { 1 } else { 33 - normalised(upper).1 } & 31;
    [shifted(x, shift), shifted(y, shift), shifted(z, shift)]
}

#[inline(never)]
fn narrow_to_unit(x: i32, y: i32, z: i32, frac: u32) -> [i32; 3] {
    let bits = (x ^ (x >> 31)) | (y ^ (y >> 31)) | (z ^ (z >> 31));
    // One of the coordinates becomes at least 2³⁰.
    let (_, zeros) = normalised((bits as u32) << 1 | 1);
    let [x, y, z] = [x << zeros, y << zeros, z << zeros];
    // The mean of what is cut off three squares is 1.5.
    let mut square = high_of_square(x) + high_of_square(y) + high_of_square(z) + 1;
    let mut shift = 29 - frac;
    if square < 1 << 30 {
        square <<= 2;
        shift -= 1;
    }
    let (_, error, root) = estimate(square);
    let reciprocal = ((root << 14) as i32).wrapping_add((root as i32 * error) >> 16);
    let half = (1 << shift) >> 1;
    [x, y, z].map(|v| (high_of_any(v, reciprocal) + half) >> shift)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest error of a coordinate, in units in the last place.
    fn error(v: [i64; 3], found: Option<[i32; 3]>, frac: u32) -> f64 {
        let v = v.map(|c| c as f64);
        let length = v[0].hypot(v[1]).hypot(v[2]);
        let one = 2_f64.powi(frac as i32);
        found
            .unwrap_or_else(|| panic!("{v:?}"))
            .iter()
            .zip(v)
            .map(|(&f, v)| (f64::from(f) - v / length * one).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn units_are_within_a_unit_in_the_last_place() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut worst = [(0.0, [0; 3]); 5];
        for _ in 0..super::super::effort(1, 1_000_000).1 {
            let size = random.u32(0..62);
            let mut one = || ((random.i64(..) >> 1) >> size) >> if random.bool() { 0 } else { random.u32(0..20) };
            let v = [one(), one(), one()];
            if v == [0; 3] {
                continue;
            }
            for (worst, frac) in worst.iter_mut().zip([12, 16, 20, 24, 26]) {
                let found = unit(v, frac);
                let off = error(v, found, frac);
                if off > worst.0 {
                    *worst = (off, v);
                }
                if let [Ok(x), Ok(y), Ok(z)] = v.map(i32::try_from) {
                    assert_eq!(unit_narrow([x, y, z], frac), found);
                }
            }
        }
        println!("{worst:?}");
        assert!(worst.iter().all(|&(off, _)| off < 1.0), "{worst:?}");
        assert_eq!((unit([0; 3], 16), unit_narrow([0; 3], 16)), (None, None));
    }

    #[test]
    fn axes_are_exact() {
        for frac in 12..=26 {
            for bit in 0..31 {
                for v in [1 << bit, (1 << bit) + (1 << bit >> 1), (1_i64 << bit) * 2 - 1] {
                    let v = v.min(i64::from(i32::MAX)) as i32;
                    assert_eq!(unit_narrow([0, v, 0], frac), Some([0, 1 << frac, 0]), "{v} {frac}");
                    assert_eq!(unit_narrow([0, 0, -v], frac), Some([0, 0, -(1 << frac)]), "{v} {frac}");
                }
            }
        }
    }
}
