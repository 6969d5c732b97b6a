//! The arithmetic of fixed-point numbers, on integers: for processors without an FPU, with the same bits on all.
//!
//! A number with `frac` fraction bits, 12 to 26, is held as an `i32`, which is the number times 2^`frac`. A number that does
//! not fit becomes ±[`LARGEST`].
//!
//! The small steps are inlined, the large ones are calls, so that a program has each once. No processor is asked for more
//! than it has: an ARMv6-M multiplies two 32-bit integers to the low 32 bits of the product, and has no division and no
//! count of leading zeros.

mod convert;
mod divide;
mod exponential;
mod multiply;
mod normalise;
mod power;
mod root;
mod unit;

pub(crate) use convert::{floor, from_f32, to_f32};
pub(crate) use divide::{quotient, ratio};
pub(crate) use exponential::exponential;
pub(crate) use multiply::{multiply, narrow, product};
pub(crate) use power::power;
pub(crate) use root::{sqrt, square_root};
pub(crate) use unit::{unit, unit_narrow};

/// What numbers that are too large become.
pub(crate) const LARGEST: i32 = (1 << 30) - 1;

/// Whether the processor is an ARMv6-M, or one as small: these are the Arm processors without atomic operations.
const IS_SMALL: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// −x if `is_negative`, and else x.
#[inline(always)]
fn signed(x: u32, is_negative: bool) -> i32 {
    let mask = -i32::from(is_negative);
    (x as i32 ^ mask).wrapping_sub(mask)
}

/// Of how many numbers the tests try one, and how many random ones: all, and many, if `WHIT_HARD_CASES` is `full`.
#[cfg(test)]
fn effort(step: usize, count: u32) -> (usize, u32) {
    if std::env::var("WHIT_HARD_CASES").is_ok_and(|value| value == "full") { (1, 100_000_000) } else { (step, count) }
}
