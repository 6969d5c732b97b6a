//! The page docs/targets.md.

use std::fmt::Write;

use crate::cargo::PROFILES;
use crate::firmware::Measure;
use crate::scene::{DEPTH, SIZE};
use crate::target::{TARGETS, Target};

/// By how many hundredths a figure may be above the page's: by the compiler that the page is of and by another.
const SLACK: u64 = 3;
const SLACK_ELSEWHERE: u64 = 25;

const COLUMNS: [&str; 9] =
    ["scene", "flash, 3", "flash, \"s\"", "RAM", "stack, 3", "stack, \"s\"", "a ray, 3", "a pixel, 3", "a ray, \"s\""];

const HEAD: &str = "\
# What the firmware takes

The example `firmware` renders a scene on a microcontroller, a row of pixels at a time, and writes it to a file on the host.
This page says what it takes: of flash and RAM, of stack, and of the processor's time.

    rustup target add thumbv7em-none-eabihf thumbv7m-none-eabi thumbv6m-none-eabi
    rustup target add riscv32imac-unknown-none-elf wasm32-unknown-unknown
    cargo run --release --example targets

writes it, and needs QEMU for Arm and for RISC-V. With `-- --check` it compares instead, and fails where a figure is larger
by more than 3 %, or, with another compiler than the page's, by more than a quarter.

- **Flash**: bytes of the vector table, code and constants of the whole program: start-up, the scene, the tracer,
  the encoding to 8 bits, and what talks to the host; compiled by the profiles `release` (`opt-level` 3) and
  `small` (\"s\").
- **RAM**: bytes of variables: the [`Frame`](../src/render/frame.rs), a row of the picture, and some words.
- **Stack**: bytes that rendering used when it ran, measured by filling the free stack with a pattern; below it the
  worst case, worked out from the machine code of that same program as in [stack.md](stack.md), where it is an Arm processor.
- **Instructions** a ray, shadow rays included, and a pixel, counted by the emulator's clock, which advances by one nanosecond
  for each instruction: the same number in every run. The encoding and the checksum are in it. Memory costs nothing there,
  and a division no more than an addition: a real processor takes more cycles.

";

/// The whole page.
pub fn page(measures: &[Measure], compiler: &str) -> String {
    let mut page = HEAD.to_owned();
    let _ = write!(
        page,
        "Pictures have {}×{} pixels of one sample, at most {DEPTH} bounces of branches that weigh at least 1/255; the compiler is {compiler}.\n\n\
         Every picture here, and those of the example `conformance` on all these processors, on x86-64 and in WebAssembly, has\n\
         the same bits.\n",
        SIZE.width, SIZE.height
    );
    for target in &TARGETS {
        section(&mut page, measures, target);
    }
    page
}

fn section(page: &mut String, measures: &[Measure], target: &Target) {
    let _ = write!(page, "\n{}\n\n{}, in QEMU's `{}`.\n\n", heading(target), target.processor, target.board);
    let _ = writeln!(page, "| {} |", COLUMNS.join(" | "));
    page.push_str("|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    let here = || measures.iter().filter(|measure| measure.target == target.name);
    for fast in here().filter(|measure| measure.level == PROFILES[0].level) {
        let Some(small) = here().find(|small| small.level == PROFILES[1].level && small.scene == fast.scene) else {
            continue;
        };
        let cells = [
            format!("`{}`", fast.scene),
            fast.flash.to_string(),
            small.flash.to_string(),
            fast.memory.to_string(),
            stack(fast),
            stack(small),
            fast.per_ray().to_string(),
            fast.per_pixel().to_string(),
            small.per_ray().to_string(),
        ];
        let _ = writeln!(page, "| {} |", cells.join(" | "));
    }
}

fn heading(target: &Target) -> String {
    format!("## `{}`", target.name)
}

/// What was used, of how much at most.
fn stack(measure: &Measure) -> String {
    let used = measure.stack;
    measure.most_stack.map_or_else(|| used.to_string(), |most| format!("{used} of {most}"))
}

/// Lines that say which figures are larger than the page's.
pub fn compare(page: &str, measures: &[Measure], compiler: &str) -> Vec<String> {
    let slack = if page.contains(compiler) { SLACK } else { SLACK_ELSEWHERE };
    let now = self::page(measures, compiler);
    let mut problems = Vec::new();
    for target in &TARGETS {
        for row in rows(&now, target) {
            match rows(page, target).into_iter().find(|documented| documented.first() == row.first()) {
                Some(documented) => problems.extend(larger(target, &row, &documented, slack)),
                None => problems.push(format!("{}, {}: not there at all", target.name, row.concat())),
            }
        }
    }
    problems
}

/// The table's cells, line by line.
fn rows(page: &str, target: &Target) -> Vec<Vec<String>> {
    let section = page.split_once(&format!("{}\n", heading(target))).map_or("", |(_, rest)| rest);
    let section = section.split("\n## ").next().unwrap_or_default();
    let rows = section.lines().filter(|line| line.starts_with("| `"));
    rows.map(|line| line.split('|').map(|cell| cell.trim().to_owned()).filter(|cell| !cell.is_empty()).collect())
        .collect()
}

fn larger(target: &Target, row: &[String], documented: &[String], slack: u64) -> Vec<String> {
    let scene = row.first().map_or("", String::as_str);
    let cells = COLUMNS.iter().zip(row.iter().zip(documented)).skip(1);
    let grown = cells.filter(|(_, (now, then))| match (number(now), number(then)) {
        (Some(now), Some(then)) => 100 * now > (100 + slack) * then,
        _ => true,
    });
    let line = |(column, (now, then)): (&&str, (&String, &String))| {
        let percent = number(now).zip(number(then)).map(|(now, then)| 100.0 * (now as f64 / then.max(1) as f64 - 1.0));
        let percent = percent.map_or(String::new(), |percent| format!(", {percent:+.2} %"));
        format!("{}, {scene}, {column}: {now}, not {then}{percent}", target.name)
    };
    grown.map(line).collect()
}

/// The last number of a cell: of a stack, the most.
fn number(cell: &str) -> Option<u64> {
    cell.rsplit(' ').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measures(flash: u64) -> Vec<Measure> {
        let measure = |target: &Target, level| Measure {
            scene: "glass".to_owned(),
            target: target.name,
            level,
            flash,
            memory: 876,
            stack: 1000,
            most_stack: target.is_arm.then_some(1100),
            instructions: 768_000,
            rays: 1000,
        };
        TARGETS.iter().flat_map(|target| PROFILES.map(|profile| measure(target, profile.level))).collect()
    }

    #[test]
    fn a_page_agrees_with_itself() {
        let page = page(&measures(32_000), "rustc 1");
        assert!(page.contains("| `glass` | 32000 | 32000 | 876 | 1000 of 1100 | 1000 of 1100 | 768 | 1000 | 768 |"));
        assert_eq!(compare(&page, &measures(32_000), "rustc 1"), Vec::<String>::new());
    }

    #[test]
    fn growth_past_the_slack_is_told() {
        let page = page(&measures(32_000), "rustc 1");
        assert_eq!(compare(&page, &measures(32_960), "rustc 1").len(), 0);
        let told = compare(&page, &measures(32_961), "rustc 1");
        assert_eq!(told.len(), 2 * TARGETS.len());
        assert_eq!(told[0], "thumbv7em-none-eabihf, `glass`, flash, 3: 32961, not 32000, +3.00 %");
        assert_eq!(compare(&page, &measures(40_000), "rustc 2").len(), 0);
        assert_eq!(compare(&page, &measures(40_001), "rustc 2").len(), 2 * TARGETS.len());
        assert_eq!(compare("", &measures(32_000), "rustc 1").len(), TARGETS.len());
    }
}
