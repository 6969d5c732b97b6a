//! Whole pictures of one scene, by POV-Ray and by whit.

use whit::Scene;

use crate::effort::Effort;
use crate::picture::difference;
use crate::programs::{BUILDS, Programs, numbers};
use crate::rounds::{Rounds, Spread};
use crate::section::Section;
use crate::{povray, povray_scene};

pub const PEER: &str = "POV-Ray";

/// A way in which objects lie in memory, as the measured program calls it and as the page does.
pub type Layout = (&'static str, &'static str);

/// A scene that all have drawn.
pub struct Contest<'a> {
    /// The first cells of its row.
    cells: Vec<String>,
    /// Nanoseconds a ray, and how many rays.
    rounds: Rounds<'a, 2>,
    /// How POV-Ray's picture differs from whit's; `None` where it did not take part.
    difference: Option<f64>,
}

impl<'a> Contest<'a> {
    /// Draws a scene in all layouts, which the measured program finds by these arguments. Its pictures are called `name`.
    pub fn run(
        programs: &'a Programs,
        effort: &Effort,
        (name, scene, arguments): (&str, &Scene<'_, f32>, &[&str]),
        layouts: &[Layout],
        cells: &[String],
    ) -> Result<Self, String> {
        eprintln!("{name}");
        let mut rounds = Rounds::new();
        let size = effort.picture;
        let [ours, theirs, file] = [".ppm", "-povray.ppm", ".pov"].map(|end| programs.file(&format!("{name}{end}")));
        for (build, ..) in BUILDS {
            for (layout, _) in layouts {
                let all: Vec<String> = arguments.iter().chain([layout]).map(|&word| word.to_owned()).collect();
                let picture = ours.clone();
                rounds.add(format!("{build} {layout}"), move || {
                    let mut command = programs.measured(build);
                    let [rays, time, _] = numbers(command.args(&all).arg(size.to_string()).arg(&picture))?;
                    Ok([time / rays, rays])
                });
            }
        }
        let is_compared = povray::version().is_some();
        if is_compared {
            povray_scene::write(&file, scene)?;
            let theirs = theirs.clone();
            rounds.add(PEER, move || povray::trace(&file, &theirs, size).map(|(rays, time)| [time / rays, rays]));
        }
        rounds.run(effort.rounds)?;
        let difference = is_compared.then(|| difference(&ours, &theirs)).transpose()?;
        Ok(Self { cells: cells.to_vec(), rounds, difference })
    }

    /// POV-Ray's time a ray by that of the fastest layout of a build.
    pub fn ratio(&self, build: &str) -> Spread {
        self.rounds.ratio(PEER, self.rounds.fastest(build, 0), 0)
    }

    pub const fn has_peer(&self) -> bool {
        self.difference.is_some()
    }
}

/// The tables; `columns` are the heads of the first cells.
pub fn write(section: &mut Section, columns: &[&str], layouts: &[Layout], contests: &[Contest<'_>]) {
    let ours = || BUILDS.into_iter().flat_map(|build| layouts.iter().map(move |layout| (build, *layout)));
    let titles: Vec<String> = ours().map(|((_, _, build), (_, layout))| format!("{layout}, {build}")).collect();
    let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
    table(section, &[columns, &["rays", PEER], &titles].concat());
    let cell = |number: f64| if number.is_nan() { "–".to_owned() } else { format!("{number:.0}") };
    for Contest { cells, rounds, .. } in contests {
        let names = ours().map(|((build, ..), (layout, _))| format!("{build} {layout}"));
        let times = std::iter::once(PEER.to_owned()).chain(names).map(|name| cell(rounds.of(&name, 0).median));
        let rays = cell(rounds.of(rounds.fastest("any", 0), 1).median);
        section.row(&cells.iter().cloned().chain([rays]).chain(times).collect::<Vec<_>>());
    }
    if !contests.iter().any(Contest::has_peer) {
        return section.lacks(PEER, "povray");
    }
    section.line(
        "How many times as fast as POV-Ray the fastest of these layouts is, and whether it is the same picture: POV-Ray's \
         rays by whit's, both as they count them, and the root of the mean square of the differences of the pictures' bytes.",
    );
    let builds = BUILDS.map(|(_, _, title)| title);
    table(section, &[&columns[..1], &builds, &["rays", "difference of 255"]].concat());
    for contest @ Contest { cells, rounds, difference } in contests {
        let [any, native] = BUILDS.map(|(build, ..)| contest.ratio(build).to_string());
        let rays = format!("{:.3}", rounds.ratio(PEER, rounds.fastest("any", 0), 1).median);
        section.row(&[cells[0].clone(), any, native, rays, difference.map_or(String::new(), |d| format!("{d:.2}"))]);
    }
}

fn table(section: &mut Section, columns: &[&str]) {
    section.table(columns, &"r".repeat(columns.len()));
}
