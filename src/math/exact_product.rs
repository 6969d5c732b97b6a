//! The rounding error of a product, without a fused multiply-add.

use super::Real;

/// a·b − product, exactly, for `product` = a·b as it is computed (Dekker, "A Floating-Point Technique for Extending the
/// Available Precision", 1971).
///
/// `splitter` is 2ˢ + 1 with s half the digits of the number type, rounded up; no product may over- or underflow.
#[inline]
pub(super) fn error<T: Real>(a: T, b: T, product: T, splitter: T) -> T {
    let ((a1, a2), (b1, b2)) = (halves(a, splitter), halves(b, splitter));
    ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2
}

/// Two numbers of half the digits each, whose sum is `x`.
#[inline]
fn halves<T: Real>(x: T, splitter: T) -> (T, T) {
    let scaled = x * splitter;
    let high = scaled - (scaled - x);
    (high, x - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_exact() {
        let mut x = 0x1234_5678_u32;
        for _ in 0..100_000 {
            x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let a = f32::from_bits((x >> 9) | 0x3f80_0000) - 1.5;
            let b = f32::from_bits((x << 7 >> 9) | 0x4080_0000);
            let error = a.product_error(b, a * b);
            assert_eq!(f64::from(a) * f64::from(b) - f64::from(a * b), f64::from(error), "{a} {b}");
        }
        assert_eq!(0.1_f64.product_error(0.1, 0.1 * 0.1), -8.326_672_684_688_674e-19);
    }
}
