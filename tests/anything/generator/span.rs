//! The ranges of numbers that validation accepts.

/// A closed range, and numbers in it that are often wanted.
#[derive(Clone, Copy)]
pub struct Span {
    pub low: f32,
    pub high: f32,
    pub usual: &'static [f32],
}

const fn span(low: f32, high: f32, usual: &'static [f32]) -> Span {
    Span { low, high, usual }
}

pub const LENGTH: Span = span(-1e12, 1e12, &[0.0, 0.5, 1.0, -1.0, 2.0]);
pub const POSITIVE: Span = span(1e-12, 1e12, &[0.25, 0.5, 1.0, 2.0, 1000.0]);
pub const AMOUNT: Span = span(0.0, 1e12, &[0.0, 0.25, 0.5, 0.8, 1.0, 3.0]);
pub const SHARE: Span = span(0.0, 1.0, &[0.0, 0.25, 0.5, 0.9, 1.0]);
pub const INDEX: Span = span(1e-3, 1e3, &[1.0, 1.33, 1.5, 1.51, 2.4, 0.6]);
pub const EXTINCTION: Span = span(0.0, 1e3, &[0.0, 1.0, 2.5, 3.4]);
pub const NANOMETRES: Span = span(0.0, 1e5, &[0.0, 100.0, 380.0, 900.0]);
pub const TANGENT: Span = span(1e-6, 1e6, &[0.25, 0.4, 0.6, 1.0]);
/// n − 1 or n² − 1
pub const EXCESS: Span = span(-0.999, 1e3, &[0.0, 0.3, 0.0003, 1.0, -0.2, 0.5]);
/// n² − 1, and lengths, by what they change over.
pub const SLOPE: Span = span(-1e3, 1e3, &[0.25, -0.25, 1.0, 0.05, -1.0]);
pub const RATIO: Span = span(-0.999, 1e6, &[0.1, -0.1, 0.0, 1.0]);
pub const TABLE: Span = span(-0.9, 9.0, &[0.0, 0.1, 1.0]);
pub const TOLERANCE: Span = span(1e-7, 0.1, &[1e-3, 1e-5, 1e-2, 1e-4]);
pub const SHARE_OF_WAY: Span = span(1e-4, 0.5, &[0.1, 0.01, 0.25]);
pub const MASS: Span = span(1e-9, 1e9, &[1.0, 0.1]);
/// The radius of a star.
pub const STAR: Span = span(1e-3, 0.5, &[0.1, 0.3]);
/// What settings take; they have no upper end but that of the number type.
pub const FINITE: Span = span(0.0, f32::MAX, &[0.0, 0.01, 0.1, 1.0]);

impl Span {
    /// The nearest number in the range; −0 stays as it is.
    pub fn fit(&self, x: f32) -> f32 {
        if x.is_nan() { self.low } else { x.clamp(self.low, self.high) }
    }

    /// The powers of 2 in the range.
    pub fn exponents(&self) -> (i32, i32) {
        // The smallest number above zero is 2⁻¹⁴⁹.
        let exponent = |x: f32| f64::from(x.max(f32::from_bits(1))).log2();
        (exponent(self.low).ceil() as i32, exponent(self.high).floor() as i32)
    }
}
