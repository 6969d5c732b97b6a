//! Integers shifted until their top bit is set.

/// Whether the processor counts leading zeros.
const COUNTS_ZEROS: bool = !super::IS_SMALL && !cfg!(all(target_arch = "riscv32", not(target_feature = "zbb")));

/// x·2^s ≥ 2³¹ and s, for x > 0.
#[inline(always)]
pub(super) fn normalised(x: u32) -> (u32, u32) {
    if COUNTS_ZEROS {
        let shift = x.leading_zeros() & 31;
        (x << shift, shift)
    } else if super::IS_SMALL {
        searched(x)
    } else {
        search(x)
    }
}

/// The same for a wide integer: the upper half of x·2^s ≥ 2⁶³ and s.
#[inline(always)]
pub(super) fn normalised_wide(x: u64) -> (u32, u32) {
    let (high, low) = ((x >> 32) as u32, x as u32);
    if high == 0 {
        let (top, shift) = normalised(low);
        (top, shift + 32)
    } else {
        let (top, shift) = normalised(high);
        (top | ((low >> 1) >> (31 - shift)), shift)
    }
}

/// A function of its own where registers are few.
#[inline(never)]
fn searched(x: u32) -> (u32, u32) {
    search(x)
}

/// Comparisons find the four bits that the top one is among, and a table where in these.
#[inline(always)]
fn search(x: u32) -> (u32, u32) {
    let upper_half = |x: u32| {
        if x >> 24 == 0 {
            if x >> 20 == 0 { 12 } else { 8 }
        } else if x >> 28 == 0 {
            4
        } else {
            0
        }
    };
    let shift = if x >> 16 == 0 { 16 + upper_half(x << 16) } else { upper_half(x) };
    let x = x << shift;
    let rest = u32::from(ZEROS.get((x >> 28) as usize).copied().unwrap_or(0)) & 3;
    (x << rest, shift | rest)
}

/// Of four bits.
static ZEROS: [u8; 16] = [3, 3, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];

/// x / 2^shift, rounded down, of which only the low 32 bits are given; 0 < `shift` < 32.
#[inline(always)]
pub(super) fn shifted(x: i64, shift: u32) -> i32 {
    let (high, low) = ((x >> 32) as u32, x as u32);
    (((high << 1) << (31 - shift)) | (low >> shift)) as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_top_bit_is_set() {
        let mut random = fastrand::Rng::with_seed(2);
        for _ in 0..super::super::effort(1, 2_000_000).1 {
            let wide = (random.u64(..) >> random.u32(0..64)).max(1);
            let (x, shift) = (wide as u32 | 1, (wide as u32 | 1).leading_zeros());
            assert_eq!(normalised(x), (x << shift, shift));
            assert_eq!(search(x), (x << shift, shift));
            let zeros = wide.leading_zeros();
            assert_eq!(normalised_wide(wide), (((wide << zeros) >> 32) as u32, zeros));
            let shift = random.u32(1..32);
            assert_eq!(shifted(wide as i64, shift), (wide as i64 >> shift) as i32);
        }
    }
}
