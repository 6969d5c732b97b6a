//! The page docs/instructions.md.

use std::fmt::Write;

use crate::compare::{SLACK, SLACK_ELSEWHERE};
use crate::count::Count;
use crate::counted;
use crate::profile::{self, Profile};
use crate::record::{Machine, Record};
use crate::subject::LARGEST;

/// The scenes of which the page says where their instructions go.
pub const PROFILED: [&str; 2] = ["card", "showcase"];
/// Files with a smaller share than this are summed up.
const LEAST_SHARE: f64 = 0.005;

const HEAD: &str = "\
# How many instructions rendering takes, and where they go

A count of instructions is the same in every run, so it shows a change of a hundredth, which a clock does not.

    rustup target add thumbv7em-none-eabihf
    cargo run --release --example instructions

writes this page and the counts that changes are compared with, [instructions.csv](instructions.csv). It needs Valgrind,
and QEMU for Arm. With `-- --check` it compares, for which Valgrind is enough, and fails where a scene takes more";

const HOST: &str = "\
Each scene is rendered by one thread, by a tracer for just its own effects. Valgrind's Callgrind counts the instructions of
the program from where `Frame::render` begins to where it ends. What the system's libraries do in between is not counted,
because they have other copies of `memcpy` for other processors;";

const BOARD: &str = "\
The example `firmware`, compiled by the profile `release`, in QEMU's";

const FILES: &str = "\
QEMU logs each instruction that is executed in the function that renders and in those that it calls, and the compiler's
tables of lines say what it is of: where functions are compiled into others, of the innermost. The operators of vectors,
colours and numbers are in `math/`; the second count has their instructions with the file that computes something by them,
except where they are functions of their own. What is no file is said in words. The encoding to 8 bits is among them all,
and the firmware's checksum.

    cargo run --release --example instructions -- --lines card

prints the same by line.";

/// The whole page.
pub fn page(records: &[Record], counts: &[Count], profiles: &[Profile]) -> Result<String, String> {
    let machine = &records.first().ok_or("nothing was counted")?.machine;
    let mut page = HEAD.to_owned();
    write_all(&mut page, machine, records, counts, profiles).map_err(|error| error.to_string())?;
    Ok(page)
}

fn write_all(
    page: &mut String,
    machine: &Machine,
    records: &[Record],
    counts: &[Count],
    profiles: &[Profile],
) -> std::fmt::Result {
    writeln!(
        page,
        "\nthan {SLACK} % more instructions than recorded, or, with another compiler than the record's, more than {SLACK_ELSEWHERE} % more.\n\
         [targets.md](targets.md) has such counts of emulated processors."
    )?;
    write_host(page, machine, records, counts)?;
    write_board(page, machine, profiles)
}

fn write_host(page: &mut String, machine: &Machine, records: &[Record], counts: &[Count]) -> std::fmt::Result {
    let (size, depth) = (counted::SIZE, counted::DEPTH);
    let share = counts.iter().map(|count| count.elsewhere as f64 / count.instructions as f64).fold(0.0, f64::max);
    writeln!(page, "\n## On `{}`\n\n{HOST} it is {:.1} % at most.", machine.host, 100.0 * share)?;
    writeln!(
        page,
        "\nPictures have {}×{} pixels of one sample, at most {depth} bounces of branches that weigh at least 1/255; rays are\n\
         counted with those to lights. The compiler is {}.",
        size.width, size.height, machine.compiler
    )?;
    writeln!(
        page,
        "\nA `flake of` so many is the sphere-flake, of so many single spheres on a floor, in a hierarchy of boxes; what ends in\n\
         `.nff` is a file of the Standard Procedural Databases, in one too, by a tracer for all that such a file can call for;\n\
         `building of {LARGEST}` builds the hierarchy of the largest flake.\n"
    )?;
    page.push_str("| scene | instructions | rays | a ray |\n|---|--:|--:|--:|\n");
    for Record { scene, instructions, rays, .. } in records {
        let cells = rays.map_or(["—".to_owned(), "—".to_owned()], |rays| {
            [rays.to_string(), (instructions / rays.max(1)).to_string()]
        });
        writeln!(page, "| `{scene}` | {instructions} | {} |", cells.join(" | "))?;
    }
    Ok(())
}

fn write_board(page: &mut String, machine: &Machine, profiles: &[Profile]) -> std::fmt::Result {
    let ([width, height], depth) = (profile::SIZE, profile::DEPTH);
    writeln!(
        page,
        "\n## Where they go on a Cortex-M4F\n\n{BOARD} `{}`: {width}×{height} pixels of one sample, at most\n\
         {depth} bounces of branches that weigh at least 1/255; the compiler is {}.\n\n{FILES}",
        profile::BOARD,
        machine.compiler
    )?;
    for profile in profiles {
        let (all, pixels) = (profile.instructions(), u64::from(width * height));
        writeln!(page, "\n### `{}`\n\n{all} instructions, {} a pixel.\n", profile.scene, all / pixels)?;
        page.push_str("| file | instructions | share | with `math/` | share |\n|---|--:|--:|--:|--:|\n");
        write_files(page, profile)?;
    }
    Ok(())
}

fn write_files(page: &mut String, profile: &Profile) -> std::fmt::Result {
    let all = profile.instructions() as f64;
    let mut others = [0, 0];
    let mut row = |name: &str, [own, with]: [u64; 2]| {
        let share = |count: u64| 100.0 * count as f64 / all;
        writeln!(page, "| {name} | {own} | {:.1} % | {with} | {:.1} % |", share(own), share(with))
    };
    for (name, [own, with]) in profile.files() {
        if (own.max(with) as f64) < all * LEAST_SHARE {
            others = [others[0] + own, others[1] + with];
        } else if name.ends_with(".rs") {
            row(&format!("[`{name}`](../src/{name})"), [own, with])?;
        } else {
            row(&name, [own, with])?;
        }
    }
    row("all others", others)
}
