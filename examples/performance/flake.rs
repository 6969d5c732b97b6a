//! Whole pictures of the flake, by POV-Ray and by whit.

use crate::aim::{Aim, Limit};
use crate::effort::{Effort, LONGEST_LIST};
use crate::picture::difference;
use crate::programs::{BUILDS, Programs, numbers};
use crate::rays::RayFiles;
use crate::rounds::Rounds;
use crate::section::Section;
use crate::{povray, povray_scene};

/// How many times as fast as POV-Ray, with the most spheres.
const AIM: Limit = Limit::AtLeast(5.0);
const PEER: &str = "POV-Ray";

/// How the spheres lie in memory, as the measured program calls it and as the page does.
pub const LAYOUTS: [(&str, &str); 3] =
    [("packed", "packed list"), ("boxes", "hierarchy"), ("packed-boxes", "hierarchy of packed")];

/// What is measured of a number of spheres: nanoseconds a ray, and how many rays.
struct Line<'a> {
    count: usize,
    rounds: Rounds<'a, 2>,
    /// How POV-Ray's picture differs from whit's.
    difference: Option<f64>,
}

pub fn measure(programs: &Programs, effort: &Effort) -> Result<Section, String> {
    let mut section = Section::new("The sphere-flake");
    section.line(&format!(
        "The sphere-flake of the Standard Procedural Databases: mirroring spheres on a plane under three lights, {0}×{0} pixels of \
         one sample, 5 reflections. Nanoseconds of processor time a ray, of whole pictures on one thread. The spheres are packed \
         by eights or objects of their own, in a list or in a hierarchy of boxes. POV-Ray computes in double precision.",
        effort.flake,
    ));
    let is_compared = povray::version().is_some();
    let lines = effort.flakes.iter().map(|&count| line(programs, effort, count, is_compared));
    let lines = lines.collect::<Result<Vec<_>, String>>()?;
    write(&mut section, &lines);
    match lines.last() {
        Some(largest) if is_compared => section.aims.push(aim(largest)),
        _ => section.lacks(PEER, "povray"),
    }
    Ok(section)
}

fn line<'a>(programs: &'a Programs, effort: &Effort, count: usize, is_compared: bool) -> Result<Line<'a>, String> {
    eprintln!("flake of {count}");
    let mut rounds = Rounds::new();
    let picture = programs.file("flake.ppm");
    for (build, ..) in BUILDS {
        for (layout, _) in LAYOUTS.into_iter().filter(|(layout, _)| *layout != "packed" || count <= LONGEST_LIST) {
            let arguments =
                ["render", "flake", &count.to_string(), layout, &effort.flake.to_string()].map(str::to_owned);
            let picture = picture.clone();
            rounds.add(format!("{build} {layout}"), move || {
                let [rays, time, _] = numbers(programs.measured(build).args(&arguments).arg(&picture))?;
                Ok([time / rays, rays])
            });
        }
    }
    let (scene, drawn) = (programs.file("flake.pov"), programs.file("flake-povray.ppm"));
    if is_compared {
        let spheres = RayFiles::write(programs, "flake", count, effort.flake)?.spheres()?;
        povray_scene::write(&scene, &spheres)?;
        let (drawn, size) = (drawn.clone(), effort.flake);
        rounds.add(PEER, move || povray::trace(&scene, &drawn, size).map(|(rays, time)| [time / rays, rays]));
    }
    rounds.run(effort.rounds)?;
    let difference = is_compared.then(|| difference(&picture, &drawn)).transpose()?;
    Ok(Line { count, rounds, difference })
}

fn write(section: &mut Section, lines: &[Line<'_>]) {
    let ours = || BUILDS.into_iter().flat_map(|build| LAYOUTS.map(|layout| (build, layout)));
    let titles: Vec<String> = ours().map(|((_, _, build), (_, layout))| format!("{layout}, {build}")).collect();
    let head = [&["spheres", "rays", PEER], titles.iter().map(String::as_str).collect::<Vec<_>>().as_slice()].concat();
    section.table(&head, &"r".repeat(head.len()));
    let cell = |number: f64| if number.is_nan() { "–".to_owned() } else { format!("{number:.0}") };
    for Line { count, rounds, .. } in lines {
        let names = ours().map(|((build, ..), (layout, _))| format!("{build} {layout}"));
        let times = std::iter::once(PEER.to_owned()).chain(names).map(|name| cell(rounds.of(&name, 0).median));
        let rays = rounds.of(rounds.fastest("any", 0), 1).median;
        section.row(&[count.to_string(), cell(rays)].into_iter().chain(times).collect::<Vec<_>>());
    }
    if lines.iter().all(|line| line.difference.is_none()) {
        return;
    }
    section.line(
        "How many times as fast as POV-Ray the fastest of these layouts is, and whether it is the same picture: POV-Ray's \
         rays by whit's, both as they count them, and the root of the mean square of the differences of the pictures' bytes.",
    );
    let [any, native] = BUILDS.map(|(_, _, title)| title);
    section.table(&["spheres", any, native, "rays", "difference of 255"], "rrrrr");
    for Line { count, rounds, difference } in lines {
        let ratios = BUILDS.map(|(build, ..)| rounds.ratio(PEER, rounds.fastest(build, 0), 0).to_string());
        let rays = format!("{:.3}", rounds.ratio(PEER, rounds.fastest("any", 0), 1).median);
        let [any, native] = ratios;
        section.row(&[count.to_string(), any, native, rays, difference.map_or(String::new(), |d| format!("{d:.2}"))]);
    }
}

fn aim(Line { count, rounds, .. }: &Line<'_>) -> Aim {
    let ratio = |build: &str| rounds.ratio(PEER, rounds.fastest(build, 0), 0);
    Aim {
        what: format!("a flake of {count}: POV-Ray's time a ray, by whit's"),
        limit: AIM,
        measured: BUILDS.map(|(build, _, title)| (title, ratio(build))).into(),
    }
}
