//! The square root, in integers.
//!
//! It starts from an estimate of 1/√m, for the significand m from 1 to 4 that is left when an even power of two is
//! taken out: 8 bits from a table, and a correction from how far m·estimate² is from 1. No product is wider than 32 bits,
//! so a Cortex-M0 has an instruction for each.

/// About 256/√m, for the lowest bit of the exponent and the first six of the significand.
static ESTIMATES: [u8; 128] = estimates();

#[allow(clippy::indexing_slicing)] // The compiler evaluates it.
const fn estimates() -> [u8; 128] {
    let mut table = [0; 128];
    let mut place = 0;
    while place < 128 {
        // In 64ths; an odd exponent of the format, which has an odd bias, is an even one of the number.
        let octave = if place < 64 { 2 } else { 1 };
        let low = (64 + place % 64) * octave;
        table[place as usize] = best_estimate(low, low + octave);
        place += 1;
    }
    table
}

/// The r for which m·(r/256)² is nearest to 1 from one m to the other, which are in 64ths.
const fn best_estimate(low: i32, high: i32) -> u8 {
    let (mut best, mut smallest) = (0, i32::MAX);
    let mut r = 1;
    while r < 256 {
        let (below, above) = ((1 << 22) - low * r * r, high * r * r - (1 << 22));
        let largest = if below > above { below } else { above };
        if largest < smallest {
            (best, smallest) = (r as u8, largest);
        }
        r += 1;
    }
    best
}

/// r and 2c in 2⁻³⁷ for which 1/√m = (1 + c)·r/256; `significand` is m in 2⁻²³.
///
/// 1 + c = 1/√(1 − d) = 1 + d/2 + 3/8·d² + 5/16·d³ + …, where d = 1 − m·(r/256)² is at most 0.0126: what is left out is
/// below 7e-9.
#[inline(always)]
fn estimate(bits: u32, significand: u32) -> (u32, i32) {
    let r = u32::from(*ESTIMATES.get((bits >> 17) as usize & 127).unwrap_or(&0));
    let square = r * r;
    // The product in 2⁻³⁷ without its upper bits: those are the 1.
    let product = (significand >> 2).wrapping_mul(square).wrapping_add(((significand & 3) * square) >> 2);
    let d = (product as i32).wrapping_neg();
    let short = d >> 16;
    let factor = (3 << 13) + ((5 * short) >> 9); // 3/4 + 5/8·d in 2⁻¹⁵.
    (r, d + ((((short * short) >> 15) * factor) >> 5))
}

/// The significand from 1 to 2 in 2⁻²³.
#[inline(always)]
const fn significand(bits: u32) -> u32 {
    bits & 0x007f_ffff | 0x0080_0000
}

/// The lowest bit of the number's exponent.
#[inline(always)]
const fn is_odd(bits: u32) -> u32 {
    !bits >> 23 & 1
}

/// √|x|, correctly rounded.
#[inline]
pub(super) fn square_root(x: f32) -> f32 {
    let bits = x.to_bits() & 0x7fff_ffff;
    if bits.wrapping_sub(0x0080_0000) >= 0x7f00_0000 {
        return root_of_special(x.abs());
    }
    root_of_normal(bits)
}

#[inline(always)]
fn root_of_normal(bits: u32) -> f32 {
    let (m, odd) = (significand(bits), is_odd(bits));
    let (r, c) = estimate(bits, m << odd);
    let rough = m * r;
    // rough·c in two products.
    let c = (c + (1 << 13)) >> 14;
    let correction = (rough >> 18) as i32 * c + (((rough >> 4 & 0x3fff) as i32 * c) >> 14);
    let near = (rough.wrapping_add_signed(correction >> 6) + (128 >> odd)) >> (8 - odd);
    // The root is `near` or next to it: the one whose square is the nearest. The squares differ by less than 2³¹.
    let rest = (m << (23 + odd)).wrapping_sub(near.wrapping_mul(near)) as i32;
    let root = near + u32::from(rest > near as i32) - u32::from(rest <= -(near as i32));
    let exponent = ((bits >> 23) + 125) >> 1;
    f32::from_bits((exponent << 23) + root)
}

/// Of zero, infinity, what is no number and numbers without all digits.
#[cold]
fn root_of_special(x: f32) -> f32 {
    if x > 0.0 && x < 1.0 { root_of_normal((x * 16_777_216.0).to_bits()) * (1.0 / 4096.0) } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the processor's; one of 97 bit patterns, or all with `WHIT_HARD_CASES=full` in the environment.
    #[test]
    fn integers_give_the_correctly_rounded_root() {
        let full = std::env::var("WHIT_HARD_CASES").is_ok_and(|value| value == "full");
        for bits in (0..=f32::INFINITY.to_bits()).step_by(if full { 1 } else { 97 }) {
            let x = f32::from_bits(bits);
            assert_eq!(square_root(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
            assert_eq!(square_root(-x).to_bits(), x.sqrt().to_bits(), "-{x:e}");
        }
        assert!(square_root(f32::NAN).is_nan());
    }
}
