//! The sections of the page, one a case.

mod anything;
mod boxes;
mod cancellation;
mod chains;
mod coincidence;
mod interfaces;
mod invariance;
mod numbers;
mod scale;
mod self_intersection;
mod total_reflection;
mod triangles;

use super::page::Page;

const HEAD: &str = "
# Hard cases

Scenes and rays that break ray tracers: what goes wrong in a naive form, what whit does instead, and the bound that it
meets. The naive forms are in [`examples/stability/naive`](../examples/stability/naive); the tests show that they fail and
that the library does not:

    cargo test --test 'hard_cases_*' --test scale_invariance --test anything -- --nocapture

prints the figures that are quoted here; `WHIT_HARD_CASES=full` before it traces ten times as many rays.

This page and its pictures, naive on the left and whit on the right, are written by

    cargo run --release --example stability

u is the unit roundoff, 2⁻²⁴ for `f32`: the largest relative error of one operation. All of this is in `f32`.
";

/// Writes all of them.
pub fn write(page: &mut Page) -> Result<(), String> {
    page.text(HEAD);
    scale::write(page)?;
    cancellation::write(page)?;
    self_intersection::write(page)?;
    boxes::write(page)?;
    triangles::write(page)?;
    interfaces::write(page)?;
    total_reflection::write(page)?;
    chains::write(page)?;
    coincidence::write(page)?;
    numbers::write(page)?;
    invariance::write(page)?;
    anything::write(page);
    Ok(())
}
