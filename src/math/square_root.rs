//! The square root that the hardware has, or one in integers where it has none.
//!
//! `core` has no stable square root and `libm`'s is integer code on Arm, also where there is an FPU. The C
//! symbols below are known to the compiler, which replaces the call by `vsqrt.f32`, `sqrtss` or
//! `f32.sqrt`; where there is no such instruction, the compiler's own runtime library supplies them. IEEE 754 asks for
//! the correctly rounded result, so every target gives the same bits.
//!
//! The sign is taken off first, because C wants to be told of numbers below zero: for those, the compiler would keep the
//! call beside the instruction, and the function in the program.
#![allow(unsafe_code)] // Declaring a foreign function is all it takes; the functions themselves are safe to call.

use super::{HAS_FPU, integer_root};

unsafe extern "C" {
    safe fn sqrtf(x: f32) -> f32;
    safe fn sqrt(x: f64) -> f64;
}

#[inline(always)]
pub(super) fn f32(x: f32) -> f32 {
    // Where there is no FPU, the runtime library's takes four times as long.
    if HAS_FPU { sqrtf(x.abs()) } else { integer_root::square_root(x) }
}

#[inline(always)]
pub(super) fn f64(x: f64) -> f64 {
    sqrt(x.abs())
}

#[cfg(test)]
mod tests {
    /// libm's integer square root is the independent source; 2³²/97 bit patterns are tried.
    #[test]
    fn has_the_bits_of_libm() {
        for bits in (0..=f32::MAX.to_bits()).step_by(97) {
            let x = f32::from_bits(bits);
            assert_eq!(super::f32(x).to_bits(), libm::sqrtf(x).to_bits(), "{x:e}");
        }
    }
}
