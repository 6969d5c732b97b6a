//! `f32` with functions of a few dozen integer instructions.

mod exponential;
mod number;
mod power;
mod turns;

/// An `f32` with functions for processors without an FPU: a few dozen integer instructions each, the same on every target.
///
/// The operators are those of `f32`, and so are √x and ⌊x⌋, to the bit: rays meet the same surfaces in the same places, and
/// the bounds on rounding hold as they do for `f32`. The other functions, which weigh light and move no ray that goes
/// straight, are approximations:
///
/// | function | largest error | how |
/// |---|---|---|
/// | `sqrt` | none | an estimate from 128 bytes of table, a series of degree 3, then the nearest by its square; the instruction where there is one |
/// | `floor` | none | bits cut off |
/// | `exp` | 5.5e-5 of the result, 3.6e-5 for \|x\| ≤ 10 | 2ᶻ with its whole part as exponent, degree 4 |
/// | `powf` | 2.1e-5 for 0 ≤ x ≤ 1, y > 0; else 3e-5·(1 + \|log₂ xʸ\|) of the result | log₂ x of degree 6, 2ᶻ of degree 4 |
/// | [`sin_cos_turns`](crate::Real::sin_cos_turns) | 2.6e-5 | turns modulo 1 as an integer, degree 5 and 6 in eighths |
///
/// `cargo test --features micromath --test fast` tries these errors; with `WHIT_HARD_CASES=full` for every `f32`.
///
/// What a call takes, in instructions, counted in QEMU; first `f32`, then `Fast`:
///
/// | | Cortex-M4F | Cortex-M3 | Cortex-M0 | RV32IMAC |
/// |---|---|---|---|---|
/// | `sqrt` | 6 → 6 | 130 → 62 | 423 → 90 | 126 → 78 |
/// | `floor` | 22 → 23 | 263 → 20 | 363 → 20 | 265 → 19 |
/// | `exp` | 62 → 54 | 1306 → 49 | 2210 → 67 | 1252 → 61 |
/// | `powf` | 252 → 133 | 6148 → 153 | 10442 → 175 | 5958 → 160 |
/// | `sin_cos_turns` | 104 → 75 | 2028 → 147 | 3484 → 266 | 2047 → 252 |
///
/// With an FPU, `Fast` is of use where a scene has real exponents of highlights or films; it is for processors without one.
///
/// None of the functions is the `micromath` crate's. Its largest errors are 6.1 % in `sqrt` and 3.4 % in `invsqrt`, which
/// would put rays beside the surfaces that they leave, 2.4e-3 in `exp`, 1.1e-3 in `sin` and 0.43 in `powf` for x ≤ 1; and all
/// but the first two are floating-point sums and products, which without an FPU take as long as `libm`'s.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fast(pub f32);
