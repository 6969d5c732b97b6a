//! Square roots.

use super::multiply::{short_product, square};
use super::normalise::normalised;

/// √x, the nearest number; 0 for x ≤ 0.
#[inline(always)]
pub(crate) fn sqrt(x: i32, frac: u32) -> i32 {
    if x <= 0 {
        return 0;
    }
    if frac > 20 { ((square_root((x as u64) << (frac + 2)) + 1) >> 1) as i32 } else { short_root(x as u32, frac) }
}

/// √(x·2^frac), the nearest integer, for 0 < x < 2³¹ and `frac` up to 20.
#[inline(never)]
fn short_root(x: u32, frac: u32) -> i32 {
    let (_, zeros) = normalised(x);
    let zeros = zeros - ((zeros ^ frac) & 1); // Such that half the power of two is an integer.
    let shift = (30 + zeros).wrapping_sub(frac) >> 1 & 31; // At least 5.
    let (root, error, _) = estimate(x << zeros);
    let root = root.wrapping_add_signed(((root >> 15) as i32 * error) >> 15);
    let root = (((root >> (shift - 1)) + 1) >> 1) as i32;
    // At most by one off. What the square leaves is then small, and known from its low bits.
    let rest = (x << frac).wrapping_sub((root as u32).wrapping_mul(root as u32)) as i32;
    root + i32::from(rest > root) - i32::from(rest <= -root)
}

/// ⌊√w⌋ for w < 2⁶².
#[inline(never)]
pub(crate) fn square_root(w: u64) -> u32 {
    if w == 0 {
        return 0;
    }
    let (high, low, shift) = aligned(w);
    let (root, error, y) = estimate(high);
    let mut root = root.wrapping_add_signed(((root >> 15) as i32 * error) >> 15);
    // Not too small, and too large by one at most.
    if shift > 4 {
        let root = (root + 15) >> shift;
        // What the square leaves is then small, and known from its low bits.
        return root - ((w as u32).wrapping_sub(root.wrapping_mul(root)) >> 31);
    }
    // Near the largest, these are not yet all digits. The others are what the square leaves, over twice the root.
    let rest = (u64::from(high) << 30 | u64::from(low >> 2)).wrapping_sub(square(root)) as i64;
    root = root.wrapping_add_signed(((rest >> 20) as i32 * y as i32 + (15 << 23)) >> 27) >> shift;
    if square(root) > w { root - 1 } else { root }
}

/// w·2^(2·shift) ≥ 2⁶², in two halves, and `shift` − 1.
#[inline(always)]
fn aligned(w: u64) -> (u32, u32, u32) {
    let (mut high, mut low, mut shift) = ((w >> 32) as u32, w as u32, 0);
    if high == 0 {
        (high, low, shift) = (low, 0, 32);
    }
    let (_, zeros) = normalised(high);
    let zeros = zeros & 30;
    (high << zeros | (low >> 1) >> (31 - zeros), low << zeros, ((shift + zeros) >> 1) - 1)
}

/// For x from 2³⁰: √x·2¹⁵, how much of it is missing, relatively and times 2³⁰ (signed, below 2¹⁵), and 2³¹/√x within 2⁻¹⁵.
#[inline(always)]
pub(super) fn estimate(x: u32) -> (u32, i32, u32) {
    let y = reciprocal_root(x);
    let root = short_product(x, y);
    let error = 0_u32.wrapping_sub((root >> 1).wrapping_mul(y)) as i32;
    (root, error >> 16, y)
}

/// 2³¹/√x for x from 2³⁰, within 2⁻¹⁵: two steps of Newton's method.
#[inline(never)]
fn reciprocal_root(x: u32) -> u32 {
    let y = u32::from(SEED.get((x >> 26) as usize).copied().unwrap_or(0));
    let y = (y * ((3_u32 << 30).wrapping_sub(y * y * (x >> 16)) >> 8)) >> 15;
    let error = 0_u32.wrapping_sub(((y * y) >> 15).wrapping_mul(x >> 15)) as i32;
    y.wrapping_add_signed((y as i32 * (error >> 7) + (1 << 24)) >> 26) // In the middle between what was cut off.
}

/// 2⁷/√x in the middle of each 64th.
static SEED: [u8; 64] = [
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 252, 245, 238, 232, 226, 221, 216, 211, 207, 203, 199, 195, 192,
    189, 185, 182, 180, 177, 174, 172, 169, 167, 165, 163, 161, 159, 157, 155, 154, 152, 150, 149, 147, 146, 144, 143,
    141, 140, 139, 137, 136, 135, 134, 133, 132, 131, 130, 129,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(w: u64) -> u64 {
        w.isqrt()
    }

    #[test]
    fn wide_roots_are_exact() {
        let mut random = fastrand::Rng::with_seed(6);
        for w in 0..1 << 22 {
            assert_eq!(u64::from(square_root(w)), exact(w), "{w}");
        }
        for _ in 0..super::super::effort(1, 3_000_000).1 {
            let w = (random.u64(..) >> 2) >> random.u32(0..62);
            assert_eq!(u64::from(square_root(w)), exact(w), "{w}");
            let near = exact(w) * exact(w);
            for w in [near.saturating_sub(1), near, near + 1, near + 2 * exact(w)] {
                assert_eq!(u64::from(square_root(w)), exact(w), "{w}");
            }
        }
        for w in (1 << 62) - 1000..1 << 62 {
            assert_eq!(u64::from(square_root(w)), exact(w), "{w}");
        }
    }

    #[test]
    fn narrow_roots_are_the_nearest_numbers() {
        for frac in [12, 13, 16, 20, 21, 26] {
            for x in (-1000..=i32::MAX).step_by(super::super::effort(211, 0).0) {
                let nearest = exact((x.max(0) as u64) << (frac + 2)).div_ceil(2);
                assert_eq!(sqrt(x, frac) as u64, nearest, "{x} {frac}");
            }
        }
    }

    /// Where a root is next to the middle between two numbers.
    #[test]
    fn halves_are_decided() {
        for frac in [12, 13, 16] {
            for root in (1_u64 << frac..1 << 21).flat_map(|root| [root - 1, root]) {
                let x = (root * (root + 1)) >> frac;
                for x in [x, x + 1].into_iter().filter(|&x| x < 1 << 31) {
                    assert_eq!(sqrt(x as i32, frac) as u64, exact(x << (frac + 2)).div_ceil(2), "{x} {frac}");
                }
            }
        }
    }

    #[test]
    fn the_estimate_is_within_its_bound() {
        let (mut worst, mut root_error) = (0_f64, 0_f64);
        for x in (1 << 30..=u32::MAX).step_by(super::super::effort(307, 0).0) {
            let (root, error, y) = estimate(x);
            worst = worst.max((f64::from(y) * f64::from(x).sqrt() / 2_f64.powi(31) - 1.0).abs());
            let root = f64::from(root.wrapping_add_signed(((root >> 15) as i32 * error) >> 15));
            root_error = root_error.max((root - (f64::from(x) * 2_f64.powi(30)).sqrt()).abs());
        }
        println!("1/√x within 2^{}, √x within {root_error}", worst.log2());
        assert!(worst < 2_f64.powi(-15) && root_error < 15.0, "{worst:e} {root_error}");
    }
}
