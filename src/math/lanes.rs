//! Eight numbers side by side, where the target has registers for them.

/// Eight `f32` that are computed with at once. Each has the bits it has alone.
pub(crate) type Lanes = wide::f32x8;

/// How many that are.
pub(crate) const LANES: usize = 8;

/// Whether the target has vector registers.
pub(crate) const HAS_VECTORS: bool =
    cfg!(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128"));

/// Eight `f32` to compute with at once; `None` where it takes no less time than one after the other.
#[inline(always)]
pub(super) fn of(numbers: &[f32; LANES]) -> Option<Lanes> {
    if HAS_VECTORS { Some(Lanes::new(*numbers)) } else { None }
}
