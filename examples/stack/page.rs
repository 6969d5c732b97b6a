//! The page docs/stack.md.

use std::fmt::Write;

use crate::build::{LEVELS, TARGETS, Target};
use crate::graph::Link;
use crate::measure::Measure;

/// A program may take more stack than the page says by the larger of these: a share and so many bytes.
const SLACK_SHARE: u32 = 8;
const SLACK_BYTES: u32 = 64;

const HEAD: &str = "\
# How much stack rendering takes

Rendering on bare metal takes a [`Frame`](../src/render/frame.rs), the picture, which is the caller's, and stack. This
page says how much stack `Frame::step` takes in the worst case, in bytes, and how large the frame is. The RAM that
rendering takes, beside the picture's, is the sum.

    rustup target add thumbv6m-none-eabi thumbv7em-none-eabihf
    cargo run --release --example stack

writes this page. With `-- --check` it compares instead, and fails where a frame is larger or a stack larger by more than
an eighth or 64 bytes, whichever is more: another compiler lays stack frames out in another way.

## How it is known

Each row is a linked program ([`firmware.rs`](../examples/stack/firmware.rs)) that renders one scene, with 16 KiB of RAM,
into a `LinearRgb` over a static array. The built-in scenes are constants, with a tracer each for what they call for;
\"any, at run time\" is a tracer for all effects, `Effects::ALL`, and eight media; in another number type than `f32`,
the program converts the scene first. The machine code is followed from `step` on, a function that does nothing but call
`Frame::step`.

- **Stack frames.** Every way through a function is followed with the number of bytes on the stack. Where the compiler
  notes the size of the stack frame (`-Z emit-stack-sizes`), the two must be equal.
- **Calls.** A call counts with the bytes that its caller has on the stack at that moment. The linker must know of each
  (`--emit-relocs`).
- **No function pointers.** No call goes to what a register holds, and nowhere is the address of a function kept. A jump
  through a table beside the code is taken to lead to all of its function that nothing else leads to.
- **No recursion.** No function gets to itself by any chain of calls.
- **No panics.** Nothing of `core::panicking` and no panic handler is in the program, also not for what comes before
  `step`: `Frame::new`, and `Tracer::try_new`, which checks the scene. Nothing in `step` traps.
- **Each of these can fail.** Small programs with a panic, a recursion, a function pointer, a trap, a stack that grows by
  a variable and one that grows behind the compiler's back are looked into as well; each must be refused, for its fault.
- **Seen** is what was used when QEMU ran the program. It must not be more than the worst case, and is less where the
  picture does not go the worst way.

What is above `step` on the stack is the caller's and not in these figures. Nor are interrupts: for each, the processor
itself takes 32 bytes, or 104 with an FPU. `put` of a framebuffer is called from `step`, which has most of its stack in use
then; one that needs much itself adds to that. The frames are without an observer.
";

/// The whole page.
pub fn page(measures: &[Measure], compiler: &str) -> String {
    let mut page = HEAD.to_owned();
    let agreed: usize = measures.iter().map(|measure| measure.sources.compiler).sum();
    let decoded: usize = measures.iter().map(|measure| measure.sources.code).sum();
    let _ = write!(
        page,
        "\nThe figures are of {compiler}\nin a release with one codegen unit, at `opt-level` 3 and \"s\". In all programs \
         together, the compiler notes the size of\nthe stack frame of {agreed} functions, and each is what the code says. \
         For {decoded}, which come compiled with the toolchain or\nare written in assembler (arithmetic, `memcpy`), there \
         is only the code.\n\n\
         The ray tree is in the frame, so how deep it may be does not matter for the stack: between 1 and 64 bounces, \
         frames\ndiffer by {} bytes, and stacks by {}, which is how the compiler lays them out.\n",
        spread(measures, |measure| measure.frame),
        spread(measures, |measure| u64::from(measure.stack)),
    );
    for target in TARGETS {
        section(&mut page, measures, target);
    }
    page
}

/// The most by which programs differ that differ only by their bounces.
pub fn spread(measures: &[Measure], figure: impl Fn(&Measure) -> u64) -> u64 {
    let differences = measures.iter().flat_map(|one| measures.iter().map(move |other| (one, other)));
    let key = |measure: &Measure| (measure.program.clone(), measure.target, measure.level);
    let alike = differences.filter(|(one, other)| key(one) == key(other));
    alike.map(|(one, other)| figure(one).abs_diff(figure(other))).max().unwrap_or_default()
}

fn section(page: &mut String, measures: &[Measure], target: Target) {
    let _ = write!(
        page,
        "\n{}\n\n{}, in QEMU's `{}`.\n\n\
         | scene | bounces | frame | stack, 3 | seen | stack, \"s\" | seen |\n|---|--:|--:|--:|--:|--:|--:|\n",
        heading(target.name),
        target.processor,
        target.machine
    );
    let here = || measures.iter().filter(|measure| measure.target == target.name);
    for row in here().filter(|measure| measure.level == LEVELS[0]) {
        let _ = write!(page, "| {} | {} | {} |", row.program, row.bounces, row.frame);
        for level in LEVELS {
            let cell =
                here().find(|cell| (&cell.program, cell.bounces, cell.level) == (&row.program, row.bounces, level));
            let seen = cell.and_then(|cell| cell.seen).map_or_else(|| "–".to_owned(), |seen| seen.to_string());
            let _ = write!(page, " {} | {seen} |", cell.map_or(0, |cell| cell.stack));
        }
        page.push('\n');
    }
    let _ = write!(page, "\nThe calls that take the most, at `opt-level` 3, with the stack of each:\n\n");
    for row in here().filter(|measure| measure.level == LEVELS[0]) {
        let _ = writeln!(page, "- {}, {} bounces: {}", row.program, row.bounces, calls(&row.chain));
    }
}

fn heading(target: &str) -> String {
    format!("## `{target}`")
}

fn calls(chain: &[Link]) -> String {
    let links: Vec<String> = chain.iter().map(|link| format!("`{}` {}", link.name, link.bytes)).collect();
    links.join(" → ")
}

/// What a page says of a program: bytes of frame and of stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Documented {
    frame: u64,
    stack: u32,
}

/// Lines that set the figures beside those of a page, and what is too much.
pub fn compare(page: &str, measures: &[Measure]) -> (Vec<String>, Vec<String>) {
    let (mut lines, mut too_much) = (Vec::new(), Vec::new());
    for measure in measures {
        let Measure { program, bounces, target, level, frame, stack, chain, .. } = measure;
        let place = format!("{program}, {bounces} bounces, {target}, opt-level {level}");
        let Some(documented) = documented(page, measure) else {
            too_much.push(format!("{place}: not there at all"));
            continue;
        };
        lines.push(format!(
            "{place}: stack {stack} (documented {}), frame {frame} (documented {})",
            documented.stack, documented.frame
        ));
        let most = documented.stack + SLACK_BYTES.max(documented.stack / SLACK_SHARE);
        if *stack > most {
            let more = stack - documented.stack;
            too_much.push(format!("{place}: {more} bytes of stack more ({stack}): {}", calls(chain)));
        }
        if *frame > documented.frame {
            too_much.push(format!("{place}: the frame has {} bytes more ({frame})", frame - documented.frame));
        }
    }
    (lines, too_much)
}

fn documented(page: &str, measure: &Measure) -> Option<Documented> {
    let (_, section) = page.split_once(&format!("{}\n", heading(measure.target)))?;
    let section = section.split("\n## ").next()?;
    let column = LEVELS.iter().position(|level| *level == measure.level)?;
    section.lines().find_map(|line| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let &["", program, bounces, frame, ref stacks @ .., ""] = cells.as_slice() else { return None };
        let is_here = program == measure.program && bounces.parse() == Ok(measure.bounces);
        let stack = stacks.get(2 * column).filter(|_| is_here)?;
        Some(Documented { frame: frame.parse().ok()?, stack: stack.parse().ok()? })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::Sources;

    fn measure(stack: u32, frame: u64, level: &'static str) -> Measure {
        let chain = vec![Link { name: "step".to_owned(), bytes: stack }];
        let (program, bounces, target) = ("`glass`".to_owned(), 5, TARGETS[1].name);
        Measure { program, bounces, target, level, frame, stack, chain, seen: None, sources: Sources::default() }
    }

    /// A page of one program at both levels.
    fn written(three: u32, small: u32, frame: u64) -> String {
        page(&[measure(three, frame, LEVELS[0]), measure(small, frame, LEVELS[1])], "rustc")
    }

    #[test]
    fn pages_are_read_as_they_are_written() {
        let page = written(1000, 2000, 600);
        for (level, stack) in LEVELS.into_iter().zip([1000, 2000]) {
            assert_eq!(documented(&page, &measure(0, 0, level)), Some(Documented { frame: 600, stack }));
        }
        let elsewhere = Measure { target: TARGETS[0].name, ..measure(0, 0, LEVELS[0]) };
        assert_eq!(documented(&page, &elsewhere), None);
        assert_eq!(documented(&page, &Measure { bounces: 4, ..measure(0, 0, LEVELS[0]) }), None);
    }

    #[test]
    fn growth_past_the_slack_is_too_much() {
        let page = written(1000, 160, 600);
        let too_much = |stack, frame, level| compare(&page, &[measure(stack, frame, level)]).1;
        assert_eq!(too_much(1125, 600, "3"), Vec::<String>::new());
        assert_eq!(
            too_much(1126, 600, "3"),
            ["`glass`, 5 bounces, thumbv6m-none-eabi, opt-level 3: 126 bytes of stack more (1126): `step` 1126"]
        );
        assert_eq!(too_much(224, 600, "s").len(), 0);
        assert_eq!(too_much(225, 600, "s").len(), 1);
        assert_eq!(too_much(160, 604, "s").len(), 1);
        let unknown = Measure { bounces: 64, ..measure(1, 1, "3") };
        assert_eq!(compare(&page, &[unknown]).1.len(), 1);
    }
}
