//! Sine and cosine, in integers.

/// Sine and cosine of 2π·`turns`, as `(sin, cos)`, with an error of at most 2.6e-5.
///
/// The turns are taken modulo 1 as a 32-bit integer, exactly but for what is below 2⁻³². What is left beside the nearest
/// quarter, in eighths v, goes into polynomials in v² whose largest error is smallest: sin(πv/4) = v·(…) to 5.6e-7,
/// cos(πv/4) = 1 − v²·(…) to 3.3e-8 (by Lawson's iteration of least squares).
#[inline]
pub(super) fn sin_cos_turns(turns: f32) -> (f32, f32) {
    let bits = turns.to_bits();
    let phase = phase(bits);
    let quarter = phase.wrapping_add(1 << 29) >> 30;
    let eighths = phase.wrapping_sub(quarter << 30) as i32; // In 2⁻²⁹.
    let v = (eighths + (1 << 13)) >> 14;
    let square = (v * v) >> 14; // In 2⁻¹⁶, as the factors.
    let factor = 51_472 - ((square * (5290 - ((square * 159) >> 16))) >> 16);
    let sine = v * factor;
    let square = square as u32;
    let factor = 20_213 - ((square * (1039 - ((square * 21) >> 16))) >> 16);
    let cosine = (1 << 30) - ((square * factor) >> 2) as i32;
    let (sine, cosine) = (scaled(sine, 31), scaled(cosine, 30));
    let (sine, cosine) = match quarter & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    };
    (if bits >> 31 == 1 { -sine } else { sine }, cosine)
}

/// The fraction of |turns| in 2⁻³²; 0 for what is no number.
#[inline(always)]
fn phase(bits: u32) -> u32 {
    let significand = bits & 0x007f_ffff | 0x0080_0000;
    let shift = (bits >> 23 & 0xff) as i32 - 118;
    if shift >= 0 {
        significand.checked_shl(shift as u32).unwrap_or(0)
    } else {
        significand.checked_shr(-shift as u32).unwrap_or(0)
    }
}

/// number·2^(−digits): the conversion is correctly rounded, and so the same everywhere.
#[inline(always)]
fn scaled(number: i32, digits: u32) -> f32 {
    let bits = (number as f32).to_bits();
    f32::from_bits(if number == 0 { 0 } else { bits - (digits << 23) })
}
