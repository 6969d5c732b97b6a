//! What a fuzzer found.

use crate::page::Page;

pub fn write(page: &mut Page) {
    page.text(
        "
## Anything

Arbitrary bytes become scenes of every shape, material, light and camera, with settings and rays, or files in Neutral File
Format. Whatever validation accepts must render finite pixels that are not negative, within its budget of rays, with the same
bits in steps of any size, in `f32` and `f64`; all else must be refused by an error. `cargo test --test anything` does that for some
thousand of them, and

    cargo +nightly fuzz run -s none scene
    cargo +nightly fuzz run -s none nff

for as long as you like ([`fuzz/README.md`](../fuzz/README.md)). In 84 minutes on one core, 2.5 million scenes and 5.1 million
files, no file broke the reader, and scenes showed these faults, which are mended. Their inputs stay in
[`tests/anything/seeds`](../tests/anything/seeds) or as tests of their own:

- Shadow rays through tinted media took what was left of a step from the pixel's budget, so pictures depended on the step.
- A gradient background made negative light where two unit vectors' product rounds past 1; so did a reflectance that rounds past
  1 over a coat, and in `f64` a balance that is 1 only in `f32`.
- 0/0: a conductor without contrast at grazing incidence, equal indices where the cosine's square underflows, a falloff at a
  distance whose square overflows. 0·∞: a light too bright for `f32` at a surface that none of it gets through.
- Normals that were not unit vectors: of spheres smaller than a rounding of their place, of triangles below 1e-38.
- Eye rays without a direction, through a lens focused at 1e12 in a view as wide as that.
- 255 bounces were no bound, since the number of the next one did not fit its byte.
- The material of an empty list of triangles was checked for constant scenes only.
",
    );
}
