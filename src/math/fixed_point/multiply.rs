//! Products.
//!
//! Where the processor has only the low 32 bits of a product, it is put together from four products of halves. The lower
//! half is taken with its sign, from −2¹⁵ to 2¹⁵ − 1, so that the sum of the two middle products fits.

use super::{IS_SMALL, LARGEST};

/// a·b, the nearest number; halves go up.
///
/// It is to fit into 32 bits. The factors are below 2³¹ − 2¹⁵.
#[inline(always)]
pub(crate) fn multiply(a: i32, b: i32, frac: u32) -> i32 {
    debug_assert!(i32::try_from(rounded(i64::from(a) * i64::from(b), frac)).is_ok(), "overflow: {a} * {b}");
    if IS_SMALL { multiply_halves(a, b, frac) } else { rounded(i64::from(a) * i64::from(b), frac) as i32 }
}

/// a·b, exactly, with twice the fraction bits. The factors are below 2³¹ − 2¹⁵.
#[inline(always)]
pub(crate) fn product(a: i32, b: i32) -> i64 {
    if IS_SMALL { product_halves(a, b) } else { i64::from(a) * i64::from(b) }
}

/// The nearest number to one with twice the fraction bits; halves go up.
#[inline(always)]
pub(crate) fn narrow(w: i64, frac: u32) -> i32 {
    let high = (w >> 32) as i32;
    if high >> (frac - 3) == high >> 31 {
        ((w >> (frac - 1)) as i32 + 1) >> 1 // Its size is below 2²⁹.
    } else {
        narrow_large(w, frac)
    }
}

#[cold]
#[inline(never)]
fn narrow_large(w: i64, frac: u32) -> i32 {
    let rounded = (w >> frac) + ((w >> (frac - 1)) & 1);
    rounded.clamp(-i64::from(LARGEST), i64::from(LARGEST)) as i32
}

#[inline(always)]
const fn rounded(w: i64, frac: u32) -> i64 {
    (w + (1 << (frac - 1))) >> frac
}

/// The upper 32 bits of a·b. The factors are below 2³¹ − 2¹⁵.
#[inline(always)]
pub(super) fn high(a: i32, b: i32) -> i32 {
    (product(a, b) >> 32) as i32
}

/// The upper 32 bits of a·b for any `a`, and `b` from 0 to 2³⁰.
#[inline(always)]
pub(super) fn high_of_any(a: i32, b: i32) -> i32 {
    if IS_SMALL { high_of_any_halves(a, b) } else { ((i64::from(a) * i64::from(b)) >> 32) as i32 }
}

/// The upper 32 bits of x², for any x.
#[inline(always)]
pub(super) fn high_of_square(x: i32) -> u32 {
    if IS_SMALL { high_of_square_halves(x) } else { ((i64::from(x) * i64::from(x)) >> 32) as u32 }
}

/// x² for x below 2³¹.
#[inline(always)]
pub(super) fn square(x: u32) -> u64 {
    if IS_SMALL {
        (u64::from(high_of_square_halves(x as i32)) << 32) | u64::from(x.wrapping_mul(x))
    } else {
        u64::from(x) * u64::from(x)
    }
}

/// a·b, exactly.
#[inline(always)]
pub(super) fn unsigned_product(a: u32, b: u32) -> u64 {
    if IS_SMALL { unsigned_product_halves(a, b) } else { u64::from(a) * u64::from(b) }
}

/// The upper 32 bits of a·b.
#[inline(always)]
pub(super) fn unsigned_high(a: u32, b: u32) -> u32 {
    (unsigned_product(a, b) >> 32) as u32
}

/// ⌊a·b / 2¹⁶⌋ for `b` ≤ 2¹⁶, and a result below 2³².
#[inline(always)]
pub(super) fn short_product(a: u32, b: u32) -> u32 {
    if IS_SMALL { short_product_halves(a, b) } else { ((u64::from(a) * u64::from(b)) >> 16) as u32 }
}

/// high·2¹⁶ + low.
#[inline(always)]
fn halves(x: i32) -> (i32, i32) {
    let low = i32::from(x as i16);
    (x.wrapping_sub(low) >> 16, low)
}

/// The product of the upper halves, the sum of the middle products, and the product of the lower halves.
#[inline(always)]
fn partial_products(a: i32, b: i32) -> (i32, i32, i32) {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    (a1.wrapping_mul(b1), a1.wrapping_mul(b2).wrapping_add(a2.wrapping_mul(b1)), a2.wrapping_mul(b2))
}

#[inline(always)]
fn multiply_halves(a: i32, b: i32, frac: u32) -> i32 {
    if frac > 16 {
        let (upper, middle, lower) = partial_products(a, b);
        let low = middle.wrapping_add((lower >> 16) + (1 << (frac - 17))) >> (frac - 16);
        return (upper << (32 - frac)).wrapping_add(low);
    }
    // Nothing above 32 bits comes back into them.
    let ((a1, a2), (b1, b2)) = ((a >> 16, a & 0xffff), (b >> 16, b & 0xffff));
    let middle = a1.wrapping_mul(b).wrapping_add(a2.wrapping_mul(b1));
    let lower = (((a2 as u32 * b2 as u32) >> (frac - 1)) + 1) >> 1;
    (middle << (16 - frac)).wrapping_add(lower as i32)
}

#[inline(always)]
fn product_halves(a: i32, b: i32) -> i64 {
    let (upper, middle, lower) = partial_products(a, b);
    let high = upper.wrapping_add(middle.wrapping_add(lower >> 16) >> 16);
    (i64::from(high) << 32) | i64::from(a.wrapping_mul(b) as u32)
}

// Here the lower half of any number is without its sign, the middle products still fit.

#[inline(always)]
fn high_of_any_halves(a: i32, b: i32) -> i32 {
    let ((a1, a2), (b1, b2)) = ((a >> 16, a & 0xffff), halves(b));
    a1 * b1 + ((a1 * b2 + a2 * b1 + ((a2 * b2) >> 16)) >> 16)
}

#[inline(always)]
fn high_of_square_halves(x: i32) -> u32 {
    let (x1, x2) = (x >> 16, x & 0xffff);
    (x1 * x1 + ((x1 * x2 + ((x2 as u32 * x2 as u32) >> 17) as i32) >> 15)) as u32
}

#[inline(always)]
fn unsigned_product_halves(a: u32, b: u32) -> u64 {
    let ((a1, a2), (b1, b2)) = ((a >> 16, a & 0xffff), (b >> 16, b & 0xffff));
    let (first, second) = (a1 * b2 + ((a2 * b2) >> 16), a2 * b1);
    // Half the sum of the two, which itself may not fit. (In the usual form, the compiler would see a wide product in this
    // and call the function for it, which takes longer.)
    let middle = (first & second) + ((first ^ second) >> 1);
    let high = a1 * b1 + (middle >> 15);
    (u64::from(high) << 32) | u64::from(a.wrapping_mul(b))
}

#[inline(always)]
fn short_product_halves(a: u32, b: u32) -> u32 {
    ((a >> 16) * b).wrapping_add(((a & 0xffff) * b) >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all sizes, and those beside a power of two.
    fn numbers() -> impl Iterator<Item = (i32, i32)> {
        let mut random = fastrand::Rng::with_seed(1);
        let edges: Vec<i32> = (0..31)
            .flat_map(|bit| [-2, -1, 0, 1, 2].map(|step| (1_i32 << bit).wrapping_add(step)))
            .chain([0x7fff_7fff, 0x7fff_0000, 0x4000_8000])
            .flat_map(|x| [x, -x])
            .filter(|x| x.abs() < 0x7fff_8000)
            .collect();
        let pairs: Vec<_> = edges.iter().flat_map(|&a| edges.iter().map(move |&b| (a, b))).collect();
        let mut one = move || (random.i32(-0x7fff_7fff..0x7fff_8000)) >> random.u32(0..31);
        pairs.into_iter().chain((0..super::super::effort(1, 2_000_000).1).map(move |_| (one(), one())))
    }

    #[test]
    fn halves_give_the_bits_of_wide_products() {
        for (a, b) in numbers() {
            let product = i64::from(a) * i64::from(b);
            assert_eq!(product_halves(a, b), product, "{a} {b}");
            for frac in [12, 15, 16, 17, 20, 26] {
                assert_eq!(multiply_halves(a, b, frac), rounded(product, frac) as i32, "{a} {b} {frac}");
            }
            for a in [a, i32::MIN, i32::MAX, a ^ i32::MIN] {
                assert_eq!(high_of_square_halves(a), ((i64::from(a) * i64::from(a)) >> 32) as u32, "{a}");
                let b = b.abs().min(1 << 30);
                assert_eq!(high_of_any_halves(a, b), ((i64::from(a) * i64::from(b)) >> 32) as i32, "{a} {b}");
            }
            let (a, b) = (a as u32, b as u32);
            let product = u64::from(a) * u64::from(b);
            assert_eq!(unsigned_product_halves(a, b), product, "{a} {b}");
            for b in [b >> 16, 0x1_0000] {
                if let Ok(short) = u32::try_from((u64::from(a) * u64::from(b)) >> 16) {
                    assert_eq!(short_product_halves(a, b), short, "{a} {b}");
                }
            }
        }
    }

    #[test]
    fn products_are_the_nearest_numbers() {
        for (a, b) in numbers() {
            let exact = i64::from(a) * i64::from(b);
            let nearest = (i128::from(exact) * 2 + (1 << 16)).div_euclid(1 << 17);
            assert_eq!(i128::from(narrow(exact, 16)), nearest.clamp(-i128::from(LARGEST), i128::from(LARGEST)));
            if let Ok(nearest) = i32::try_from(nearest) {
                assert_eq!(multiply(a, b, 16), nearest, "{a} {b}");
            }
        }
        for w in [i64::MAX, i64::MAX - 1, 1 << 62] {
            assert_eq!(narrow(w, 26), LARGEST);
            assert_eq!(narrow(-w, 26), -LARGEST);
        }
    }
}
