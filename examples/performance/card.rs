//! The scene of the business card, by the original program and by whit.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::aim::{Aim, Limit};
use crate::clock::run;
use crate::effort::Effort;
use crate::picture::difference;
use crate::programs::{BUILDS, Programs};
use crate::rounds::Rounds;
use crate::section::Section;

/// Of the original's time, compiled in the faster way.
const AIM: Limit = Limit::AtMost(0.12);
/// How the original is compiled.
const FLAGS: [(&str, &[&str]); 2] = [("plain", &["-O2"]), ("fast", &["-O3", "-march=native", "-ffast-math"])];
const SAMPLES: u32 = 64;

pub fn measure(programs: &Programs, effort: &Effort) -> Result<Section, String> {
    let mut section = Section::new("The business card");
    let Some([plain, fast, seeded]) = compile(programs, effort)? else {
        section.lacks("g++", "g++");
        return Ok(section);
    };
    let mut rounds = Rounds::new();
    rounds.add("plain", || draw(&plain, &picture(programs, "plain")));
    rounds.add("fast", || draw(&fast, &picture(programs, "fast")));
    for (build, ..) in BUILDS {
        let sizes = [effort.card, SAMPLES].map(|number| number.to_string());
        rounds.add(build, move || {
            let picture = picture(programs, build);
            Ok([run(programs.measured(build).arg("card").args(&sizes).arg(picture))?.1])
        });
    }
    rounds.run(effort.rounds)?;
    draw(&seeded, &picture(programs, "seeded"))?;
    write(&mut section, programs, effort, &rounds)?;
    Ok(section)
}

fn picture(programs: &Programs, name: &str) -> PathBuf {
    programs.file(&format!("card-{name}.ppm"))
}

/// Runs an original.
fn draw(program: &Path, picture: &Path) -> Result<[f64; 1], String> {
    let (output, time) = run(&mut Command::new(program))?;
    fs::write(picture, output.stdout).map_err(|error| format!("{}: {error}", picture.display()))?;
    Ok([time])
}

/// The original in both ways, and once more with other random numbers.
fn compile(programs: &Programs, effort: &Effort) -> Result<Option<[PathBuf; 3]>, String> {
    let (size, samples) = (format!("-DSIZE={}", effort.card), format!("-DSAMPLES={SAMPLES}"));
    let compile = |name: &str, sources: &[&str], flags: &[&str]| {
        programs.compile(&format!("card-{name}"), sources, &[flags, &[&size, &samples]].concat())
    };
    let [(_, plain), (_, fast)] = FLAGS;
    let all = [
        compile("plain", &["card.cpp"], plain)?,
        compile("fast", &["card.cpp"], fast)?,
        compile("seeded", &["card.cpp", "seed.cpp"], plain)?,
    ];
    Ok(match all {
        [Some(plain), Some(fast), Some(seeded)] => Some([plain, fast, seeded]),
        _ => None,
    })
}

fn write(section: &mut Section, programs: &Programs, effort: &Effort, rounds: &Rounds<'_, 1>) -> Result<(), String> {
    section.line(&format!(
        "The scene of Andrew Kensler's ray tracer on a business card, {0}×{0} pixels of {SAMPLES} samples. Whole programs, from \
         their start to the picture in a file; [`card.cpp`](../examples/performance/card.cpp) is the original, written out.",
        effort.card
    ));
    let command = |flags: &[&str]| format!("`g++ {}`", flags.join(" "));
    let [by_plain, by_fast] = FLAGS.map(|(_, flags)| format!("by {}", command(flags)));
    section.table(&["program", "CPU seconds", &by_plain, &by_fast], "lrrr");
    let originals = FLAGS.map(|(name, flags)| (name, format!("original, {}", command(flags))));
    let ours = BUILDS.map(|(name, _, title)| (name, format!("whit, {title}")));
    for (name, title) in originals.into_iter().chain(ours) {
        let seconds = format!("{:.2}", rounds.of(name, 0).median / 1e9);
        let ratios = FLAGS.map(|(original, _)| match original == name {
            true => "1".to_owned(),
            false => rounds.ratio(name, original, 0).to_string(),
        });
        section.row(&[&[title, seconds], ratios.as_slice()].concat());
    }
    let from_original = |name: &str| difference(&picture(programs, "plain"), &picture(programs, name));
    let [any, native] = BUILDS.map(|(build, ..)| from_original(build));
    section.line(&format!(
        "Bytes of whit's picture differ from those of the original's by {:.2} of 255, the root of the mean square ({:.2} with \
         {}). Those of two pictures by the original itself, whose random numbers start from different seeds, differ by {:.2}.",
        any?,
        native?,
        BUILDS[1].2,
        from_original("seeded")?
    ));
    section.aims.push(Aim {
        what: format!("the business card: time, by that of the original with {}", command(FLAGS[1].1)),
        limit: AIM,
        measured: BUILDS.map(|(build, _, title)| (title, rounds.ratio(build, "fast", 0))).into(),
    });
    Ok(())
}
