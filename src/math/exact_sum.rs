//! A sum with its rounding error.

use super::Real;

/// a + b as it is computed, and what rounding took from it, exactly (Knuth, "The Art of Computer Programming", volume 2,
/// 4.2.2).
#[inline]
pub(crate) fn sum_and_error<T: Real>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_taken = sum - a;
    let a_taken = sum - b_taken;
    (sum, (a - a_taken) + (b - b_taken))
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
            let b = (f32::from_bits((x << 7 >> 9) | 0x4180_0000) - 17.0) * 0.37;
            let (sum, error) = sum_and_error(a, b);
            assert_eq!(sum, a + b);
            assert_eq!(f64::from(a) + f64::from(b), f64::from(sum) + f64::from(error), "{a} {b}");
        }
    }
}
