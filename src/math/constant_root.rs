//! The square root for constants.

/// √x, to a rounding; zero for what has no real root.
///
/// [`Real::sqrt`](super::Real::sqrt) is an instruction, which the compiler cannot evaluate. Half the exponent is right to 6 %;
/// Newton's method goes above the root from there, and then falls until rounding stops it.
pub(crate) const fn square_root_constant(x: f64) -> f64 {
    if x.is_nan() || x <= 0.0 {
        return 0.0;
    }
    let start = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    let mut root = 0.5 * (start + x / start);
    loop {
        let next = 0.5 * (root + x / root);
        if next < root {
            root = next;
        } else {
            return root;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::square_root_constant;

    /// The standard library's root is correctly rounded.
    #[test]
    fn is_within_a_rounding_of_the_exact_one() {
        for i in 1..100_000 {
            for scale in [1e-300, 1e-20, 1e-3, 1e12, 1e300] {
                let x = f64::from(i) * scale;
                assert!((square_root_constant(x) - x.sqrt()).abs() <= x.sqrt() * f64::EPSILON, "{x}");
            }
        }
        assert_eq!(square_root_constant(f64::INFINITY), f64::INFINITY);
        assert_eq!([0.0, -1.0, f64::NAN].map(square_root_constant), [0.0; 3]);
    }
}
