//! The page docs/effects.md.

use std::collections::HashMap;
use std::fmt::Write;

use whit::Effects;

use crate::size::Probe;

/// Two scenes and what the one has and the other has not.
pub struct Row {
    pub effects: Effects,
    pub with: &'static str,
    pub without: &'static str,
    /// Nanoseconds a ray with the effects and without.
    pub speed: [f64; 2],
}

const HEAD: &str = "\
# What each effect costs

A tracer is compiled for the effects of its scene ([`Effects`](../src/scene/effects.rs)). This page compares pairs of
small scenes ([`examples/effects/scenes.rs`](../examples/effects/scenes.rs)) that differ by the effects in the first
column. `cargo test --test absence` shows that the code of an effect is in the binary of the one and not of the other.

    rustup target add thumbv7em-none-eabihf
    cargo run --release --example effects

writes this page.

- **Code**: bytes of machine code that the effects add to a linked program for a Cortex-M4F (`thumbv7em-none-eabihf`),
  library functions included, at `opt-level` \"s\" and 3. The compiler shares and inlines code as it sees fit, so small
  differences are only roughly those of the effect itself.
- **Frame**: bytes of RAM that they add to a frame of 5 bounces on that processor.
- **Time**: nanoseconds a ray without and with them, on the machine that wrote the page; the least of 301 runs in turn. A
  scene with more kinds of rays has other rays too, so this compares scenes more than instructions.

| effects | code, \"s\" | code, 3 | frame | ns a ray | scenes |
|---|--:|--:|--:|--:|---|
";

/// The whole page.
pub fn page(rows: &[Row], probes: &HashMap<&str, [Probe; 2]>) -> String {
    let mut page = HEAD.to_owned();
    for Row { effects, with, without, speed } in rows {
        let ([small, fast], [small_without, fast_without]) = (&probes[with], &probes[without]);
        let gain = |more: u64, less: u64| more as i64 - less as i64;
        let _ = writeln!(
            page,
            "| {effects} | {:+} | {:+} | {:+} | {:.0} → {:.0} | `{with}`, `{without}` |",
            gain(small.code, small_without.code),
            gain(fast.code, fast_without.code),
            gain(fast.frame, fast_without.frame),
            speed[1],
            speed[0],
        );
    }
    let [small, fast] = &probes["EMPTY"];
    let _ = writeln!(
        page,
        "\nThe whole program for `EMPTY`, two planes under a directional light, is {} bytes of code at \"s\" and {} at 3, \
         and its frame is {} bytes.",
        small.code, fast.code, fast.frame
    );
    page
}
