//! The same rays, one after another, by Embree and by whit.

use std::path::Path;
use std::process::Command;

use crate::agreement::{Agreement, NEAR, REACH};
use crate::aim::{Aim, Limit};
use crate::clock::run;
use crate::effort::{Effort, LONGEST_LIST};
use crate::flake::LAYOUTS;
use crate::programs::{BUILDS, Programs, numbers};
use crate::rays::RayFiles;
use crate::rounds::{Rounds, Spread};
use crate::section::Section;

/// Of Embree's time, with the most spheres.
const AIM: Limit = Limit::AtMost(1.5);
const PEER: &str = "Embree";
/// How many rays Embree takes at once.
const WIDTHS: [&str; 3] = ["1", "8", "16"];
/// What is measured of a number of spheres, in nanoseconds.
const KINDS: [&str; 3] = [
    "a ray that looks for the nearest surface",
    "a ray that looks for any surface before a light",
    "a sphere to build",
];
const BUILDING: usize = 2;

struct Line<'a> {
    count: usize,
    rounds: Rounds<'a, 3>,
    agreement: Agreement,
}

pub fn measure(programs: &Programs, effort: &Effort) -> Result<Section, String> {
    let mut section = Section::new("The same rays");
    let flags = ["-std=c++20", "-O3", "-march=native", "-lembree3"];
    let Some(embree) = programs.compile("embree", &["embree.cpp"], &flags)? else {
        section.lacks("Embree 3", "g++ libembree-dev");
        return Ok(section);
    };
    section.line(&format!(
        "The rays of the pictures above, by {} and by whit, in their order, from memory: nanoseconds of processor time a ray on one thread, of \
         searching alone. Embree takes them one by one, or in packets of 8 or 16, and picks the processor's instructions by \
         itself; the floor is a square of {} units for it. whit gives the point, its unit normal and a bound on its rounding \
         error besides the distance; Embree gives the distance and the direction of the normal.",
        version(&embree)?,
        2.0 * REACH
    ));
    let lines = effort.flakes.iter().map(|&count| line(programs, &embree, effort, count));
    let lines = lines.collect::<Result<Vec<_>, String>>()?;
    for (kind, title) in KINDS.iter().enumerate() {
        write(&mut section, &lines, kind, title);
    }
    write_agreement(&mut section, &lines);
    section.aims = lines.last().map(|largest| [0, 1].map(|kind| aim(largest, kind)).into()).unwrap_or_default();
    Ok(section)
}

/// The program tells it where it has nothing else to do.
fn version(embree: &Path) -> Result<String, String> {
    let (output, _) = run(&mut Command::new(embree))?;
    Ok(format!("{PEER} {}", String::from_utf8_lossy(&output.stdout).trim()))
}

fn line<'a>(programs: &'a Programs, embree: &Path, effort: &Effort, count: usize) -> Result<Line<'a>, String> {
    eprintln!("rays of a flake of {count}");
    let files = RayFiles::write(programs, "flake", count, effort.picture)?;
    let each = [files.closest, files.shadow, count].map(|number| number as f64);
    let by_each = move |[build, closest, shadow]: [f64; 3]| [closest / each[0], shadow / each[1], build / each[2]];
    let mut rounds = Rounds::new();
    for (build, ..) in BUILDS {
        for (layout, _) in LAYOUTS.into_iter().filter(|(layout, _)| *layout != "packed" || count <= LONGEST_LIST) {
            let (rays, answers, count) = (files.rays.clone(), programs.file("answers"), count.to_string());
            rounds.add(format!("{build} {layout}"), move || {
                let mut command = programs.measured(build);
                command.args(["replay", "flake", &count, layout]).args([&rays, &answers]);
                numbers(&mut command).map(by_each)
            });
        }
    }
    let answers = programs.file("answers-embree");
    for width in WIDTHS {
        let (program, rays, shapes, answers) = (embree.to_owned(), &files.rays, &files.shapes, &answers);
        let (rays, shapes, answers) = (rays.clone(), shapes.clone(), answers.clone());
        rounds.add(format!("{PEER} {width}"), move || {
            let mut command = Command::new(&program);
            command.arg("spheres").args([&shapes, &rays]).arg(width).arg(&answers);
            numbers(&mut command).map(by_each)
        });
    }
    rounds.run(effort.rounds)?;
    let agreement = Agreement::of(&files, &programs.file("answers"), &answers)?;
    Ok(Line { count, rounds, agreement })
}

fn write(section: &mut Section, lines: &[Line<'_>], kind: usize, title: &str) {
    section.line(&format!("Nanoseconds {title}:"));
    let peers = WIDTHS.map(|width| (format!("{PEER} {width}"), format!("{PEER}, by {width}")));
    let ours = BUILDS.into_iter().flat_map(|(build, _, of_build)| {
        LAYOUTS.map(|(layout, of_layout)| (format!("{build} {layout}"), format!("{of_layout}, {of_build}")))
    });
    let columns: Vec<(String, String)> = peers.into_iter().chain(ours).collect();
    // Not all that is built is as much.
    let compared = if kind == BUILDING { &[] } else { BUILDS.as_slice() };
    let ratios: Vec<String> = compared.iter().map(|(_, _, title)| format!("by {PEER}, {title}")).collect();
    let titles = columns.iter().map(|(_, title)| title).chain(&ratios).map(String::as_str);
    let head: Vec<&str> = std::iter::once("spheres").chain(titles).collect();
    section.table(&head, &"r".repeat(head.len()));
    for Line { count, rounds, .. } in lines {
        let times = columns.iter().map(|(name, _)| rounds.of(name, kind).median);
        let times = times.map(|time| if time.is_nan() { "–".to_owned() } else { format!("{time:.0}") });
        let ratios = compared.iter().map(|(build, ..)| ratio(rounds, build, kind).to_string());
        section.row(&std::iter::once(count.to_string()).chain(times).chain(ratios).collect::<Vec<_>>());
    }
}

/// The fastest of a build by the fastest of Embree.
fn ratio(rounds: &Rounds<'_, 3>, build: &str, kind: usize) -> Spread {
    rounds.ratio(rounds.fastest(build, kind), rounds.fastest(PEER, kind), kind)
}

fn write_agreement(section: &mut Section, lines: &[Line<'_>]) {
    section.line(&format!(
        "How many rays differ: their nearest surface is nearer or farther for Embree by more than a thousandth, or only one of both \
         finds any, or says that they do not get to the light. Left out are those that meet the floor outside Embree's square, or \
         something within {NEAR} of their origin, where Embree's begin: balls of the flake touch each other.",
    ));
    let head = ["spheres", "rays to the nearest", "outside", "within", "differ", "rays to lights", "differ"];
    section.table(&head, "rrrrrrr");
    for Line { count, agreement, .. } in lines {
        let &Agreement { closest, outside, nearer, closest_differ, shadow, shadow_differ } = agreement;
        let cells = [*count, closest, outside, nearer, closest_differ, shadow, shadow_differ];
        section.row(&cells.map(|number| number.to_string()));
    }
}

fn aim(Line { count, rounds, .. }: &Line<'_>, kind: usize) -> Aim {
    Aim {
        what: format!("a flake of {count}: time of {}, by Embree's", KINDS[kind]),
        limit: AIM,
        measured: BUILDS.map(|(build, _, title)| (title, ratio(rounds, build, kind))).into(),
    }
}
