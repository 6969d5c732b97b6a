//! `f32` with functions of a few dozen integer instructions.

mod exponential;
mod number;
mod power;
mod turns;

/// An `f32` with functions for processors without an FPU: a few dozen integer instructions each, the same on every target.
///
/// The operators are those of `f32`, and so are √x and ⌊x⌋: rays meet the same surfaces in the same places, and
/// the bounds on rounding hold as they do for `f32`. The other functions, which weigh light and move no ray that goes
/// straight, are approximations:
///
/// | function | largest error | how |
/// |---|---|---|
/// | `exp` | 5.6e-5 of the result, 3.4e-5 for \|x\| ≤ 10 | 2ᶻ with its whole part as exponent, degree 4 |
/// | `powf` | 2.2e-5 for 0 ≤ x ≤ 1, y > 0; else 3e-5·(1 + \|log₂ xʸ\|) of the result | log₂ x of degree 6, 2ᶻ of degree 4 |
/// | [`sin_cos_turns`](crate::Real::sin_cos_turns) | 2.6e-5 | turns modulo 1 as an integer, degree 5 and 6 in eighths |
///
/// `cargo test --features micromath --test fast` tries these errors; with `WHIT_HARD_CASES=full` for every `f32`.
///
/// With an FPU, `Fast` is of use where a scene has real exponents of highlights or films; it is for processors without one.
///
/// None of the functions is the `micromath` crate's: [`Micromath`](super::Micromath) has those, which are further off and,
/// as sums and products of floating-point numbers, take longer where there is no FPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fast(pub f32);
