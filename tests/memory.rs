//! The size of a frame: what the documentation says.
#![cfg(target_pointer_width = "64")]
#![allow(missing_docs)]

use whit::{Frame, scenes};

const EFFECTS: u64 = scenes::SHOWCASE.effects().bits();

/// The table of the crate's documentation and of the README.
#[test]
fn documented_sizes_are_true() {
    macro_rules! sizes {
        ($real:ty, $media:literal) => { sizes!($real, $media; 0 1 2 3 4 5 8 16 64) };
        ($real:ty, $media:literal; $($depth:literal)*) => {
            [$(size_of::<Frame<'_, $real, EFFECTS, $depth, (), $media>>().to_string()),*].join(" | ")
        };
    }
    let single = format!("| `f32` | {} |", sizes!(f32, 0));
    let nested = format!("| `f32`, 8 media | {} |", sizes!(f32, 8));
    let double = format!("| `f64` | {} |", sizes!(f64, 0));
    for text in [include_str!("../src/lib.rs"), include_str!("../README.md")] {
        assert!(text.contains(&single), "expected {single}");
        assert!(text.contains(&nested), "expected {nested}");
        assert!(text.contains(&double), "expected {double}");
    }
}
