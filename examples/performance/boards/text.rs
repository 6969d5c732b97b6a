//! The section of the page.

use std::fmt::Write;

use super::original::{COMPILER, FLAGS};
use super::{ORIGINAL, Row, WHIT};

const HEAD: &str = "\
## On a Cortex-M4F

Scenes that other ray tracers for microcontrollers are measured by, on the emulated board `mps2-an386`. The emulator's clock
advances by one nanosecond for each instruction, so the counts are the same in every run. Memory costs nothing there, and a
division no more than an addition: a real processor takes more cycles. Counted is what goes from the camera to bytes for a
display; code is the whole program with its start-up.

- `card`: the business card's scene, 64×64 pixels of one sample, each as large as 8×8 of the original's.
- `raystones`: the benchmark of that name of [learn-fpga](https://github.com/BrunoLevy/learn-fpga), 40×20 pixels, 2 bounces.
  Its glass has highlights on the inside as well, and light that would be reflected totally goes on in a fixed direction.
- `ftb`: the scene of [RAYTRACER_sample](https://github.com/hirakuni45/RX/tree/master/RAYTRACER_sample), 320×240 pixels, 2 bounces.
  Its sky is more blue, and the light on its balls goes by the square of the cosine; here it goes by the cosine.

";

const NO_COMPILER: &str = "\
The C++ program was not measured: `apt install gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib`.
";
const NO_EMULATOR: &str = "Nothing was measured: `apt install qemu-system-arm`.\n";

/// The section in Markdown.
pub fn section(rows: &[Row]) -> String {
    let mut text = HEAD.to_owned();
    if rows.is_empty() {
        return text + NO_EMULATOR;
    }
    text.push_str("| scene | program | pixels | rays | instructions | a ray | a pixel | code, bytes |\n");
    text.push_str("|---|---|--:|--:|--:|--:|--:|--:|\n");
    for row in rows {
        let Row { scene, program, instructions, rays, pixels, text: code } = row;
        let (ray, pixel) = (row.per_ray(), row.per_pixel());
        let _ =
            writeln!(text, "| `{scene}` | {program} | {pixels} | {rays} | {instructions} | {ray} | {pixel} | {code} |");
    }
    text.push('\n');
    match compare(rows) {
        Some(share) => text + &share,
        None => text + NO_COMPILER,
    }
}

/// How much of the original's instructions this library takes.
fn compare(rows: &[Row]) -> Option<String> {
    let original = rows.iter().find(|row| row.program == ORIGINAL)?;
    let ours = rows.iter().find(|row| row.program == WHIT && row.scene == original.scene)?;
    let share = ours.instructions as f64 / original.instructions as f64;
    Some(format!(
        "C++ is the card's own program in single precision, [card.cpp](../examples/performance/card.cpp), by\n\n    \
         {COMPILER} {}\n\n\
         It sends rays to the light also where no highlight could come of them, and adds to products without rounding them\n\
         (`vfma`). `whit` takes {share:.2} of its instructions.\n",
        FLAGS.join(" ")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(program: &'static str, instructions: u64) -> Row {
        Row { scene: "card", program, instructions, rays: 10, pixels: 4, text: 5000 }
    }

    #[test]
    fn a_section_has_a_line_for_each_program() {
        let text = section(&[row(WHIT, 1000), row(ORIGINAL, 3000)]);
        assert!(text.contains("| `card` | C++ | 4 | 10 | 3000 | 300 | 750 | 5000 |\n"), "{text}");
        assert!(text.contains("takes 0.33 of"), "{text}");
    }

    #[test]
    fn what_is_missing_is_told() {
        assert!(section(&[]).ends_with(NO_EMULATOR));
        assert!(section(&[row(WHIT, 1000)]).ends_with(NO_COMPILER));
    }
}
