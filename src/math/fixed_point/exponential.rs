//! Powers of e and of 2.

use super::LARGEST;
use super::multiply::{product, unsigned_high};

/// eˣ, within 1 unit in the last place up to 1, and within 2⁻²⁴ of it or that above.
#[inline(always)]
pub(crate) fn exponential(x: i32, frac: u32) -> i32 {
    const LOG2_E: i32 = 1_549_082_005; // Times 2³⁰.
    let log = product(x, LOG2_E);
    power_of_two((log >> (frac + 30)) as i32, (log >> (frac - 2)) as u32, frac)
}

/// 2^(whole + part·2⁻³²)
#[inline(never)]
pub(super) fn power_of_two(whole: i32, part: u32, frac: u32) -> i32 {
    let shift = 30 - frac as i32 - whole;
    if shift < 1 {
        return LARGEST;
    }
    // 2^(z/16) − 1 for z from 0 to 1, times 2³⁶, within 2⁻²⁹·⁶ after 80 is taken off.
    let z = part << 4;
    let rise = unsigned_high(z, 2_977_047_037 + unsigned_high(z, 64_472_507 + ((59_476 * (z >> 16)) >> 12)));
    let root = root_of_two(part >> 28);
    let power = (root >> 1) + (unsigned_high(root, rise) >> 5) - 1; // From 2³⁰ to 2³¹.
    let twice = power.checked_shr(shift as u32 - 1).unwrap_or(0);
    ((twice + 1) >> 1).min(LARGEST as u32) as i32
}

/// 2^(index/16) times 2³¹, for `index` below 16.
#[inline(always)]
pub(super) fn root_of_two(index: u32) -> u32 {
    ROOTS_OF_TWO.get(index as usize & 15).copied().unwrap_or(0)
}

static ROOTS_OF_TWO: [u32; 16] = [
    2_147_483_648,
    2_242_560_872,
    2_341_847_524,
    2_445_529_972,
    2_553_802_834,
    2_666_869_345,
    2_784_941_738,
    2_908_241_642,
    3_037_000_500,
    3_171_459_999,
    3_311_872_529,
    3_458_501_653,
    3_611_622_603,
    3_771_522_796,
    3_938_502_376,
    4_112_874_773,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_e_are_as_good_as_said() {
        for frac in [12, 16, 20, 26] {
            let (mut worst, mut worst_relative) = (0_f64, 0_f64);
            let one = f64::from(1 << frac);
            let last = (f64::from(LARGEST) / one).ln() * one;
            for x in (i32::MIN + 2..=i32::MAX).step_by(super::super::effort(401, 0).0).chain(-100..100) {
                let found = f64::from(exponential(x, frac));
                if f64::from(x) > last + 1e-7 * one {
                    assert_eq!(found, f64::from(LARGEST));
                    continue;
                }
                let exact = ((f64::from(x) / one).exp() * one).min(f64::from(LARGEST));
                let error = (found - exact).abs();
                if x <= 0 {
                    worst = worst.max(error);
                } else {
                    worst_relative = worst_relative.max((error - 1.0) / exact);
                }
            }
            println!("{frac} bits: {worst} units up to 1, 2^{} beyond a unit above", worst_relative.log2());
            assert!(worst < 0.65 && worst_relative < 2_f64.powi(-28), "{frac} {worst} {worst_relative}");
            assert_eq!(exponential(0, frac), 1 << frac);
        }
    }
}
